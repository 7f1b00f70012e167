#include "FileCursor.h"

namespace lodsmith {

std::uint32_t FileCursor::integer(unsigned count)
{
    if (!has(count))
        return 0;
    const std::uint32_t number = numberAt(mPlace, count);
    mPlace += count;
    return number;
}

std::string FileCursor::text()
{
    if (!ok())
        return {};
    const std::size_t end = mBytes.find('\n', mPlace);
    if (end == std::string_view::npos) {
        fail("a text does not end");
        return {};
    }
    std::string text(mBytes.substr(mPlace, end - mPlace));
    mPlace = end + 1;
    if (!text.empty() && text.back() == '\r')
        text.pop_back();
    return text;
}

void FileCursor::skip(std::uint64_t count)
{
    if (has(count))
        mPlace += static_cast<std::size_t>(count);
}

void FileCursor::fail(const std::string& message)
{
    if (ok())
        mError = Error{ErrorCode::BadFile, "is cut off or damaged at byte " + std::to_string(mPlace) + ": " + message};
}

std::uint32_t FileCursor::chunkAhead() const
{
    return ok() && left() >= kChunkHeaderBytes ? numberAt(mPlace, 2) : 0;
}

std::uint32_t FileCursor::lengthAhead() const
{
    return numberAt(mPlace + 2, 4);
}

void FileCursor::enter(std::uint32_t chunk)
{
    if (chunkAhead() == chunk)
        mPlace += kChunkHeaderBytes;
    else
        fail("another part is expected");
}

bool FileCursor::has(std::uint64_t count)
{
    if (ok() && count > left())
        fail(std::to_string(count) + " bytes are expected, and " + std::to_string(left()) + " are left");
    return ok();
}

std::uint32_t FileCursor::numberAt(std::size_t place, unsigned count) const
{
    std::uint32_t number = 0;
    for (unsigned i = 0; i < count; ++i)
        number = number << 8 | static_cast<unsigned char>(mBytes[place + (mBigEndian ? i : count - 1 - i)]);
    return number;
}

} // namespace lodsmith
