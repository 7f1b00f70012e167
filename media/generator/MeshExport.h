#pragma once

#include "Shape.h"

#include <OgreMesh.h>
#include <OgrePixelFormat.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace lodsmith::media {

/// Makes an OGRE mesh with 16-bit indices, one submesh a shape.
/// @param shared  true puts all vertices in the mesh's shared buffer, false gives each submesh its own
Ogre::MeshPtr makeMesh(const std::string& name, const std::vector<Shape>& shapes, bool shared);

/// Writes DIRECTORY/NAME.mesh and reports its counts on standard output.
void exportMesh(const Ogre::Mesh& mesh, const std::filesystem::path& directory);

/// Writes a picture whose pixels are `colour(u, v)`, u to the right and v down, 0..1 at pixel centres.
void writePicture(const std::filesystem::path& file, std::uint32_t size,
                  const std::function<Ogre::ColourValue(float u, float v)>& colour);

/// Smooth noise, -1..1, repeating every `period` units in both directions.
float tilingNoise(float x, float y, int period, std::uint32_t seed);

/// Octaves of tilingNoise() over a texture: u and v 0..1, `period` waves in the first octave.
float fractalNoise(float u, float v, int period, int octaves, std::uint32_t seed);

void writeText(const std::filesystem::path& file, const std::string& text);

} // namespace lodsmith::media
