#pragma once

#include <lodsmith/core/Export.h>

#include <OgreDataStream.h>

#include <string>

namespace lodsmith {

/// A file in memory that refuses to be read beyond its end. OGRE does not look at how much a read returned: from a file
/// that was cut off it would take uninitialised memory for vertices.
class LODSMITH_API CheckedStream : public Ogre::MemoryDataStream {
public:
    CheckedStream(const Ogre::String& name, const std::string& bytes);

    /// Throws Ogre::Exception when fewer bytes are left, except at the very end, where OGRE looks for further chunks:
    /// there it fills the two bytes of a chunk's number, and then the four of its length, with zeros and returns 0.
    size_t read(void* buffer, size_t count) override;

    /// The text up to the next line break, which is skipped. Throws Ogre::Exception when there is none.
    Ogre::String getLine(bool trimAfter) override;

private:
    bool mLooksForChunk = false; ///< a number was read at the end
};

} // namespace lodsmith
