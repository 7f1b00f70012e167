#include "ReportWarnings.h"

#include "../Numbers.h"

#include <cstdint>
#include <string>

namespace lodsmith::cli {

namespace {

constexpr double kLittleSaved = 0.8;     // share of the level before that a level still draws
constexpr double kSeamFactor = 1.5;      // times as many triangles as the mere shape needs
constexpr double kMissingExcess = 4.0;   // times as many triangles as the automatic levels draw
constexpr double kLeastCoverage = 0.95;  // share of level 0's pixels that a level covers where it appears
constexpr double kWorthLevels = 500.0;   // triangles below which nobody needs levels
constexpr double kWastedVertices = 0.05; // share of the buffers that no triangle uses

class Warnings {
public:
    Warnings(const Json& record, double pixelBudget) : mRecord(record), mBudget(pixelBudget) {}

    Json all()
    {
        geometry();
        pictures();
        chain();
        for (std::size_t i = 1; i < mRecord["levels"].size(); ++i)
            level(i);
        return mWarnings;
    }

private:
    void add(const char* code, const Json& level, const std::string& text)
    {
        mWarnings.push_back(Json{{"code", code}, {"level", level}, {"text", text}});
    }

    void geometry();
    void pictures();
    void chain();
    void seams();
    void level(std::size_t number);
    void coverage(std::size_t number);
    void damage(std::size_t number);

    static std::string count(const Json& number, const std::string& one, const std::string& many)
    {
        const auto value = number.get<std::uint64_t>();
        return std::to_string(value) + " " + (value == 1 ? one : many);
    }

    static bool above(const Json& number, double limit) { return number.get<double>() > limit; }

    const Json& mRecord;
    double mBudget;
    Json mWarnings = Json::array();
};

void Warnings::geometry()
{
    const Json& mesh = mRecord["statistics"];
    if (above(mesh["non_manifold_edges"], 0))
        add("non_manifold", nullptr,
            count(mesh["non_manifold_edges"], "edge has", "edges have")
                + " more than two triangles (non-manifold): nothing across them can be simplified freely.");
    if (above(mesh["inconsistent_edges"], 0))
        add("inconsistent_winding", nullptr,
            "The two triangles of " + count(mesh["inconsistent_edges"], "edge run", "edges run")
                + " the same way along it (inconsistent winding): one of them faces inwards.");
    if (above(mesh["degenerate_triangles"], 0))
        add("degenerate_triangles", nullptr,
            count(mesh["degenerate_triangles"], "triangle has", "triangles have") + " no area and draw nothing.");
    if (above(mesh["repeated_triangles"], 0))
        add("repeated_triangles", nullptr,
            count(mesh["repeated_triangles"], "triangle is", "triangles are") + " there twice.");
    if (above(mesh["unreferenced_vertices"], kWastedVertices * mesh["buffer_vertices"].get<double>()))
        add("unused_vertices", nullptr,
            count(mesh["unreferenced_vertices"], "vertex is", "vertices are") + " in the buffers and in no triangle.");
}

void Warnings::pictures()
{
    if (mRecord.contains("picture_notes"))
        for (const Json& note : mRecord["picture_notes"])
            add("materials", nullptr, "In the pictures: " + note.get<std::string>() + ".");
}

void Warnings::chain()
{
    const Json& drawn = mRecord["drawn"];
    if (mRecord["levels_from"] != "file" && above(mRecord["statistics"]["triangles"], kWorthLevels))
        add("no_levels", nullptr, "The file has no levels: all its triangles are drawn at every distance.");
    if (mRecord["levels_from"] == "file" && above(drawn["worst_excess"], kMissingExcess))
        add("missing_level", nullptr,
            "A level is missing: at a distance of " + formatNumber(drawn["worst_excess_from"].get<double>(), 3)
                + " the mesh draws " + formatNumber(drawn["worst_excess"].get<double>(), 2)
                + " times as many triangles as the automatic levels.");
    seams();
}

void Warnings::seams()
{
    const Json& mesh = mRecord["statistics"];
    const double seamEdges = mesh["uv_seam_edges"].get<double>() + mesh["normal_seam_edges"].get<double>();
    if (seamEdges > 0.0 && above(mRecord["seam_factor"], kSeamFactor))
        add("seams", nullptr,
            "Seams hold the reduction back: with them the same deviation takes "
                + formatNumber(mRecord["seam_factor"].get<double>(), 2)
                + " times as many triangles as the shape alone. " + count(mesh["uv_seam_edges"], "edge is", "edges are")
                + " on seams of the texture, " + count(mesh["normal_seam_edges"], "is", "are") + " hard, of "
                + count(mesh["edges"], "edge", "edges") + " in all.");
}

void Warnings::level(std::size_t number)
{
    const Json& level = mRecord["levels"][number];
    const std::string name = "Level " + std::to_string(number);
    const double before = mRecord["levels"][number - 1]["triangles"].get<double>();
    if (level["triangles"].get<double>() > kLittleSaved * before)
        add("saves_little", number,
            name + " still draws " + formatNumber(100.0 * level["triangles"].get<double>() / before, 3)
                + " % of the triangles of the level before: it costs memory and a switch, and saves little.");
    if (above(level["visible_error"], mBudget))
        add("visible_error", number,
            name + " is off by up to " + formatNumber(level["visible_error"].get<double>(), 3)
                + " pixels where it appears, above the budget of " + formatNumber(mBudget, 3) + ".");
    if (!level["stop"].is_null())
        if (const std::string reason = stopSentence(level["stop"].get<std::string>()); !reason.empty())
            add("stopped", number, name + " stopped before its target: " + reason + ".");
    if (mRecord.contains("seen") && mRecord["seen"].is_array())
        coverage(number);
    damage(number);
}

void Warnings::coverage(std::size_t number)
{
    const Json& there = mRecord["seen"][number]["at_switch"];
    if (there.is_null())
        return; // it never appears
    const Json& share = there["lit"]["coverage"];
    if (share.is_number() && share.get<double>() < kLeastCoverage)
        add("thins_out", number,
            "Level " + std::to_string(number) + " covers only " + formatNumber(100.0 * share.get<double>(), 3)
                + " % of the pixels of the original where it appears: it thins out.");
}

void Warnings::damage(std::size_t number)
{
    const Json& level = mRecord["levels"][number];
    const std::string name = "Level " + std::to_string(number);
    if (above(level["flipped_triangles"], 0))
        add("flipped", number,
            name + " has " + count(level["flipped_triangles"], "triangle that faces", "triangles that face")
                + " the wrong way.");
    // A level remodelled by hand has borders of its own.
    if (!level["manual"].is_null())
        return;
    if (above(level["new_border_edges"], 0))
        add("cracks", number,
            name + " has " + count(level["new_border_edges"], "open edge", "open edges")
                + " that the original does not have: cracks or holes.");
    if (above(level["new_non_manifold_edges"], 0))
        add("new_non_manifold", number,
            name + " has " + count(level["new_non_manifold_edges"], "non-manifold edge", "non-manifold edges")
                + " that the original does not have.");
}

} // namespace

Json warningsOf(const Json& record, double pixelBudget)
{
    return Warnings(record, pixelBudget).all();
}

} // namespace lodsmith::cli
