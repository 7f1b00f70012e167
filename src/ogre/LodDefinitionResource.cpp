#include <lodsmith/ogre/LodDefinitionResource.h>

#include "MainThread.h"

#include <lodsmith/core/Assert.h>
#include <lodsmith/loddef/LoddefXml.h>

#include <OgreDataStream.h>
#include <OgreLogManager.h>
#include <OgreResourceGroupManager.h>

#include <string>
#include <utility>

namespace lodsmith {

namespace {

/// Everything up to one byte more than is allowed, which the parser refuses. Streams need not know their size.
std::string textOf(Ogre::DataStream& stream)
{
    std::string text;
    char block[1 << 14];
    while (text.size() <= kMaxLoddefBytes) {
        const std::size_t count = stream.read(block, sizeof block);
        if (count == 0)
            break;
        text.append(block, count);
    }
    return text;
}

} // namespace

LodDefinitionResource::LodDefinitionResource(Ogre::ResourceManager* creator, const Ogre::String& name,
                                             Ogre::ResourceHandle handle, const Ogre::String& group, bool isManual,
                                             Ogre::ManualResourceLoader* loader)
    : Ogre::Resource(creator, name, handle, group, isManual, loader)
{
}

LodDefinitionResource::~LodDefinitionResource()
{
    // OGRE keeps account of memory by unloading, and leaves that to the derived class.
    unload();
}

void LodDefinitionResource::setDefinition(LodDefinition definition)
{
    LODSMITH_ASSERT(findErrors(definition).empty(), "setDefinition() needs a definition without errors");
    mDefinition = std::move(definition);
    mErrors.clear();
    mIsFromFile = false;
    _dirtyState();
}

void LodDefinitionResource::loadImpl()
{
    assertMainThread();
    const Ogre::DataStreamPtr stream =
        Ogre::ResourceGroupManager::getSingleton().openResource(getName(), getGroup(), this);
    LoddefReading reading = parseLoddef(textOf(*stream), getName());
    auto& log = Ogre::LogManager::getSingleton();
    for (const Error& warning : reading.warnings)
        log.logWarning(describe(warning));
    for (const Error& error : reading.errors)
        log.logError(describe(error));
    mDefinition = std::move(reading.definition);
    mErrors = std::move(reading.errors);
}

void LodDefinitionResource::unloadImpl()
{
    mDefinition.reset();
    mErrors.clear();
    mIsFromFile = true;
}

std::size_t LodDefinitionResource::calculateSize() const
{
    std::size_t size = Ogre::Resource::calculateSize();
    if (!mDefinition)
        return size;
    size += mDefinition->original.size();
    for (const LodLevelDefinition& level : mDefinition->levels)
        size += sizeof level + level.meshName.size() + level.original.size();
    return size;
}

} // namespace lodsmith
