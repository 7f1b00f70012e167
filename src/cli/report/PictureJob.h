#pragma once

#include "../JsonRecord.h"
#include "../OutputPlan.h"

#include <lodsmith/core/Progress.h>

namespace lodsmith::cli {

/// Pictures of a mesh's levels, as JudgedMesh has them, all from one direction: an object with the members
///
/// - `thumbnail`: level 0, small
/// - `levels`: for each level `close`, in which the mesh fills a picture of 512 pixels, and, but for level 0, `before`
///   and `after`: the level before it and the level itself as large as they are where it appears, a pixel for a pixel
/// - `seen`: how the levels differ from level 0 to the eye, docs/report.md
///
/// Pictures are PNG files in base64. Starts OGRE with a render system: to be called in a child process. Errors: those
/// of judgedMesh(), of PictureSession (Unsupported without an X display) and LevelRenderer.
Result<Json> takePictures(const PlannedFile& mesh, Progress& progress);

} // namespace lodsmith::cli
