#pragma once

#include "MeshBuilders.h"

#include <lodsmith/core/Simplify.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lodsmith::test {

/// Hands out numbers from a byte string, zeros when it is used up. The bytes belong to the caller.
class ByteSource {
public:
    ByteSource(const std::uint8_t* data, std::size_t size) : mData(data), mEnd(data + size) {}

    bool empty() const { return mData == mEnd; }
    std::uint8_t byte() { return empty() ? std::uint8_t{0} : *mData++; }
    std::uint32_t below(std::uint32_t bound) { return bound == 0 ? 0 : byte() % bound; }
    bool flag() { return (byte() & 1) != 0; }
    /// -1..1 in 255 steps, so that equal values are common.
    float coarse() { return static_cast<float>(static_cast<std::int8_t>(byte())) / 127.0f; }
    /// Any float at all.
    float anything();

private:
    const std::uint8_t* mData;
    const std::uint8_t* mEnd;
};

/// One call of simplify().
struct SimplifyCase {
    TestMesh mesh;
    std::vector<LevelTarget> targets;
    SimplifyOptions options;
};

/// What of a case may be wrong.
enum class Trust {
    Valid,  ///< finite positions, indices in range, options and targets in range: simplify() has to succeed
    Garbage ///< anything goes
};

/// Any bytes make a case, the same bytes the same one: one of the builders' meshes or a soup, bent, torn, repeated and given
/// attributes as the bytes say. Small: at most a few hundred triangles.
SimplifyCase caseFromBytes(ByteSource& bytes, Trust trust);

} // namespace lodsmith::test
