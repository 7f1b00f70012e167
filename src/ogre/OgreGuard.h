#pragma once

#include <lodsmith/core/Result.h>

#include <OgreException.h>

#include <exception>
#include <new>
#include <string>

namespace lodsmith {

/// Runs `work` and turns what OGRE or the allocator throws into an error about the resource `name`. What `work` returns
/// gets the name too where it has none.
template <class Work>
auto guarded(const Ogre::String& name, Work work) -> decltype(work())
{
    try {
        auto result = work();
        if (result)
            return result;
        Error error = result.error();
        if (error.file.empty())
            error.file = name;
        return error;
    } catch (const Ogre::Exception& exception) {
        return Error{ErrorCode::Unsupported, "OGRE refused: " + exception.getDescription(), name};
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::OutOfMemory, "out of memory", name};
    } catch (const std::exception& exception) { // std::bad_cast over a hand-made level's file that is no mesh
        return Error{ErrorCode::Unsupported, std::string("OGRE failed: ") + exception.what(), name};
    }
}

} // namespace lodsmith
