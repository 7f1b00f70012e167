#include "PluginSettings.h"

#include "../src/files/AtomicFile.h"

#include <lodsmith/cache/LodCache.h>
#include <lodsmith/ogre/LodDefinitionManager.h>
#include <lodsmith/ogre/LodManager.h>
#include <lodsmith/ogre/QueuedProgressiveMeshGenerator.h>

#include <OgreException.h>
#include <OgreFileSystemLayer.h>
#include <OgreLogManager.h>
#include <OgrePlugin.h>
#include <OgreRoot.h>

#include <cstdint>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <utility>

#if !defined(_WIN32)
#    include <pwd.h>
#    include <unistd.h>
#endif

#if defined(_WIN32)
#    define LODSMITH_PLUGIN_API extern "C" __declspec(dllexport)
#else
#    define LODSMITH_PLUGIN_API extern "C" __attribute__((visibility("default")))
#endif

namespace lodsmith {

namespace {

constexpr const char* kSettingsFile = "lodsmith.cfg";
constexpr std::uintmax_t kMostSettingsBytes = 1 << 20;

/// OGRE looks for a user's directories without looking whether there is a user.
bool userHasHome()
{
#if defined(_WIN32)
    return true;
#else
    return std::getenv("HOME") || ::getpwuid(::getuid());
#endif
}

/// Also a link that leads nowhere is there: what cannot be read is an error, and not the same as nothing.
bool isThere(const Ogre::String& path)
{
    std::error_code ignored;
    return std::filesystem::exists(std::filesystem::symlink_status(path, ignored));
}

/// The settings in the working directory, beside the program, or where else OGRE looks for .cfg files; the defaults when
/// there are none.
Result<PluginSettings> readSettings()
{
    auto& log = Ogre::LogManager::getSingleton();
    Ogre::String path = kSettingsFile;
    if (!isThere(path) && userHasHome())
        path = Ogre::FileSystemLayer(OGRE_VERSION_NAME).getConfigFilePath(path);
    if (!isThere(path)) {
        log.logMessage("Lodsmith: no " + Ogre::String(kSettingsFile) + ", all settings are the defaults");
        return PluginSettings();
    }
    log.logMessage("Lodsmith: settings from " + path);
    const Result<std::string> text = readFile(path, kMostSettingsBytes);
    return text ? parsePluginSettings(text.value(), path) : text.error();
}

/// Where OGRE says that a program may write for its user. Nothing when there is no such place: OGRE then names the working
/// directory, which is no place for a cache.
std::string directoryOfUser()
{
    if (!userHasHome())
        return {};
    const std::string directory = Ogre::FileSystemLayer("lodsmith").getWritablePath("");
    return std::filesystem::path(directory).is_absolute() ? directory : std::string();
}

std::shared_ptr<LodCache> makeCache(const PluginSettings& settings)
{
    if (settings.cacheLimit == 0)
        return nullptr;
    const std::string directory = settings.cacheDirectory.empty() ? directoryOfUser() : settings.cacheDirectory;
    if (!directory.empty()) // absolute, for programs that change their working directory
        return std::make_shared<LodCache>(std::filesystem::absolute(directory), settings.cacheLimit);
    Ogre::LogManager::getSingleton().logWarning("Lodsmith has no cache: this user has no directory for one");
    return nullptr;
}

QueueOptions queueOptions(const PluginSettings& settings)
{
    QueueOptions options = settings.queue;
    options.cache = makeCache(settings);
    return options;
}

/// One warning, however many meshes there are.
class CacheWarning {
public:
    void operator()(const LodReport& report)
    {
        if (report.notStored && !std::exchange(mSaid, true))
            Ogre::LogManager::getSingleton().logWarning("Lodsmith cannot keep levels for the next start: "
                                                        + describe(*report.notStored));
    }

private:
    bool mSaid = false;
};

class LodsmithPlugin final : public Ogre::Plugin {
public:
    const Ogre::String& getName() const override { return mName; }
    void install() override {}
    void uninstall() override {}

    /// Once the render system is there, and the managers that need it. OGRE calls it twice when a plugin is loaded between its
    /// beginning and its first window.
    void initialise() override
    {
        if (mLods)
            return;
        auto& log = Ogre::LogManager::getSingleton();
        try {
            const Result<PluginSettings> settings = readSettings();
            if (!settings)
                return log.logError("Lodsmith is off: " + describe(settings.error()));
            mLods = std::make_unique<Lods>(settings.value());
        } catch (const std::exception& exception) {
            log.logError(Ogre::String("Lodsmith is off: ") + exception.what());
        }
    }

    void shutdown() override { mLods.reset(); }

private:
    struct Lods {
        explicit Lods(const PluginSettings& settings)
            : queue(queueOptions(settings)), manager(definitions, queue, settings.policy)
        {
            queue.signals().failed.connect([](const Ogre::MeshPtr&, const Error& error) {
                Ogre::LogManager::getSingleton().logError(describe(error));
            });
            queue.signals().injected.connect(
                [warn = CacheWarning()](const Ogre::MeshPtr&, const LodReport& report) mutable { warn(report); });
        }

        LodDefinitionManager definitions;
        QueuedProgressiveMeshGenerator queue;
        LodManager manager;
    };

    Ogre::String mName = "Lodsmith";
    std::unique_ptr<Lods> mLods;
};

std::unique_ptr<LodsmithPlugin> plugin;

} // namespace

} // namespace lodsmith

/// Called by OGRE when it has loaded this library, and before it lets go of it.
LODSMITH_PLUGIN_API void dllStartPlugin()
{
    lodsmith::plugin = std::make_unique<lodsmith::LodsmithPlugin>();
    Ogre::Root::getSingleton().installPlugin(lodsmith::plugin.get());
}

LODSMITH_PLUGIN_API void dllStopPlugin()
{
    Ogre::Root::getSingleton().uninstallPlugin(lodsmith::plugin.get());
    lodsmith::plugin.reset();
}
