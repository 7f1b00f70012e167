// Makes the models of media/ again: lodsmith_media DIRECTORY

#include "Models.h"

#include <OgreDefaultHardwareBufferManager.h>
#include <OgreLogManager.h>
#include <OgreMaterialManager.h>
#include <OgreRoot.h>

#include <iostream>
#include <memory>

namespace {

void generateAll(const std::filesystem::path& directory)
{
    using namespace lodsmith::media;
    const std::pair<const char*, void (*)(const std::filesystem::path&)> models[] = {
        {"tree", makeTree}, {"cottage", makeCottage}, {"lantern", makeLantern}, {"drake", makeDrake}};
    for (const auto& [name, make] : models) {
        std::filesystem::create_directories(directory / name);
        make(directory / name);
    }
}

int run(const std::filesystem::path& directory)
{
    Ogre::LogManager log;
    log.createLog("", true, false, true);
    // Root has to go before the buffers' manager.
    std::unique_ptr<Ogre::DefaultHardwareBufferManager> buffers;
    Ogre::Root root("", "", "");
    buffers = std::make_unique<Ogre::DefaultHardwareBufferManager>();
    root.loadPlugin(LODSMITH_OGRE_PLUGIN_DIR "/Codec_STBI");
    Ogre::MaterialManager::getSingleton().initialise();
    try {
        generateAll(directory);
        return 0;
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2) {
        std::cerr << "usage: lodsmith_media DIRECTORY\n";
        return 2;
    }
    return run(argv[1]);
}
