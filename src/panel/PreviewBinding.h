#pragma once

#include <lodsmith/lua/Handle.h>

#include <memory>

namespace lodsmith {

struct CeguiPreview;

/// What `lodsmith.preview` is, with the functions of Preview.pkg. It does not keep the preview alive.
std::unique_ptr<lua::Handle> makePreviewHandle(const std::shared_ptr<CeguiPreview>& preview);

} // namespace lodsmith
