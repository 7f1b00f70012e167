#pragma once

#include <string>
#include <string_view>

namespace lodsmith::cli {

/// A text for HTML, inside an element or a quoted attribute: markup is escaped; bytes that are no UTF-8 and control
/// characters, but for line break and tabulator, become replacement characters.
std::string escaped(std::string_view text);

/// A name from outside as an element whose direction of writing does not reach beyond it.
std::string nameElement(std::string_view name);

/// Bytes in base64 (RFC 4648, section 4).
std::string base64(std::string_view bytes);

/// Back again, from what base64() has made.
std::string fromBase64(std::string_view text);

/// The address of a PNG picture that is part of the page.
/// @param png its bytes in base64
std::string pngAddress(std::string_view png);

} // namespace lodsmith::cli
