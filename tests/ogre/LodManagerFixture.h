#pragma once

#include <support/OgreMeshBuilder.h>
#include <support/OgreSession.h>

#include <lodsmith/ogre/LodManager.h>
#include <lodsmith/ogre/ProgressiveMeshGenerator.h>

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace lodsmith::test {

/// A definition of two levels, at 20 and 40.
extern const std::string kTwoLevels;

/// A definition of hand-made levels: distance and mesh of each.
std::string handMade(const std::vector<std::pair<std::string, std::string>>& levels);

/// The users' values of a mesh's levels, from level 1 on.
std::vector<Ogre::Real> values(const Ogre::MeshPtr& mesh);

/// The users' values of the automatic levels that a mesh gets.
std::vector<Ogre::Real> automaticValues(const Ogre::MeshPtr& mesh, const AutomaticLods& automatic = {});

/// A program with a LodManager, once start() is called, and mesh files and definitions in its group's directory.
class LodManagerTest : public testing::Test {
protected:
    void start(const LodPolicy& policy = {}) { mManager = std::make_unique<LodManager>(mDefinitions, *mQueue, policy); }

    /// @param withLevels the file brings a level at 7
    void writeMesh(const std::string& name, const TestMesh& source, bool withLevels = false);
    void writeDefinition(const std::string& name, const std::string& text);
    void removeFile(const std::string& name);
    /// Lets OGRE see what files there are now.
    void list();

    /// Loads a mesh and waits for its levels.
    Ogre::MeshPtr load(const std::string& name);
    void finish() { mQueue->injector().finishAll(); }

    OgreSession mSession;
    LodDefinitionManager mDefinitions;
    std::unique_ptr<QueuedProgressiveMeshGenerator> mQueue = std::make_unique<QueuedProgressiveMeshGenerator>();
    std::unique_ptr<LodManager> mManager;
};

} // namespace lodsmith::test
