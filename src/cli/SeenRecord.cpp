#include "SeenRecord.h"

namespace lodsmith::cli {

namespace {

Json differenceRecord(const SeenDifference& difference)
{
    return Json{{"largest", difference.largest},
                {"mean", difference.mean},
                {"ssim", difference.ssim},
                {"least_ssim", difference.leastSsim},
                {"silhouette_share", difference.silhouetteShare},
                {"silhouette_distance", difference.silhouetteDistance},
                {"coverage", difference.coverage},
                {"least_coverage", difference.leastCoverage}};
}

Json paintedRecord(const PaintedDifference& difference)
{
    return Json{{"lit", differenceRecord(difference.lit)}, {"checker", differenceRecord(difference.checker)}};
}

} // namespace

Json seenRecords(const Ogre::Mesh& mesh, const std::vector<SeenLevel>& levels)
{
    Json records = Json::array();
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const SeenLevel& level = levels[i];
        const bool isOriginal = i == 0;
        const auto known = [&](double figure) { return level.appears() ? Json(figure) : Json(); };
        const auto there = [&](const PaintedDifference& difference) {
            return isOriginal || level.appears() ? paintedRecord(difference) : Json();
        };
        records.push_back(
            Json{{"level", i},
                 {"value", isOriginal ? Json() : Json(mesh.getLodLevel(static_cast<Ogre::ushort>(i)).userValue)},
                 {"triangles", level.triangles},
                 {"switch_radius", known(level.switchRadius)},
                 {"switch_distance", known(level.switchDistance)},
                 {"at_switch", there(level.atSwitch)},
                 {"popping", there(level.popping)},
                 {"close_up", paintedRecord(level.closeUp)}});
    }
    return records;
}

} // namespace lodsmith::cli
