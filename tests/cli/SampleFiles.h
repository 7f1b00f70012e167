#pragma once

#include "support/TestDirectory.h"

#include <string>

namespace lodsmith::cli::test {

/// Triangles of a torus of this many segments both ways.
constexpr unsigned torusTriangles(unsigned segments)
{
    return 2 * segments * segments;
}

/// A torus as a Wavefront OBJ text: closed, with UV coordinates that make one seam each way and the material "Stone".
/// Radii 2 and 1, so that no point is farther than 3 from the centre.
std::string torusObj(unsigned segments);

/// The bytes of a mesh made of torusObj(); `skeleton`, unless empty, is the name of the skeleton that it asks for.
std::string torusMesh(unsigned segments, const std::string& skeleton = "");

} // namespace lodsmith::cli::test
