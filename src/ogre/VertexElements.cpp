#include "VertexElements.h"

#include "OgreVersion.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

namespace lodsmith {

namespace {

enum class Scalar { Float, Double, Byte, UnsignedByte, Short, UnsignedShort, Int, UnsignedInt, Argb, Abgr };

struct ElementFormat {
    Scalar scalar = Scalar::Float;
    int components = 0;
    bool normalised = false;
};

ElementFormat formatOf(Ogre::VertexElementType type)
{
    switch (type) {
    case Ogre::VET_FLOAT1: return {Scalar::Float, 1, false};
    case Ogre::VET_FLOAT2: return {Scalar::Float, 2, false};
    case Ogre::VET_FLOAT3: return {Scalar::Float, 3, false};
    case Ogre::VET_FLOAT4: return {Scalar::Float, 4, false};
    case Ogre::VET_DOUBLE1: return {Scalar::Double, 1, false};
    case Ogre::VET_DOUBLE2: return {Scalar::Double, 2, false};
    case Ogre::VET_DOUBLE3: return {Scalar::Double, 3, false};
    case Ogre::VET_DOUBLE4: return {Scalar::Double, 4, false};
    case Ogre::VET_SHORT1: return {Scalar::Short, 1, false};
    case Ogre::VET_SHORT2: return {Scalar::Short, 2, false};
    case Ogre::VET_SHORT3: return {Scalar::Short, 3, false};
    case Ogre::VET_SHORT4: return {Scalar::Short, 4, false};
    case Ogre::VET_USHORT1: return {Scalar::UnsignedShort, 1, false};
    case Ogre::VET_USHORT2: return {Scalar::UnsignedShort, 2, false};
    case Ogre::VET_USHORT3: return {Scalar::UnsignedShort, 3, false};
    case Ogre::VET_USHORT4: return {Scalar::UnsignedShort, 4, false};
    case Ogre::VET_INT1: return {Scalar::Int, 1, false};
    case Ogre::VET_INT2: return {Scalar::Int, 2, false};
    case Ogre::VET_INT3: return {Scalar::Int, 3, false};
    case Ogre::VET_INT4: return {Scalar::Int, 4, false};
    case Ogre::VET_UINT1: return {Scalar::UnsignedInt, 1, false};
    case Ogre::VET_UINT2: return {Scalar::UnsignedInt, 2, false};
    case Ogre::VET_UINT3: return {Scalar::UnsignedInt, 3, false};
    case Ogre::VET_UINT4: return {Scalar::UnsignedInt, 4, false};
    case Ogre::VET_BYTE4: return {Scalar::Byte, 4, false};
    case Ogre::VET_UBYTE4: return {Scalar::UnsignedByte, 4, false};
    case Ogre::VET_BYTE4_NORM: return {Scalar::Byte, 4, true};
    case Ogre::VET_UBYTE4_NORM: return {Scalar::UnsignedByte, 4, true};
    case Ogre::VET_SHORT2_NORM: return {Scalar::Short, 2, true};
    case Ogre::VET_SHORT4_NORM: return {Scalar::Short, 4, true};
    case Ogre::VET_USHORT2_NORM: return {Scalar::UnsignedShort, 2, true};
    case Ogre::VET_USHORT4_NORM: return {Scalar::UnsignedShort, 4, true};
    default: break;
    }
    switch (packedColour(type)) {
    case PackedColour::Argb: return {Scalar::Argb, 4, true};
    case PackedColour::Abgr: return {Scalar::Abgr, 4, true};
    case PackedColour::None: break;
    }
    return {};
}

using Tuple = std::array<float, 4>;

template <class T>
float toFloat(T value, bool normalised)
{
    if constexpr (std::is_integral_v<T>) {
        // The lowest signed value would come out a little below -1.
        if (normalised)
            return std::max(static_cast<float>(value) / static_cast<float>(std::numeric_limits<T>::max()), -1.0f);
    }
    return static_cast<float>(value);
}

template <class T>
Tuple readNumbers(const unsigned char* from, const ElementFormat& format)
{
    T values[4];
    std::memcpy(values, from, sizeof(T) * static_cast<std::size_t>(format.components));
    Tuple tuple = {0.0f, 0.0f, 0.0f, 1.0f};
    for (int i = 0; i < format.components; ++i)
        tuple[static_cast<std::size_t>(i)] = toFloat(values[i], format.normalised);
    return tuple;
}

/// Shifts of red, green, blue and alpha in a colour packed into 32 bits of the machine's byte order.
template <int Red, int Blue>
Tuple readPacked(const unsigned char* from, const ElementFormat&)
{
    std::uint32_t packed;
    std::memcpy(&packed, from, sizeof packed);
    const auto channel = [packed](int shift) { return static_cast<float>((packed >> shift) & 0xFFu) / 255.0f; };
    return {channel(Red), channel(8), channel(Blue), channel(24)};
}

using TupleReader = Tuple (*)(const unsigned char*, const ElementFormat&);

template <TupleReader Read>
void copyTuples(const ElementSource& source, const ElementFormat& format, std::size_t count, int components, float* out)
{
    const unsigned char* from = source.data;
    for (std::size_t i = 0; i < count; ++i, from += source.stride, out += components) {
        const Tuple tuple = Read(from, format);
        std::memcpy(out, tuple.data(), sizeof(float) * static_cast<std::size_t>(components));
    }
}

/// Floats that need no conversion; the size is known to the compiler, so that each copy is a few moves.
template <int Components>
void copyFloats(const ElementSource& source, std::size_t count, float* out)
{
    constexpr std::size_t kBytes = sizeof(float) * Components;
    if (source.stride == kBytes) {
        std::memcpy(out, source.data, kBytes * count);
        return;
    }
    const unsigned char* from = source.data;
    for (std::size_t i = 0; i < count; ++i, from += source.stride, out += Components)
        std::memcpy(out, from, kBytes);
}

void copyFloats(const ElementSource& source, std::size_t count, int components, float* out)
{
    switch (components) {
    case 1: return copyFloats<1>(source, count, out);
    case 2: return copyFloats<2>(source, count, out);
    case 3: return copyFloats<3>(source, count, out);
    default: return copyFloats<4>(source, count, out);
    }
}

void copyFormat(const ElementSource& source, const ElementFormat& format, std::size_t count, int components, float* out)
{
    switch (format.scalar) {
    case Scalar::Float:
        if (format.components >= components)
            return copyFloats(source, count, components, out);
        return copyTuples<readNumbers<float>>(source, format, count, components, out);
    case Scalar::Double: return copyTuples<readNumbers<double>>(source, format, count, components, out);
    case Scalar::Byte: return copyTuples<readNumbers<std::int8_t>>(source, format, count, components, out);
    case Scalar::UnsignedByte: return copyTuples<readNumbers<std::uint8_t>>(source, format, count, components, out);
    case Scalar::Short: return copyTuples<readNumbers<std::int16_t>>(source, format, count, components, out);
    case Scalar::UnsignedShort: return copyTuples<readNumbers<std::uint16_t>>(source, format, count, components, out);
    case Scalar::Int: return copyTuples<readNumbers<std::int32_t>>(source, format, count, components, out);
    case Scalar::UnsignedInt: return copyTuples<readNumbers<std::uint32_t>>(source, format, count, components, out);
    case Scalar::Argb: return copyTuples<readPacked<16, 0>>(source, format, count, components, out);
    case Scalar::Abgr: return copyTuples<readPacked<0, 16>>(source, format, count, components, out);
    }
}

} // namespace

int componentCount(Ogre::VertexElementType type)
{
    return formatOf(type).components;
}

void copyElement(const ElementSource& source, std::size_t count, int components, float* out)
{
    copyFormat(source, formatOf(source.type), count, components, out);
}

void copyColour(const ElementSource& source, std::size_t count, float* out)
{
    ElementFormat format = formatOf(source.type);
    format.normalised = format.normalised || format.scalar == Scalar::UnsignedByte;
    copyFormat(source, format, count, 4, out);
}

} // namespace lodsmith
