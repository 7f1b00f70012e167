#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>
#include <vector>

namespace lodsmith {

/// Memory that MeshData owns: each block is filled once and keeps its address for good.
using Blocks = std::vector<std::unique_ptr<unsigned char[]>>;

/// Adds a block for `count` objects, left uninitialised because every reader writes all of it.
template <class T>
T* addBlock(Blocks& blocks, std::size_t count)
{
    static_assert(std::is_trivially_copyable_v<T>, "blocks hold plain data");
    blocks.emplace_back(new unsigned char[count * sizeof(T)]);
    return reinterpret_cast<T*>(blocks.back().get());
}

} // namespace lodsmith
