#pragma once

#include "StateLink.h"

#include <lodsmith/lua/Binding.h>

#include <memory>

namespace lodsmith::lua {

/// A Lua function that C++ calls later. Main thread only; the state may be closed before it is destroyed.
class Callback {
public:
    /// Throws std::bad_alloc when Lua has no memory.
    explicit Callback(const Function& function);
    ~Callback();
    Callback(const Callback&) = delete;
    Callback& operator=(const Callback&) = delete;

    /// Calls the function. A Lua error in it is logged to OGRE's log and given to `lodsmith.onError`. Does nothing when the
    /// state is closed.
    void operator()(Returned arguments) const noexcept;

private:
    std::shared_ptr<StateLink> mLink;
    int mReference;
};

/// Leaves in the registry what Callback needs. May raise a Lua error.
void prepareCallbacks(lua_State* state);

} // namespace lodsmith::lua
