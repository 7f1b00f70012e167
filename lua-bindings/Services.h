#pragma once

#include "Callback.h"

#include <lodsmith/lua/Mesh.h>
#include <lodsmith/ogre/LevelAnalyser.h>
#include <lodsmith/ogre/LodDefinitionManager.h>
#include <lodsmith/ogre/LodManager.h>
#include <lodsmith/ogre/QueuedProgressiveMeshGenerator.h>

#include <sigc++/connection.h>
#include <sigc++/signal.h>

#include <memory>

namespace lodsmith::lua {

class Definition;

/// What a program shares with Lua. Handles look whether it is still there.
///
/// Scripts connect to the signals here, which pass on those of the queue, so that they are let go when the sharing ends.
struct Services {
    Services(LodDefinitionManager& definitions, LodManager& manager, QueuedProgressiveMeshGenerator& queue);
    ~Services();
    Services(const Services&) = delete;
    Services& operator=(const Services&) = delete;

    LodDefinitionManager& definitions;
    LodManager& manager;
    QueuedProgressiveMeshGenerator& queue;
    LevelAnalyser analyser;

    sigc::signal<void, const Ogre::MeshPtr&, const LodReport&> injected;
    sigc::signal<void, const Ogre::MeshPtr&, const Error&> failed;
    sigc::signal<void, const Ogre::MeshPtr&, float> progress;

private:
    sigc::connection mFromQueue[3];
};

/// A report as Lua sees it.
Table reportTable(const LodReport& report, const Ogre::Mesh& mesh);

/// A handle whose functions need the services.
class ServiceHandle : public Handle {
protected:
    ServiceHandle(const char* typeName, const char* what, const std::shared_ptr<Services>& services);

    template <class Work>
    Returned withServices(const Work& work) const
    {
        const std::shared_ptr<Services> services = mServices.lock();
        return services ? work(*services) : gone();
    }
    /// And a mesh that is loaded.
    template <class Work>
    Returned withMesh(const Mesh& mesh, const Work& work) const
    {
        return withServices([&](Services& services) -> Returned {
            const Result<Ogre::MeshPtr> loaded = mesh.loaded();
            return loaded ? work(services, loaded.value()) : Returned(loaded.error());
        });
    }

private:
    Returned gone() const;

    const char* mWhat;
    std::weak_ptr<Services> mServices;
};

class Definitions final : public ServiceHandle {
public:
    explicit Definitions(const std::shared_ptr<Services>& services);

    Returned read(const Mesh& mesh) const;
    Returned path(const Mesh& mesh) const;
    Returned save(const Mesh& mesh, const Definition& definition) const;
};

class Manager final : public ServiceHandle {
public:
    explicit Manager(const std::shared_ptr<Services>& services);

    /// @param definition null for the mesh's own
    Returned apply(const Mesh& mesh, const Definition* definition) const;
    Returned applyToAll() const;
    Returned automaticDefinition(const Mesh& mesh, OptionalNumber levels) const;
    Returned enabled() const;
    Returned setEnabled(bool enabled) const;
    Returned automatic() const;
    Returned setAutomatic(bool automatic) const;
    Returned minTriangles() const;
    Returned setMinTriangles(double triangles) const;

private:
    template <class Change>
    Returned changePolicy(const Change& change) const;
};

class Queue final : public ServiceHandle {
public:
    explicit Queue(const std::shared_ptr<Services>& services);

    Returned generate(const Mesh& mesh, const Definition& definition, double priority) const;
    Returned isQueued(const Mesh& mesh) const;
    Returned queued() const;
    Returned cancel(const Mesh& mesh) const;
    Returned cancelAll() const;
    Returned onInjected(const Function& function) const;
    Returned onFailed(const Function& function) const;
    Returned onProgress(const Function& function) const;
};

class Generator final : public ServiceHandle {
public:
    explicit Generator(const std::shared_ptr<Services>& services);

    Returned generate(const Mesh& mesh, const Definition& definition) const;
};

/// A Lua function at a signal, until it is disconnected or collected, or the signal's owner goes.
class Connection final : public Handle {
public:
    explicit Connection(const sigc::connection& connection);
    ~Connection() override;

    Returned disconnect();
    Returned isConnected() const;

private:
    sigc::connection mConnection;
};

} // namespace lodsmith::lua
