#pragma once

namespace lodsmith {

/// Asserts that the caller is on the main thread: the one that was first to call this. OGRE does not lock its meshes and
/// buffers, so whoever owns Ogre::Root must also be the one who calls the adapter.
void assertMainThread();

} // namespace lodsmith
