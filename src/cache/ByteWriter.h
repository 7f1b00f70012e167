#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

namespace lodsmith {

/// Appends numbers to a string of bytes: little-endian, whatever the machine.
class ByteWriter {
public:
    explicit ByteWriter(std::string& out) : mOut(out) {}

    template <class Unsigned>
    void fixed(Unsigned value)
    {
        for (std::size_t i = 0; i < sizeof value; ++i)
            mOut.push_back(static_cast<char>(static_cast<unsigned char>(value >> (8 * i))));
    }

    void real(double value)
    {
        std::uint64_t bits;
        std::memcpy(&bits, &value, sizeof bits);
        fixed(bits);
    }

    /// Seven bits a byte, the lowest first; the top bit says that more follow. At most five bytes.
    void varint(std::uint32_t value)
    {
        for (; value >= 0x80; value >>= 7)
            mOut.push_back(static_cast<char>(static_cast<unsigned char>(value | 0x80)));
        mOut.push_back(static_cast<char>(static_cast<unsigned char>(value)));
    }

private:
    std::string& mOut;
};

} // namespace lodsmith
