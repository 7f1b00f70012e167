#pragma once

#include <lodsmith/core/Result.h>
#include <lodsmith/ogre/ProgressiveMeshGenerator.h>

#include <OgreMesh.h>

#include <sigc++/signal.h>

namespace lodsmith {

/// What background generation has to say, for anybody to connect to.
///
/// Signals are emitted by the injector: on the main thread, from within PMInjector::update() and its sisters and nowhere
/// else, with no lock held and the request already out of the queue. A handler may do anything: queue, cancel, destroy
/// meshes, even destroy the queue, after which nothing more is emitted. What a handler throws goes through to the caller of
/// update(); the queue is whole.
///
/// A request ends with exactly one of `injected` and `failed`, or in silence when it was cancelled or replaced, or when its
/// mesh was unloaded, loaded again or destroyed meanwhile.
struct PMInjectorSignaler {
    /// The levels are on the mesh.
    sigc::signal<void, const Ogre::MeshPtr&, const LodReport&> injected;
    /// There is an error, and the mesh is as it was. Error::file is its name.
    sigc::signal<void, const Ogre::MeshPtr&, const Error&> failed;
    /// The share of the computation that is done, 0..1: for each running request at most once an update, when it has risen.
    sigc::signal<void, const Ogre::MeshPtr&, float> progress;
};

} // namespace lodsmith
