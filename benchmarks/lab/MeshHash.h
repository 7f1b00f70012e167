#pragma once

#include <lodsmith/core/MeshView.h>

#include <string>

namespace lodsmith::benchmarks {

/// 32 hexadecimal digits that stand for a mesh's content: XXH3, 128 bits, of every number of every stream and index list. The
/// same whatever the strides, the width of indices and the version of the library.
std::string meshHash(const MeshView& mesh);

} // namespace lodsmith::benchmarks
