#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace lodsmith {

/// Takes apart what ByteWriter wrote. Whatever is wrong makes it fail for good, after which it gives zeros. It takes only what
/// ByteWriter would have written: no number has two forms.
class ByteReader {
public:
    explicit ByteReader(std::string_view bytes) : mLeft(bytes) {}

    /// True when nothing was wrong and nothing is left.
    bool finished() const { return !mFailed && mLeft.empty(); }
    bool failed() const { return mFailed; }

    template <class Unsigned>
    Unsigned fixed()
    {
        if (mLeft.size() < sizeof(Unsigned))
            return fail();
        Unsigned value = 0;
        for (std::size_t i = 0; i < sizeof value; ++i)
            value = static_cast<Unsigned>(value | static_cast<Unsigned>(Unsigned{byteAt(i)} << (8 * i)));
        mLeft.remove_prefix(sizeof value);
        return value;
    }

    double real()
    {
        const auto bits = fixed<std::uint64_t>();
        double value;
        std::memcpy(&value, &bits, sizeof value);
        return value;
    }

    std::uint32_t varint()
    {
        std::uint64_t value = 0;
        for (std::size_t i = 0; i < 5 && i < mLeft.size(); ++i) {
            const std::uint8_t byte = byteAt(i);
            value |= std::uint64_t{byte & 0x7fu} << (7 * i);
            if (byte & 0x80)
                continue;
            if (value > 0xffffffff || (byte == 0 && i > 0))
                break;
            mLeft.remove_prefix(i + 1);
            return static_cast<std::uint32_t>(value);
        }
        return fail();
    }

    /// A number up to `largest`.
    std::uint8_t choice(std::uint8_t largest)
    {
        const auto value = fixed<std::uint8_t>();
        return value <= largest ? value : fail();
    }

    /// The number of things to come, each of at least `bytesEach`: fails when there are not bytes enough for so many, so that
    /// memory can be asked for without fear.
    std::uint32_t count(std::size_t bytesEach)
    {
        const auto value = fixed<std::uint32_t>();
        return value <= mLeft.size() / bytesEach ? value : fail();
    }

private:
    std::uint8_t byteAt(std::size_t i) const { return static_cast<std::uint8_t>(mLeft[i]); }

    std::uint8_t fail()
    {
        mFailed = true;
        mLeft = {};
        return 0;
    }

    std::string_view mLeft;
    bool mFailed = false;
};

} // namespace lodsmith
