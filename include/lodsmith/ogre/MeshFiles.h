#pragma once

#include <lodsmith/core/Export.h>
#include <lodsmith/core/Result.h>

#include <OgreMesh.h>

#include <filesystem>
#include <vector>

namespace lodsmith {

/// Whether a file is a mesh by its name: it ends in ".mesh", in letters of either case.
LODSMITH_API bool isMeshFileName(const Ogre::String& name);

/// Opens a mesh file from anywhere. Its directory becomes the only location of a resource group of its own, which is named for the
/// directory's canonical path and initialised, so that materials and definitions beside the mesh count. A second mesh of
/// the directory comes into the same group. A mesh that is there already is loaded if it is not, and else stays as it is.
///
/// Errors: NotFound (no such file), Io, and those of loadMesh(). Main thread only, as MeshReader.
LODSMITH_API Result<Ogre::MeshPtr> openMeshFile(const std::filesystem::path& path);

/// Lets OGRE know of all meshes (isMeshFileName()) in a directory and in those below it, each as openMeshFile() does it, without loading
/// them. Sorted by path; hidden ones, links to directories and what may not be read are left out. Errors: NotFound,
/// Io (no directory), Unsupported (OGRE refused). Main thread only, as MeshReader.
LODSMITH_API Result<std::vector<Ogre::MeshPtr>> openMeshDirectory(const std::filesystem::path& path);

/// Loads a mesh, if it is not loaded. OGRE ends the process over much that is no mesh, so that a mesh of a file is looked at
/// first. Errors: BadFile (empty, no mesh, of a version that this OGRE does not read, cut off or damaged), Io,
/// OutOfMemory, Unsupported (OGRE refused), and those of MeshReader::read(); file is the mesh's name. Main thread only, as MeshReader.
LODSMITH_API Result<Done> loadMesh(const Ogre::MeshPtr& mesh);

/// The file that a mesh is read from. Errors: Unsupported when it was made by hand; NotFound when no directory
/// of its group has it (an archive does, or nothing). Main thread only, as MeshReader.
LODSMITH_API Result<std::filesystem::path> meshPath(const Ogre::Mesh& mesh);

} // namespace lodsmith
