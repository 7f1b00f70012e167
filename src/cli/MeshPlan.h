#pragma once

#include "Generation.h"
#include "OgreSession.h"

#include <lodsmith/ogre/LodConfig.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace lodsmith::cli {

/// A hand-made level, loaded; the generator does not look into it.
struct HandMadeLevel {
    std::filesystem::path file;
    std::uint32_t vertices = 0; ///< welded
    std::uint32_t triangles = 0;
};

/// What one mesh is going to get.
struct MeshPlan {
    LodConfig config;
    std::map<std::string, HandMadeLevel> handMade; ///< by LodLevel::manualMeshName, which is the file's name
    std::string loddef;                            ///< the definition that this comes from; empty for none
    std::vector<std::string> notes;
};

/// Makes a configuration for a loaded mesh from its definition, from the levels of the command line, or the automatic
/// one, and loads the hand-made levels. What a definition asks for and cannot have is an error.
/// Errors: those of the definition, of loading and of lodConfig(); InvalidGeometry (no bounding radius for automatic levels);
/// InvalidSetting (a hand-made level with the file name of another one or of the output).
Result<MeshPlan> planMesh(const GenerateSettings& settings, const PlannedFile& file, OgreSession& session,
                          const Ogre::MeshPtr& mesh);

} // namespace lodsmith::cli
