#include "LoddefElements.h"

namespace lodsmith {

std::string trimmed(const std::string& text)
{
    constexpr const char* kBlanks = " \t\r\n";
    const std::size_t begin = text.find_first_not_of(kBlanks);
    return begin == std::string::npos ? std::string() : text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
}

std::string textIn(const tinyxml2::XMLElement& element)
{
    std::string text;
    for (const tinyxml2::XMLNode* node = element.FirstChild(); node; node = node->NextSibling())
        if (const tinyxml2::XMLText* part = node->ToText())
            text += part->Value();
    return trimmed(text);
}

std::string printed(const tinyxml2::XMLElement& element)
{
    tinyxml2::XMLPrinter printer;
    element.Accept(&printer);
    return printer.CStr();
}

} // namespace lodsmith
