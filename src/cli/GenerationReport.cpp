#include "GenerationReport.h"

#include "Numbers.h"
#include "Table.h"

#include <cstdint>

namespace lodsmith::cli {

namespace {

std::string number(const Json& value, int digits = 6)
{
    return value.is_null() ? "-" : formatNumber(value.get<double>(), digits);
}

std::string count(const Json& value)
{
    return std::to_string(value.get<std::uint64_t>());
}

std::string percent(double part, double whole)
{
    return whole > 0.0 ? formatNumber(100.0 * part / whole, 3) + " %" : "-";
}

std::string milliseconds(const Json& value)
{
    return formatNumber(value.get<double>(), 4) + " ms";
}

std::vector<std::string> levelRow(std::size_t index, const Json& level, const Json& record)
{
    const Json& deviation = level["deviation"];
    const double radius = record["radius"].get<double>();
    return {std::to_string(index),
            number(level["value"]),
            count(level["vertices"]),
            count(level["triangles"]),
            percent(level["triangles"].get<double>(), record["triangles"].get<double>()),
            number(deviation, 4),
            deviation.is_null() ? "-" : percent(deviation.get<double>(), radius),
            count(level["bytes"])};
}

std::string levelTable(const Json& record)
{
    const bool pixels = record["strategy"].get<std::string>().find("pixel") != std::string::npos;
    Table table(
        {"level", pixels ? "pixels" : "distance", "vertices", "triangles", "share", "deviation", "of radius", "bytes"});
    for (std::size_t i = 0; i < record["levels"].size(); ++i)
        table.add(levelRow(i, record["levels"][i], record));
    return table.text();
}

std::string times(const Json& record, unsigned repeat)
{
    std::string text = "read " + milliseconds(record["read_ms"])
                       + (record["cached"].get<bool>() ? ", taken from the cache " : ", generated ")
                       + milliseconds(record["generate_ms"]);
    if (repeat > 1)
        text += " (median of " + std::to_string(repeat) + ", least " + milliseconds(record["generate_min_ms"]) + ")";
    text += ", of it vertex-cache order " + milliseconds(record["order_ms"]) + ", written "
            + milliseconds(record["write_ms"]);
    if (!record["peak_kb"].is_null())
        text += ", memory +" + count(record["peak_kb"]) + " KiB";
    return text + "\n";
}

std::string remark(std::size_t index, const Json& level)
{
    const std::string name = "level " + std::to_string(index) + ": ";
    if (!level["manual"].is_null())
        return name + "hand-made, " + printable(level["manual"].get<std::string>()) + "\n";
    std::string text;
    if (!level["separate"].is_null())
        text += name + "a mesh of its own, " + printable(level["separate"].get<std::string>()) + ", covers "
                + percent(level["coverage"].get<double>(), 1.0) + " of what the original does\n";
    if (level["skipped"].get<bool>())
        text += name + "not stored, it removes nothing beyond the level before\n";
    if (!level["stop"].is_null())
        if (const std::string reason = stopSentence(level["stop"].get<std::string>()); !reason.empty())
            text += name + "stopped before its target: " + reason + "\n";
    return text;
}

std::string cleaned(const Json& record)
{
    const Json& counts = record["cleaned"];
    std::string text;
    const auto add = [&](const char* member, const std::string& what) {
        if (counts[member].get<std::uint64_t>() > 0)
            text += (text.empty() ? "" : ", ") + count(counts[member]) + " " + what;
    };
    add("degenerate_triangles", "degenerate triangles");
    add("repeated_triangles", "repeated triangles");
    return text.empty() ? "" : "left out of the levels: " + text + "\n";
}

} // namespace

std::string generationReport(const Json& record, unsigned repeat)
{
    std::string text =
        printable(record["input"].get<std::string>()) + " -> " + printable(record["output"].get<std::string>());
    if (record["up_to_date"].get<bool>())
        return text + ": up to date";
    text += "\n";
    if (!record["loddef"].is_null())
        text += "levels as " + printable(record["loddef"].get<std::string>()) + " says\n";
    text += levelTable(record) + times(record, repeat);
    for (std::size_t i = 0; i < record["levels"].size(); ++i)
        text += remark(i, record["levels"][i]);
    text += cleaned(record);
    for (const Json& note : record["notes"])
        text += "note: " + printable(note.get<std::string>()) + "\n";
    return text;
}

} // namespace lodsmith::cli
