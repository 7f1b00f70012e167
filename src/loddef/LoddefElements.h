#pragma once

#include <tinyxml2.h>

#include <string>

namespace lodsmith {

/// The text that stands directly in an element, comments left out, without the blanks around it.
std::string textIn(const tinyxml2::XMLElement& element);

/// A text without the blanks around it.
std::string trimmed(const std::string& text);

/// An element with all that is in it, as a file shows it.
std::string printed(const tinyxml2::XMLElement& element);

} // namespace lodsmith
