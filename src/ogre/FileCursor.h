#pragma once

#include <lodsmith/core/Result.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace lodsmith {

/// Goes through the bytes of a file in memory, never beyond their end. After a failure everything reads as zero and
/// nothing moves, so that it is enough to look at ok() in loops and at the end.
class FileCursor {
public:
    /// Number and length.
    static constexpr std::size_t kChunkHeaderBytes = 6;

    FileCursor(std::string_view bytes, bool bigEndian) : mBytes(bytes), mBigEndian(bigEndian) {}

    bool ok() const { return !mError; }
    /// BadFile, without a file; only when not ok().
    const Error& error() const { return *mError; }

    std::size_t place() const { return mPlace; }
    std::size_t left() const { return mBytes.size() - mPlace; }

    /// An unsigned number of `count` bytes, 1..4.
    std::uint32_t integer(unsigned count);
    /// The text up to the next line break, which is skipped.
    std::string text();
    void skip(std::uint64_t count);
    /// Fails at the present place: `message` ends the sentence "byte N: ".
    void fail(const std::string& message);

    /// The number of the chunk that begins here, 0 where no further one fits.
    std::uint32_t chunkAhead() const;
    /// Its length as stated, from its beginning. A chunk must be ahead.
    std::uint32_t lengthAhead() const;
    /// Skips number and length of a chunk, which must be of this number.
    void enter(std::uint32_t chunk);

private:
    bool has(std::uint64_t count);
    std::uint32_t numberAt(std::size_t place, unsigned count) const;

    std::string_view mBytes;
    bool mBigEndian;
    std::size_t mPlace = 0;
    std::optional<Error> mError;
};

} // namespace lodsmith
