#include "LevelSheet.h"

#include "Numbers.h"
#include "Table.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <utility>

namespace lodsmith::cli {

namespace {

constexpr std::uint32_t kSmall = 128; // pixels: pictures up to this size are shown enlarged too
constexpr unsigned kEnlargement = 4;

/// Half from the side and somewhat from above.
const Ogre::Vector3& direction()
{
    return viewDirections()[5];
}

std::string levelName(unsigned level)
{
    return level == 0 ? "original" : "level " + std::to_string(level);
}

/// Levels from one viewpoint, in one line, and, when they are small and to be enlarged, in another one so.
Result<SheetCell> cellOf(LevelRenderer& renderer, const std::vector<unsigned>& levels, Paint paint,
                         const Viewpoint& viewpoint, bool enlarges)
{
    std::vector<SheetPicture> line;
    for (const unsigned level : levels) {
        Result<Image> image = renderer.picture(level, paint, viewpoint);
        if (!image)
            return image.error();
        line.push_back({std::move(image).value(), levelName(level), 1});
    }
    SheetCell cell{line};
    if (!enlarges || std::max(line.front().image.width, line.front().image.height) > kSmall)
        return cell;
    for (SheetPicture& picture : line) {
        picture.scale = kEnlargement;
        picture.caption += ", x" + std::to_string(kEnlargement);
    }
    cell.push_back(std::move(line));
    return cell;
}

std::string fixed(double number, int decimals)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.*f", decimals, number);
    return text;
}

std::string percent(double share)
{
    return fixed(100 * share, 1) + " %";
}

std::array<std::string, 3> figure(const std::string& name, const PaintedDifference& difference,
                                  const std::function<std::string(const SeenDifference&)>& text)
{
    return {name, text(difference.lit), text(difference.checker)};
}

void addDifference(SheetRow& row, const std::string& name, const PaintedDifference& difference)
{
    row.figures.push_back({"", "", ""});
    row.figures.push_back({name, "lit", "checker"});
    row.figures.push_back(
        figure("largest difference", difference, [](const SeenDifference& seen) { return fixed(seen.largest, 0); }));
    row.figures.push_back(
        figure("mean difference", difference, [](const SeenDifference& seen) { return fixed(seen.mean, 2); }));
    row.figures.push_back(figure("SSIM", difference, [](const SeenDifference& seen) { return fixed(seen.ssim, 3); }));
}

void addSilhouette(SheetRow& row, const SeenDifference& difference)
{
    row.figures.push_back({"silhouette off by", fixed(difference.silhouetteDistance, 1) + " px", ""});
    row.figures.push_back({"coverage", percent(difference.coverage), ""});
}

SheetRow labelOf(const std::vector<SeenLevel>& seen, unsigned level)
{
    SheetRow row;
    const SeenLevel& one = seen[level];
    row.heading = level == 0 ? "Level 0, the original" : "Level " + std::to_string(level);
    std::string triangles = std::to_string(one.triangles) + (one.triangles == 1 ? " triangle" : " triangles");
    if (level > 0)
        triangles += ", " + percent(static_cast<double>(one.triangles) / static_cast<double>(seen.front().triangles));
    row.lines.push_back(triangles);
    if (level == 0)
        return row;
    if (one.appears()) {
        row.lines.push_back("appears at a radius of " + fixed(one.switchRadius, 0) + " px,");
        row.lines.push_back("at a distance of " + formatNumber(one.switchDistance, 4));
        addDifference(row, "There, from the original", one.atSwitch);
        addSilhouette(row, one.atSwitch.lit);
        addDifference(row, "Popping, from level " + std::to_string(level - 1), one.popping);
    } else {
        row.lines.push_back("appears nowhere in sight");
    }
    addDifference(row, "Close up, from the original", one.closeUp);
    addSilhouette(row, one.closeUp.lit);
    return row;
}

/// What is shown where a level appears.
std::vector<unsigned> levelsAt(unsigned level)
{
    return level == 1 ? std::vector<unsigned>{0, 1} : std::vector<unsigned>{0, level - 1, level};
}

Result<SheetRow> rowOf(LevelRenderer& renderer, const std::vector<SeenLevel>& seen, unsigned level,
                       const SeenOptions& options)
{
    SheetRow row = labelOf(seen, level);
    const Viewpoint near = renderer.closeUp(direction(), options.closeUpSize);
    for (const bool atSwitch : {false, true})
        for (const Paint paint : {Paint::Own, Paint::Checker}) {
            if (atSwitch && !seen[level].appears())
                continue;
            const Result<Viewpoint> far =
                atSwitch ? renderer.atSwitch(level, direction(), options.screen) : Result<Viewpoint>(near);
            if (!far)
                return far.error();
            Result<SheetCell> cell = cellOf(renderer, atSwitch ? levelsAt(level) : std::vector<unsigned>{level}, paint,
                                            far.value(), atSwitch);
            if (!cell)
                return cell.error();
            row.cells.push_back(std::move(cell).value());
        }
    return row;
}

/// Where the levels come from, as far as that is to be said.
std::string sourceOf(bool hasAutomaticLevels, std::size_t levels)
{
    if (!hasAutomaticLevels)
        return "";
    return levels > 1 ? "The file has no levels; these are the automatic ones. "
                      : "The file has no levels, and gets no automatic ones. ";
}

} // namespace

Result<Sheet> levelSheet(LevelRenderer& renderer, const std::vector<SeenLevel>& seen, const SeenOptions& options,
                         const std::string& name, bool hasAutomaticLevels)
{
    Sheet sheet;
    sheet.title = printable(name);
    sheet.notes = {sourceOf(hasAutomaticLevels, seen.size()) + "Levels appear on a screen "
                       + std::to_string(options.screen.height) + " pixels high.",
                   "Differences are of red, green and blue, 0 to 255. Means and coverage are over "
                       + std::to_string(kViewDirections) + " directions, largest ones of all of them."};
    if (!hasTextureCoordinates(*renderer.mesh()))
        sheet.notes.emplace_back("The mesh, or a part of it, has no texture coordinates to show a checker by.");
    sheet.columns = {"Close up, lit", "Close up, checker", "Where it appears, lit", "Where it appears, checker"};
    for (unsigned level = 0; level < seen.size(); ++level) {
        Result<SheetRow> row = rowOf(renderer, seen, level, options);
        if (!row)
            return row.error();
        sheet.rows.push_back(std::move(row).value());
    }
    return sheet;
}

} // namespace lodsmith::cli
