#pragma once

#include <lodsmith/core/Result.h>

#include <CEGUI/String.h>

#include <filesystem>

namespace lodsmith {

/// CEGUI takes layouts whose resource group nobody names from a directory, for as long as this object lives.
class LayoutLocation {
public:
    /// Errors: Unsupported when CEGUI's resource provider is neither OGRE's nor the default one.
    static Result<Done> check();

    explicit LayoutLocation(const std::filesystem::path& directory);
    ~LayoutLocation();
    LayoutLocation(const LayoutLocation&) = delete;
    LayoutLocation& operator=(const LayoutLocation&) = delete;

private:
    CEGUI::String mBefore; ///< the default group
};

} // namespace lodsmith
