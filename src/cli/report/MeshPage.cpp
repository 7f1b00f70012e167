#include "MeshPage.h"

#include "Figures.h"
#include "HtmlText.h"
#include "MeshPlots.h"
#include "PageParts.h"

#include <algorithm>
#include <filesystem>
#include <functional>

namespace lodsmith::cli {

namespace {

double numberOf(const Json& value)
{
    return value.is_number() ? value.get<double>() : 0.0;
}

/// Where the levels come from, which everything else on the page depends on.
std::string origin(const Json& record)
{
    const std::string from = record["levels_from"].get<std::string>();
    if (from == "file")
        return "<p class=\"said\">Judged with the levels that are in the file.</p>\n";
    if (from == "definition")
        return "<p class=\"said\">The file has <strong>no levels</strong>. Judged with those that its definition "
               + nameElement(record["definition"].get<std::string>()) + " would give it.</p>\n";
    return "<p class=\"said\">The file has <strong>no levels</strong>. Judged with those that the automatic "
           "configuration would give it: <code>lodsmith generate</code> makes them.</p>\n";
}

std::string budgeted(double pixels, double budget)
{
    const std::string text = shortNumber(pixels) + "\u202Fpx";
    return pixels > budget ? "<span class=\"off\">" + text + "</span>" : text;
}

std::string keyFiguresOf(const Json& record)
{
    const Json& drawn = record["drawn"];
    const double now = drawn["now"].get<double>();
    const double saved = drawn["saved"].get<double>();
    std::vector<std::pair<std::string, std::string>> figures{
        {"Triangles", wholeNumber(record["statistics"]["triangles"].get<double>()) + "<small>"
                          + wholeNumber(record["statistics"]["vertices"].get<double>()) + " vertices</small>"},
        {"Drawn on average", wholeNumber(now) + "<small>triangles over all distances, as the file is</small>"},
        {"Can be saved", (saved > 0.0 ? percentage(saved / now) : std::string("nothing")) + "<small>"
                             + wholeNumber(drawn["automatic"].get<double>()) + " drawn with automatic levels</small>"},
        {"Largest visible error", record["levels"].size() > 1
                                      ? budgeted(largestVisibleError(record), record["pixel_budget"].get<double>())
                                            + "<small>where a level appears</small>"
                                      : std::string("–<small>there are no levels</small>")},
        {"File", byteCount(record["file_bytes"].get<double>())}};
    if (!record["cost"].is_null()) {
        std::string cost = shortNumber(record["cost"]["cost"].get<double>());
        if (record["levels_from"] != "file" && record["cost_now"].is_number())
            cost += "<small>" + shortNumber(record["cost_now"].get<double>()) + " as the file is</small>";
        figures.emplace_back("Streaming cost", cost);
    }
    return keyFigures(figures);
}

std::string warningList(const Json& record)
{
    std::string html = "<h2>Warnings</h2>\n";
    if (record["warnings"].empty())
        return html + "<p>None.</p>\n";
    html += "<ul class=\"warnings\">\n";
    for (const Json& warning : record["warnings"])
        html += "<li>" + escaped(warning["text"].get<std::string>()) + "</li>\n";
    return html + "</ul>\n";
}

/// One row of the table of levels: a figure, and what it is of the level of each number. Both are HTML.
struct LevelRow {
    std::string name;
    std::function<std::string(std::size_t level)> cell;
};

std::string orDash(const Json& value, const std::function<std::string(double)>& format)
{
    return value.is_number() ? format(value.get<double>()) : "–";
}

std::string stopWords(const Json& level)
{
    if (!level["manual"].is_null())
        return "hand-made: " + nameElement(level["manual"].get<std::string>());
    if (level["stop"].is_null())
        return "–";
    const std::string word = level["stop"].get<std::string>();
    return word == "target_reached" ? "target reached" : escaped(word);
}

using LevelRows = std::vector<LevelRow>;

/// A member of a level as a number in words, a dash where there is none.
LevelRow numberRow(const Json& levels, const std::string& name, const char* member, std::string (*format)(double))
{
    return {name, [&levels, member, format](std::size_t i) { return orDash(levels[i][member], format); }};
}

/// A count that is nothing to be proud of.
LevelRow faultRow(const Json& levels, const std::string& name, const char* member)
{
    return {name, [&levels, member](std::size_t i) {
                const double count = levels[i][member].get<double>();
                return count > 0.0 ? "<span class=\"off\">" + wholeNumber(count) + "</span>" : std::string("0");
            }};
}

LevelRow deviationRow(const Json& record, const std::string& name, const char* figure)
{
    const double radius = record["radius"].get<double>();
    const Json& levels = record["levels"];
    return {name, [&levels, figure, radius](std::size_t i) -> std::string {
                if (i == 0)
                    return "–";
                const double value = levels[i]["surface"][figure].get<double>();
                return shortNumber(value) + "<small>" + percentage(value / radius) + "</small>";
            }};
}

void addSwitchRows(const Json& record, LevelRows& rows)
{
    const Json& levels = record["levels"];
    const bool pixels = record["strategy"].get<std::string>().find("pixel") != std::string::npos;
    rows.push_back(numberRow(levels,
                             std::string("Appears at <small>") + (pixels ? "pixels covered" : "distance")
                                 + ", as in the file</small>",
                             "value", shortNumber));
    rows.push_back(numberRow(levels, "Distance <small>world units</small>", "distance", shortNumber));
    rows.push_back(numberRow(levels, "Radius there <small>pixels</small>", "screen_radius", shortNumber));
}

void addShapeRows(const Json& record, LevelRows& rows)
{
    const Json& levels = record["levels"];
    rows.push_back(numberRow(levels, "Triangles", "triangles", wholeNumber));
    rows.push_back(numberRow(levels, "Share <small>of level 0</small>", "share", percentage));
    rows.push_back(numberRow(levels, "Vertices", "vertices", wholeNumber));
    rows.push_back(deviationRow(record, "Deviation, mean <small>world units, share of the radius</small>", "mean"));
    rows.push_back(deviationRow(record, "Deviation, RMS", "rms"));
    rows.push_back(deviationRow(record, "Deviation, largest", "max"));
    const double budget = record["pixel_budget"].get<double>();
    rows.push_back({"Visible error <small>where it appears</small>", [&levels, budget](std::size_t i) {
                        return i == 0 ? "–" : budgeted(numberOf(levels[i]["visible_error"]), budget);
                    }});
    rows.push_back(faultRow(levels, "Cracks <small>new open edges</small>", "new_border_edges"));
    rows.push_back(faultRow(levels, "Flipped triangles", "flipped_triangles"));
    rows.push_back({"Stopped by", [&levels](std::size_t i) { return stopWords(levels[i]); }});
}

void addSeenRows(const Json& record, LevelRows& rows)
{
    const Json& seen = record["seen"];
    if (seen.is_null())
        return;
    const auto add = [&](const char* name, const char* moment, const char* figure, std::string (*format)(double)) {
        rows.push_back({name, [&seen, moment, figure, format](std::size_t i) {
                            const Json& there = seen[i][moment];
                            return i == 0 || there.is_null() ? "–" : orDash(there["lit"][figure], format);
                        }});
    };
    add("Likeness <small>SSIM with level 0, where it appears</small>", "at_switch", "ssim", shortNumber);
    add("Coverage <small>of level 0's pixels</small>", "at_switch", "coverage", percentage);
    add("Popping <small>SSIM with the level before</small>", "popping", "ssim", shortNumber);
}

void addCostRows(const Json& record, LevelRows& rows)
{
    if (record["cost"].is_null())
        return;
    const Json& levels = record["cost"]["levels"];
    rows.push_back({"Bytes <small>as zlib</small>", [&levels](std::size_t i) {
                        return byteCount(numberOf(levels[i]["bytes"])) + "<small>"
                               + byteCount(numberOf(levels[i]["zlib_bytes"])) + "</small>";
                    }});
    rows.push_back({"Streaming cost <small>share of the area</small>", [&levels](std::size_t i) {
                        return shortNumber(numberOf(levels[i]["cost"])) + "<small>"
                               + percentage(numberOf(levels[i]["share"])) + "</small>";
                    }});
}

LevelRows levelRows(const Json& record)
{
    LevelRows rows;
    addSwitchRows(record, rows);
    addShapeRows(record, rows);
    addSeenRows(record, rows);
    addCostRows(record, rows);
    return rows;
}

std::string levelTable(const Json& record)
{
    const Json& levels = record["levels"];
    std::string html = "<table class=\"by-level\">\n<thead><tr><th scope=\"col\">Level</th>";
    for (std::size_t i = 0; i < levels.size(); ++i)
        html += "<th scope=\"col\">" + std::to_string(i) + "</th>";
    html += "</tr></thead>\n<tbody>\n";
    for (const LevelRow& row : levelRows(record)) {
        html += "<tr><th scope=\"row\">" + row.name + "</th>";
        for (std::size_t i = 0; i < levels.size(); ++i)
            html += "<td>" + row.cell(i) + "</td>";
        html += "</tr>\n";
    }
    return "<h2>Levels</h2>\n" + tableFrame("Levels", html + "</tbody>\n</table>\n");
}

std::string picture(const Json& png, const std::string& style, const std::string& words)
{
    return "<img class=\"" + style + "\" alt=\"" + escaped(words) + "\" src=\"" + pngAddress(png.get<std::string>())
           + "\">";
}

std::string closeUp(std::size_t number, const Json& level, const Json& pictures)
{
    const std::string name = "Level " + std::to_string(number);
    const std::string triangles = wholeNumber(numberOf(level["triangles"])) + " triangles";
    return "<figure class=\"level\">" + picture(pictures["close"], "close", name + " close up, " + triangles)
           + "<figcaption><strong>" + name + "</strong> " + triangles + "</figcaption></figure>\n";
}

std::string closeUps(const Json& levels, const Json& pictures)
{
    std::string html = "<h2>Close up</h2>\n<div class=\"levels\">\n";
    for (std::size_t i = 0; i < pictures.size(); ++i)
        html += closeUp(i, levels[i], pictures[i]);
    return html + "</div>\n";
}

std::string levelSwitch(std::size_t number, const Json& level, const Json& pictures)
{
    const std::string before = "Level " + std::to_string(number - 1), after = "level " + std::to_string(number);
    return "<figure class=\"level\"><div>"
           + picture(pictures["before"], "switch", before + " where " + after + " appears")
           + picture(pictures["after"], "switch", "Level " + std::to_string(number) + " where it appears")
           + "</div><figcaption><strong>" + before + " → " + after + "</strong> at a distance of "
           + shortNumber(numberOf(level["distance"])) + ", with a radius of "
           + shortNumber(numberOf(level["screen_radius"])) + "\u202Fpx; off by up to "
           + shortNumber(numberOf(level["visible_error"])) + "\u202Fpx</figcaption></figure>\n";
}

std::string switches(const Json& levels, const Json& pictures)
{
    std::string html =
        "<h2>Where levels appear</h2>\n<p class=\"aside\">The level before and the new one, as large as they "
        "are on the screen at that moment: one pixel of these pictures is one of the screen, unless the page is "
        "too narrow.</p>\n<div class=\"switches\">\n";
    // A level that never appears has no such pictures.
    for (std::size_t i = 1; i < pictures.size(); ++i)
        if (pictures[i].contains("after"))
            html += levelSwitch(i, levels[i], pictures[i]);
    return html + "</div>\n";
}

std::string pictureSection(const Json& record, const Json& pictures)
{
    if (pictures.is_null())
        return "<h2>Pictures</h2>\n<p>There are none: " + escaped(record["no_pictures"].get<std::string>()) + "</p>\n";
    return closeUps(record["levels"], pictures) + (pictures.size() > 1 ? switches(record["levels"], pictures) : "");
}

std::string meshTable(const Json& record)
{
    std::string html = "<table class=\"facts\">\n<tbody>\n";
    const auto add = [&](const std::string& name, const std::string& value) {
        html += "<tr><th scope=\"row\">" + name + "</th><td>" + value + "</td></tr>\n";
    };
    for (const auto& [name, value] : record["statistics"].items()) {
        std::string words = name;
        std::replace(words.begin(), words.end(), '_', ' ');
        words = words.substr(0, 2) == "uv" ? "UV" + words.substr(2)
                                           : static_cast<char>(words[0] - 'a' + 'A') + words.substr(1);
        add(escaped(words), wholeNumber(value.get<double>()));
    }
    add("Radius <small>world units</small>", shortNumber(record["radius"].get<double>()));
    add("Triangles for seams <small>times as many as the shape alone needs</small>",
        shortNumber(record["seam_factor"].get<double>()));
    add("Least possible <small>triangles; then: " + escaped(record["least_stop"].get<std::string>()) + "</small>",
        wholeNumber(record["least_triangles"].get<double>()));
    return "<h2>The mesh</h2>\n" + tableFrame("The mesh", html + "</tbody>\n</table>\n");
}

std::string noteList(const Json& record)
{
    if (record["notes"].empty())
        return "";
    std::string html = "<h2>Notes</h2>\n<ul class=\"notes\">\n";
    for (const Json& note : record["notes"])
        html += "<li>" + escaped(note.get<std::string>()) + "</li>\n";
    return html + "</ul>\n";
}

} // namespace

double largestVisibleError(const Json& record)
{
    double largest = 0.0;
    for (const Json& level : record["levels"])
        largest = std::max(largest, level["visible_error"].get<double>());
    return largest;
}

std::string meshPage(const Json& record, const Json& pictures, const std::string& overview)
{
    const std::string path = record["mesh"].get<std::string>();
    const std::string name = std::filesystem::path(path).filename().string();
    std::string body = "<nav>";
    if (!overview.empty())
        body += "<a href=\"" + escaped(overview) + "\">All meshes</a>";
    body += "</nav>\n<header><h1>" + nameElement(name) + "</h1>\n<p class=\"path\">" + nameElement(path)
            + "</p></header>\n<main>\n";
    body += origin(record) + keyFiguresOf(record) + warningList(record) + pictureSection(record, pictures)
            + "<h2>What it takes</h2>\n<div class=\"plots\">\n" + plotFigure(deviationPlot(record))
            + plotFigure(distancePlot(record)) + "</div>\n" + levelTable(record) + meshTable(record) + noteList(record)
            + "</main>\n" + reportFooter();
    return htmlPage(name, body);
}

} // namespace lodsmith::cli
