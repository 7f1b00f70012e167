#include "MainThread.h"

#include <lodsmith/core/Assert.h>

#include <thread>

namespace lodsmith {

void assertMainThread()
{
    static const std::thread::id mainThread = std::this_thread::get_id();
    LODSMITH_ASSERT(std::this_thread::get_id() == mainThread, "the OGRE adapter was called off the main thread");
}

} // namespace lodsmith
