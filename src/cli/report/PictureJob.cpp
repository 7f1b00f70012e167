#include "PictureJob.h"

#include "../PictureSession.h"
#include "../SeenRecord.h"
#include "HtmlText.h"
#include "JudgedMesh.h"

#include <lodsmith/render/Png.h>
#include <lodsmith/render/SeenLevels.h>

namespace lodsmith::cli {

namespace {

constexpr unsigned kCloseUp = 512, kThumbnail = 96; // pixels
// Half from the side and somewhat from above.
constexpr std::size_t kDirection = 5;

/// Takes one picture after the other, until one fails.
class Photographer {
public:
    explicit Photographer(LevelRenderer& renderer) : mRenderer(renderer) {}

    std::string take(unsigned level, const Viewpoint& viewpoint)
    {
        if (!mState)
            return "";
        const Result<Image> image = mRenderer.picture(level, Paint::Own, viewpoint);
        const Result<std::string> png = image ? pngBytes(image.value()) : Result<std::string>(image.error());
        if (png)
            return base64(png.value());
        mState = png.error();
        return "";
    }

    const Result<Done>& state() const { return mState; }

private:
    LevelRenderer& mRenderer;
    Result<Done> mState = Done{};
};

Result<Json> photograph(LevelRenderer& renderer)
{
    const Ogre::Vector3 direction = viewDirections()[kDirection];
    const Viewpoint closeUp = renderer.closeUp(direction, kCloseUp);
    Photographer photographer(renderer);
    Json levels = Json::array();
    for (unsigned level = 0; level < renderer.levels(); ++level) {
        Json pictures{{"close", photographer.take(level, closeUp)}};
        // A level that never appears has no switch to show.
        if (const auto viewpoint = level > 0 ? renderer.atSwitch(level, direction) : Result<Viewpoint>(Error{})) {
            pictures["before"] = photographer.take(level - 1, viewpoint.value());
            pictures["after"] = photographer.take(level, viewpoint.value());
        }
        levels.push_back(std::move(pictures));
    }
    Json record{{"thumbnail", photographer.take(0, renderer.closeUp(direction, kThumbnail))}};
    record["levels"] = std::move(levels);
    if (!photographer.state())
        return photographer.state().error();
    return record;
}

} // namespace

Result<Json> takePictures(const PlannedFile& mesh, Progress& progress)
{
    const Result<JudgedMesh> judged = judgedMesh(mesh, progress);
    if (!judged)
        return judged.error();
    const bool isElsewhere = judged.value().directory.has_value();
    const std::filesystem::path home = mesh.input.has_parent_path() ? mesh.input.parent_path() : ".";
    const auto session = PictureSession::open(judged.value().file, isElsewhere ? home : std::filesystem::path());
    if (!session)
        return session.error();
    LevelRenderer& renderer = session.value()->renderer();
    Result<Json> record = photograph(renderer);
    if (!record)
        return record;
    const auto seen = measureSeenLevels(renderer, {}, &progress);
    if (!seen)
        return seen.error();
    record.value()["seen"] = seenRecords(*renderer.mesh(), seen.value());
    record.value()["notes"] = renderer.notes();
    return record;
}

} // namespace lodsmith::cli
