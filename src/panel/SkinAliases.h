#pragma once

#include <lodsmith/core/Result.h>

#include <string>

namespace lodsmith {

/// Gives CEGUI the window types "Lodsmith/Button" and so on, which the panel's layouts are made of, as names for those of a skin;
/// widgets that the skin does not have are left out. The names stay until CEGUI goes, since it needs them to destroy the windows.
/// Errors: NotFound when the skin's scheme is not loaded.
Result<Done> nameWidgetsFor(const std::string& skin);

} // namespace lodsmith
