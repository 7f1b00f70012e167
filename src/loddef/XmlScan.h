#pragma once

#include <lodsmith/core/Result.h>

#include <optional>
#include <string_view>

namespace lodsmith {

/// Whether a text is well-formed UTF-8 and made of characters that XML 1.0 allows.
bool isXmlText(std::string_view text);

/// Finds what TinyXML-2 takes without a word, and what must not get through: bytes that are no UTF-8, control characters
/// (a zero would end the document), document type declarations, entities other than XML's own five, and references to
/// characters that are not allowed or that would be lost as white space. Nor may an element have more than a hundred attributes. Error: BadFile with the line.
std::optional<Error> findForbiddenXml(std::string_view text);

} // namespace lodsmith
