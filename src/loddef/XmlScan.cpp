#include "XmlScan.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <iterator>

namespace lodsmith {

namespace {

constexpr std::string_view kEntities[] = {"amp", "lt", "gt", "quot", "apos"};
constexpr std::size_t kLongestReference = 12;
// TinyXML-2 compares each attribute of an element with all others.
constexpr int kMostAttributes = 100;

bool isXmlCharacter(std::uint32_t character)
{
    if (character < 0x20)
        return character == '\t' || character == '\n' || character == '\r';
    return character <= 0x10ffff && !(character >= 0xd800 && character <= 0xdfff) && character != 0xfffe
           && character != 0xffff;
}

/// Bytes of the UTF-8 sequence that a byte begins; 0 for one that begins none.
std::size_t sequenceLength(unsigned char lead)
{
    if (lead < 0x80)
        return 1;
    if (lead >= 0xc2 && lead < 0xe0)
        return 2;
    if (lead >= 0xe0 && lead < 0xf0)
        return 3;
    return lead >= 0xf0 && lead < 0xf5 ? 4 : 0;
}

/// Bytes of the character at the front of a text, 0 when it is none that XML allows.
std::size_t characterLength(std::string_view text)
{
    static constexpr std::uint32_t kSmallest[] = {0, 0, 0x80, 0x800, 0x10000};
    const auto lead = static_cast<unsigned char>(text[0]);
    const std::size_t length = sequenceLength(lead);
    if (length == 0 || length > text.size())
        return 0;
    std::uint32_t character = length == 1 ? lead : lead & (0x7fu >> length);
    for (std::size_t i = 1; i < length; ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        if ((byte & 0xc0) != 0x80)
            return 0;
        character = character << 6 | (byte & 0x3fu);
    }
    return character >= kSmallest[length] && isXmlCharacter(character) ? length : 0;
}

std::size_t findBadCharacter(std::string_view text)
{
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t length = characterLength(text.substr(i));
        if (length == 0)
            return i;
        i += length;
    }
    return std::string_view::npos;
}

Error errorAt(std::string_view text, std::size_t position, std::string message)
{
    Error error{ErrorCode::BadFile, std::move(message)};
    error.line = 1 + static_cast<int>(std::count(text.begin(), text.begin() + position, '\n'));
    return error;
}

/// The number in "#65" or "#x41".
std::optional<std::uint32_t> characterNumber(std::string_view name)
{
    const bool hexadecimal = name.size() > 1 && name[1] == 'x';
    const std::string_view digits = name.substr(hexadecimal ? 2 : 1);
    std::uint32_t number = 0;
    const char* end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, number, hexadecimal ? 16 : 10);
    return error == std::errc() && stop == end ? std::optional(number) : std::nullopt;
}

/// A walk over the markup, as shallow as can be: what is no comment, CDATA section or instruction is text or a tag, and in
/// text and in values a reference is a reference.
class MarkupScan {
public:
    explicit MarkupScan(std::string_view text) : mText(text) {}

    std::optional<Error> run()
    {
        for (; mPosition < mText.size(); ++mPosition) {
            if (auto error = mInTag ? stepInTag() : stepInText())
                return error;
        }
        return std::nullopt;
    }

private:
    std::optional<Error> stepInText()
    {
        if (skip("<!--", "-->") || skip("<![CDATA[", "]]>") || skip("<?", "?>"))
            return std::nullopt;
        if (startsWith("<!"))
            return failure("'<!' begins no element; a document type and its entities are not allowed");
        if (mText[mPosition] == '&')
            return checkReference();
        mInTag = mText[mPosition] == '<';
        mAttributes = 0;
        return std::nullopt;
    }

    std::optional<Error> stepInTag()
    {
        const char character = mText[mPosition];
        if (mQuote != 0) {
            if (character == '<')
                return failure("'<' is not allowed within quotes; it is written &lt;");
            if (character == '&')
                return checkReference();
            if (character == mQuote)
                mQuote = 0;
        } else if (character == '"' || character == '\'') {
            mQuote = character;
            if (++mAttributes > kMostAttributes)
                return failure("an element has more attributes than are allowed: " + std::to_string(kMostAttributes));
        } else if (character == '>') {
            mInTag = false;
        }
        return std::nullopt;
    }

    std::optional<Error> checkReference() const
    {
        const std::string_view rest = mText.substr(mPosition + 1, kLongestReference);
        const std::size_t end = rest.find(';');
        const std::string_view name = rest.substr(0, end == std::string_view::npos ? 0 : end);
        if (!name.empty() && name[0] == '#') {
            const std::optional<std::uint32_t> number = characterNumber(name);
            if (number && *number > ' ' && isXmlCharacter(*number))
                return std::nullopt;
            return failure("'&" + std::string(name)
                           + ";' is no character above the blank; blanks are written as they are");
        }
        if (std::find(std::begin(kEntities), std::end(kEntities), name) != std::end(kEntities))
            return std::nullopt;
        return failure("'&' begins no reference; allowed are &amp; &lt; &gt; &quot; &apos; and numbers as in &#233;");
    }

    bool startsWith(std::string_view word) const { return mText.compare(mPosition, word.size(), word) == 0; }

    /// Leaves the position on the last character of what is skipped.
    bool skip(std::string_view opening, std::string_view closing)
    {
        if (!startsWith(opening))
            return false;
        const std::size_t end = mText.find(closing, mPosition + opening.size());
        mPosition = (end == std::string_view::npos ? mText.size() : end + closing.size()) - 1;
        return true;
    }

    Error failure(std::string message) const { return errorAt(mText, mPosition, std::move(message)); }

    std::string_view mText;
    std::size_t mPosition = 0;
    bool mInTag = false;
    int mAttributes = 0; ///< so far, in this tag
    char mQuote = 0;     ///< the one that the value ends with, 0 outside values
};

} // namespace

bool isXmlText(std::string_view text)
{
    return findBadCharacter(text) == std::string_view::npos;
}

std::optional<Error> findForbiddenXml(std::string_view text)
{
    const std::size_t bad = findBadCharacter(text);
    if (bad != std::string_view::npos)
        return errorAt(text, bad,
                       "the byte " + std::to_string(static_cast<unsigned char>(text[bad]))
                           + " begins no character that XML allows; allowed is UTF-8 without control characters");
    return MarkupScan(text).run();
}

} // namespace lodsmith
