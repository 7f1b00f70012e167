#pragma once

#include <cstdint>
#include <string>

namespace lodsmith::cli {

// Numbers as a page shows them, in HTML: no markup, narrow no-break spaces between groups of three digits, a minus sign
// that is one. What is not finite becomes a dash.

/// A whole number: "12 345".
std::string wholeNumber(double number);

/// About three significant digits without an exponent where that reads well: "0.0123", "12 300"; else "1.2e-7".
std::string shortNumber(double number);

/// A share as a percentage of at most three significant digits: "0.35 %" for 0.0035.
std::string percentage(double share);

/// Bytes with a unit of 1000: "512 B", "1.2 MB".
std::string byteCount(double bytes);

/// For the labels of an axis: "0.001", "10", "10 k", "1 M", "1e-6".
std::string tickLabel(double number);

/// A coordinate of an SVG: at most two decimals, no exponent.
std::string coordinate(double number);

} // namespace lodsmith::cli
