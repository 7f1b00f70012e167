#pragma once

#include "CeguiImage.h"
#include "PreviewImage.h"

#include <lodsmith/panel/MeshPreview.h>

namespace lodsmith {

/// A preview, and what CEGUI shows of it.
struct LODSMITH_API CeguiPreview {
    explicit CeguiPreview(LevelAnalyser& analyser);

    MeshPreview preview;
    PreviewImage image;
    CeguiImage legend; ///< from what is not off at all, on the left, to deviationScale() and more
};

} // namespace lodsmith
