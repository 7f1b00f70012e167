#include "CheckedStream.h"

#include <OgreException.h>
#include <OgreString.h>

#include <algorithm>
#include <cstring>

namespace lodsmith {

namespace {

// The two reads of a chunk's header.
constexpr size_t kChunkIdBytes = 2;
constexpr size_t kChunkLengthBytes = 4;

} // namespace

CheckedStream::CheckedStream(const Ogre::String& name, const std::string& bytes)
    : MemoryDataStream(name, bytes.size(), true)
{
    std::memcpy(getPtr(), bytes.data(), bytes.size());
}

size_t CheckedStream::read(void* buffer, size_t count)
{
    const size_t left = static_cast<size_t>(mEnd - mPos);
    if (count <= left)
        return MemoryDataStream::read(buffer, count);
    const bool looksForChunk = left == 0 && count == (mLooksForChunk ? kChunkLengthBytes : kChunkIdBytes);
    if (!looksForChunk)
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                    "the file is cut off or damaged: " + std::to_string(count) + " bytes are wanted at byte "
                        + std::to_string(tell()) + ", and " + std::to_string(left) + " are left",
                    "CheckedStream::read");
    mLooksForChunk = !mLooksForChunk;
    std::memset(buffer, 0, count);
    return 0;
}

Ogre::String CheckedStream::getLine(bool trimAfter)
{
    const Ogre::uchar* begin = mPos;
    const Ogre::uchar* end = std::find(mPos, mEnd, Ogre::uchar('\n'));
    if (end == mEnd)
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALIDPARAMS,
                    "the file is cut off or damaged: the text at byte " + std::to_string(tell()) + " does not end",
                    "CheckedStream::getLine");
    Ogre::String line(begin, end);
    mPos += line.size() + 1;
    if (!line.empty() && line.back() == '\r')
        line.pop_back();
    if (trimAfter)
        Ogre::StringUtil::trim(line);
    return line;
}

} // namespace lodsmith
