#pragma once

#include <lodsmith/core/Export.h>

namespace lodsmith::lua {

/// An object that Lua owns: made in C++, handed over with Returned, and destroyed when Lua collects it or the state is closed.
///
/// A handle holds nothing that its owner could not destroy meanwhile: it shares what it stands for (std::shared_ptr), or looks
/// whether that is still there (std::weak_ptr). Bound classes derive from this one alone, as their first and only base, and
/// not from each other: LODSMITH_BOUND_CLASSES.
class LODSMITH_API Handle {
public:
    virtual ~Handle();
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;

    /// The name under which tolua++ knows the class of the object ("lodsmith::Mesh").
    const char* typeName() const { return mTypeName; }

protected:
    /// @param typeName outlives the object
    explicit Handle(const char* typeName) : mTypeName(typeName) {}

private:
    const char* mTypeName;
};

} // namespace lodsmith::lua
