#pragma once

#include <OgreDataStream.h>

#include <string>

namespace lodsmith::cli {

/// A file in memory that refuses to be read beyond its end. OGRE does not look at how much a read returned: from a file
/// that was cut off it would take uninitialised memory for vertices.
class CheckedStream : public Ogre::MemoryDataStream {
public:
    CheckedStream(const Ogre::String& name, const std::string& bytes);

    /// Throws Ogre::Exception when fewer bytes are left, except at the very end, where OGRE looks for further chunks:
    /// there it fills up to six bytes (a chunk's header) with zeros and returns 0.
    size_t read(void* buffer, size_t count) override;

    /// The text up to the next line break, which is skipped. Throws Ogre::Exception when there is none.
    Ogre::String getLine(bool trimAfter) override;
};

/// A stream that collects what is written to it.
class CollectingStream : public Ogre::DataStream {
public:
    CollectingStream() : DataStream(WRITE) {}

    const std::string& bytes() const { return mBytes; }

    size_t read(void*, size_t) override { return 0; }
    size_t write(const void* buffer, size_t count) override;
    void skip(long count) override { mPosition += static_cast<size_t>(count); }
    void seek(size_t position) override { mPosition = position; }
    size_t tell() const override { return mPosition; }
    bool eof() const override { return mPosition >= mBytes.size(); }
    void close() override {}

private:
    std::string mBytes;
    size_t mPosition = 0;
};

} // namespace lodsmith::cli
