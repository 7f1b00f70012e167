#include "MeshStreams.h"

#include <cstring>

namespace lodsmith::cli {

size_t CollectingStream::write(const void* buffer, size_t count)
{
    if (mPosition + count > mBytes.size())
        mBytes.resize(mPosition + count);
    std::memcpy(&mBytes[mPosition], buffer, count);
    mPosition += count;
    mSize = mBytes.size();
    return count;
}

} // namespace lodsmith::cli
