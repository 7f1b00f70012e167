#include "OverviewPage.h"

#include "Figures.h"
#include "HtmlText.h"
#include "MeshPage.h"
#include "PageParts.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

namespace lodsmith::cli {

namespace {

std::string cell(const std::string& html, double value)
{
    return "<td data-value=\"" + Json(value).dump() + "\">" + html + "</td>";
}

std::string levelsFrom(const Json& mesh)
{
    const std::string from = mesh["levels_from"].get<std::string>();
    return from == "file" ? "" : "<small>" + from + "</small>";
}

std::string nameCell(const Json& mesh)
{
    const std::filesystem::path path = mesh["mesh"].get<std::string>();
    std::string name = nameElement(path.filename().string());
    if (mesh["page"].is_string())
        name = "<a href=\"" + escaped(mesh["page"].get<std::string>()) + "\">" + name + "</a>";
    std::string picture;
    if (mesh["thumbnail"].is_string())
        picture = "<img alt=\"\" loading=\"lazy\" width=\"48\" height=\"48\" src=\""
                  + escaped(mesh["thumbnail"].get<std::string>()) + "\">";
    return "<th scope=\"row\" data-value=\"" + escaped(path.string()) + "\"><div>" + picture + "<span>" + name
           + "<span class=\"where\">" + nameElement(path.parent_path().string()) + "</span></span></div></th>";
}

std::string savedCells(const Json& drawn)
{
    const double now = drawn["now"].get<double>(), saved = drawn["saved"].get<double>();
    const double share = now > 0.0 ? std::max(saved / now, 0.0) : 0.0;
    return cell(saved > 0.0 ? wholeNumber(saved) : "–", saved)
           + cell((saved > 0.0 ? percentage(share) : "–")
                      + "<span class=\"bar\"><span style=\"width:" + coordinate(100.0 * share) + "%\"></span></span>",
                  share);
}

std::string row(const Json& mesh)
{
    if (!mesh["error"].is_null())
        return "<tr>" + nameCell(mesh) + "<td class=\"words off\" colspan=\"8\">"
               + escaped(mesh["error"].get<std::string>()) + "</td></tr>\n";
    const double error = largestVisibleError(mesh);
    const double warnings = static_cast<double>(mesh["warnings"].size());
    const std::string errorText = mesh["levels"].size() > 1 ? shortNumber(error) : "–";
    return "<tr>" + nameCell(mesh) + savedCells(mesh["drawn"])
           + cell(wholeNumber(mesh["drawn"]["now"].get<double>()), mesh["drawn"]["now"].get<double>())
           + cell(wholeNumber(mesh["drawn"]["automatic"].get<double>()), mesh["drawn"]["automatic"].get<double>())
           + cell(wholeNumber(mesh["statistics"]["triangles"].get<double>()),
                  mesh["statistics"]["triangles"].get<double>())
           + cell(std::to_string(mesh["levels"].size() - 1) + levelsFrom(mesh),
                  static_cast<double>(mesh["levels"].size()))
           + cell(error > mesh["pixel_budget"].get<double>() ? "<span class=\"off\">" + errorText + "</span>"
                                                             : errorText,
                  error)
           + cell(warnings > 0.0 ? "<span class=\"off\">" + wholeNumber(warnings) + "</span>" : "0", warnings)
           + "</tr>\n";
}

/// Most to be saved first; then by path, so that the order is always the same.
bool comesBefore(const Json* a, const Json* b)
{
    const auto saved = [](const Json& mesh) {
        return mesh["error"].is_null() ? mesh["drawn"]["saved"].get<double>() : -HUGE_VAL;
    };
    const double x = saved(*a), y = saved(*b);
    return x != y ? x > y : (*a)["mesh"].get<std::string>() < (*b)["mesh"].get<std::string>();
}

std::string meshTable(const Json& meshes)
{
    std::vector<const Json*> order;
    for (const Json& mesh : meshes)
        order.push_back(&mesh);
    std::stable_sort(order.begin(), order.end(), comesBefore);
    std::string html = "<table class=\"meshes sortable\">\n<thead><tr><th scope=\"col\">Mesh</th>";
    html += "<th scope=\"col\" aria-sort=\"descending\">Can be saved <small>triangles</small></th>"
            "<th scope=\"col\">Saved <small>share</small></th>"
            "<th scope=\"col\">Drawn now <small>on average</small></th>"
            "<th scope=\"col\">Automatic <small>on average</small></th>"
            "<th scope=\"col\">Triangles</th>"
            "<th scope=\"col\">Levels</th>"
            "<th scope=\"col\">Visible error <small>pixels</small></th>"
            "<th scope=\"col\">Warnings</th></tr></thead>\n<tbody>\n";
    for (const Json* mesh : order)
        html += row(*mesh);
    return tableFrame("Meshes", html + "</tbody>\n</table>\n");
}

std::string totals(const Json& totals)
{
    const double now = totals["drawn_now"].get<double>(), saved = totals["saved"].get<double>();
    const double failed = totals["failed"].get<double>();
    std::vector<std::pair<std::string, std::string>> figures{
        {"Meshes", wholeNumber(totals["meshes"].get<double>())
                       + (failed > 0.0 ? "<small class=\"off\">" + wholeNumber(failed) + " failed</small>" : "")},
        {"Drawn on average", wholeNumber(now) + "<small>triangles of all meshes, over all distances</small>"},
        {"Can be saved", (saved > 0.0 ? percentage(saved / now) : std::string("nothing")) + "<small>"
                             + wholeNumber(saved) + " triangles</small>"},
        {"Without levels", wholeNumber(totals["without_levels"].get<double>())},
        {"Above the budget", wholeNumber(totals["above_budget"].get<double>())
                                 + "<small>have a level off by more than the pixels allowed</small>"},
        {"Warnings", wholeNumber(totals["warnings"].get<double>())}};
    return keyFigures(figures);
}

} // namespace

std::string overviewPage(const Json& report)
{
    return htmlPage("Levels of detail",
                    "<nav></nav>\n<header><h1>Levels of detail</h1></header>\n<main>\n" + totals(report["totals"])
                        + "<h2>Meshes</h2>\n<p class=\"aside\">What can be saved: triangles drawn on average over all "
                          "distances, as the file is, less those with automatic levels.</p>\n"
                        + meshTable(report["meshes"]) + "</main>\n" + reportFooter());
}

} // namespace lodsmith::cli
