#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

namespace lodsmith {

/// A whole text as a finite decimal number of type T, whatever the locale. Nothing else passes: no blanks, no leading
/// plus, nothing behind the number, nothing beyond the range of T.
template <class T>
std::optional<T> plainNumberFromText(std::string_view text)
{
    T number{};
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc() || stop != end || !std::isfinite(static_cast<double>(number)))
        return std::nullopt;
    return number;
}

/// The same with a leading plus, which passes in XML Schema.
template <class T>
std::optional<T> numberFromText(std::string_view text)
{
    if (text.size() > 1 && text[0] == '+' && text[1] != '-')
        text.remove_prefix(1);
    return plainNumberFromText<T>(text);
}

/// The shortest text that is read as the same number again, whatever the locale; without an exponent where people
/// would write none.
template <class T>
std::string textFromNumber(T number)
{
    const double size = std::abs(static_cast<double>(number));
    const bool plain = number == T(0) || (size >= 1e-4 && size < 1e9);
    char text[64];
    const auto [end, error] = plain ? std::to_chars(text, text + sizeof text, number, std::chars_format::fixed)
                                    : std::to_chars(text, text + sizeof text, number);
    return {text, end};
}

} // namespace lodsmith
