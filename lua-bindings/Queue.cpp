#include "Definition.h"
#include "Services.h"

#include <lodsmith/ogre/DefinedLodConfig.h>
#include <lodsmith/ogre/ProgressiveMeshGenerator.h>

#include <OgreLogManager.h>

#include <cmath>
#include <string>

namespace lodsmith::lua {

namespace {

/// By its name, since the report knows values alone.
Value handMadeName(const Ogre::Mesh& mesh, Ogre::Real value)
{
    for (Ogre::ushort level = 1; level < mesh.getNumLodLevels(); ++level)
        if (const Ogre::MeshLodUsage& usage = mesh.getLodLevel(level); usage.userValue == value)
            return usage.manualName;
    return nullptr;
}

Table levelTable(const LodLevelReport& level, const Ogre::Mesh& mesh)
{
    Table table;
    table.set("value", level.value)
        .set("triangles", level.triangles)
        .set("vertices", level.vertices)
        .set("deviation", level.deviation)
        .set("stop", level.stop)
        .set("skipped", level.skipped)
        .set("handMade", level.manual);
    if (level.manual)
        table.set("mesh", handMadeName(mesh, level.value));
    return table;
}

/// What was left out is logged, as LodManager does.
Result<LodConfig> configFor(const Services& services, const Definition& definition, const Ogre::MeshPtr& mesh)
{
    const Result<DefinedLodConfig> defined =
        lodConfig(definition.data(), mesh, {}, services.manager.policy().automaticLods);
    if (!defined)
        return defined.error();
    for (const Error& error : defined.value().leftOut)
        Ogre::LogManager::getSingleton().logWarning(describe(error));
    return defined.value().config;
}

Returned connectionTo(const sigc::connection& connection)
{
    return std::make_unique<Connection>(connection);
}

} // namespace

Table reportTable(const LodReport& report, const Ogre::Mesh& mesh)
{
    Table levels;
    for (const LodLevelReport& level : report.levels)
        levels.add(levelTable(level, mesh));
    Table table;
    table.set("vertices", report.vertices)
        .set("triangles", report.triangles)
        .set("radius", report.radius)
        .set("fromCache", report.fromCache)
        .set("notes", Table(report.notes))
        .set("levels", std::move(levels));
    return table;
}

Queue::Queue(const std::shared_ptr<Services>& services) : ServiceHandle("lodsmith::Queue", "queue", services) {}

Returned Queue::generate(const Mesh& handle, const Definition& definition, double priority) const
{
    if (std::isnan(priority))
        return Returned::failure("the priority is not a number");
    return withMesh(handle, [&](Services& services, const Ogre::MeshPtr& mesh) -> Returned {
        const Result<LodConfig> config = configFor(services, definition, mesh);
        if (!config)
            return config.error();
        return services.queue.generateLodLevels(config.value(), static_cast<float>(priority));
    });
}

Returned Queue::isQueued(const Mesh& handle) const
{
    return withServices([&](Services& services) -> Returned {
        const Ogre::MeshPtr mesh = handle.lock();
        return mesh && services.queue.isQueued(mesh);
    });
}

Returned Queue::queued() const
{
    return withServices([](Services& services) -> Returned { return services.queue.queued(); });
}

Returned Queue::cancel(const Mesh& handle) const
{
    return withServices([&](Services& services) -> Returned {
        if (const Ogre::MeshPtr mesh = handle.lock())
            services.queue.cancel(mesh);
        return true;
    });
}

Returned Queue::cancelAll() const
{
    return withServices([](Services& services) -> Returned {
        services.queue.cancelAll();
        return true;
    });
}

Returned Queue::onInjected(const Function& function) const
{
    return withServices([&](Services& services) -> Returned {
        const auto callback = std::make_shared<Callback>(function);
        return connectionTo(services.injected.connect([callback](const Ogre::MeshPtr& mesh, const LodReport& report) {
            (*callback)(Returned(std::make_unique<Mesh>(mesh)).with(reportTable(report, *mesh)));
        }));
    });
}

Returned Queue::onFailed(const Function& function) const
{
    return withServices([&](Services& services) -> Returned {
        const auto callback = std::make_shared<Callback>(function);
        return connectionTo(services.failed.connect([callback](const Ogre::MeshPtr& mesh, const Error& error) {
            (*callback)(Returned(std::make_unique<Mesh>(mesh)).with(describe(error)));
        }));
    });
}

Returned Queue::onProgress(const Function& function) const
{
    return withServices([&](Services& services) -> Returned {
        const auto callback = std::make_shared<Callback>(function);
        return connectionTo(services.progress.connect([callback](const Ogre::MeshPtr& mesh, float fraction) {
            (*callback)(Returned(std::make_unique<Mesh>(mesh)).with(fraction));
        }));
    });
}

Generator::Generator(const std::shared_ptr<Services>& services)
    : ServiceHandle("lodsmith::Generator", "generator", services)
{
}

Returned Generator::generate(const Mesh& handle, const Definition& definition) const
{
    return withMesh(handle, [&](Services& services, const Ogre::MeshPtr& mesh) -> Returned {
        const Result<LodConfig> config = configFor(services, definition, mesh);
        if (!config)
            return config.error();
        const Result<LodReport> report =
            ProgressiveMeshGenerator(services.queue.cache()).generateLodLevels(config.value());
        if (!report)
            return report.error();
        return reportTable(report.value(), *mesh);
    });
}

} // namespace lodsmith::lua
