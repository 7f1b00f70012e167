#pragma once

#include <OgreDataStream.h>

#include <string>

namespace lodsmith::cli {

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
