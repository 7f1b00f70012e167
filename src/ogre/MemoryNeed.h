#pragma once

#include <lodsmith/ogre/LodConfig.h>

#include <cstddef>

namespace lodsmith {

/// The most bytes that a request holds between copying its mesh out and writing the levels: what MeshReader::read() copies,
/// and room for its levels, of which none has more triangles than level 0. The memory in which simplify() works comes on
/// top, once a thread. Reads counts and declarations only; main thread.
std::size_t memoryNeed(const LodConfig& config);

} // namespace lodsmith
