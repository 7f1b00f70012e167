#pragma once

#include "HeatMap.h"

#include <lodsmith/ogre/LevelAnalyser.h>
#include <lodsmith/ogre/MeshReader.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lodsmith {

/// Heat maps of a mesh's levels, measured in the background: each vertex of level 0 by its distance to the level.
class DeviationView {
public:
    /// All live longer than it does.
    DeviationView(LevelAnalyser& analyser, Ogre::SceneNode& node, const Ogre::MaterialPtr& material);

    /// It is another mesh, or the mesh itself has changed.
    void forget();
    /// What is known of the levels no longer holds; what is shown stays until it has been measured anew.
    void forgetLevels();

    /// Shows these levels of a loaded mesh, and measures what is not known of them. Maps for which there are no figures yet are
    /// left out. To be called again after each change.
    void want(const Ogre::MeshPtr& mesh, const std::vector<unsigned>& levels);
    /// Shows none.
    void hide();
    /// Null while there is none.
    HeatMap* mapOf(unsigned level);

    /// Whether the maps have changed since this was asked last.
    bool takeChange();
    /// What red is in all the maps that are wanted; none while figures are missing.
    std::optional<double> scale() const;
    const std::string& error() const { return mError; }

private:
    using Distances = std::vector<std::vector<float>>;

    struct Level {
        Distances distances;
        double scale = 0;
        bool isCurrent = false; ///< the distances are of the level as it is now
        bool hasFailed = false;
        LevelAnalyser::JobPtr job;
        std::unique_ptr<HeatMap> map;
    };

    bool readMesh(const Ogre::Mesh& mesh);
    void measure(const Ogre::MeshPtr& mesh, unsigned level);
    void receive(unsigned level, const Result<Distances>& distances);
    void fail(Level& level, const Error& error);
    void paint();

    LevelAnalyser& mAnalyser;
    Ogre::SceneNode& mNode;
    Ogre::MaterialPtr mMaterial;
    std::optional<MeshData> mMesh; ///< level 0
    std::map<unsigned, Level> mLevels;
    std::vector<unsigned> mWanted;
    std::string mError;
    bool mHasChanged = false;
};

} // namespace lodsmith
