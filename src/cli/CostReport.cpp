#include "CostReport.h"

#include "Numbers.h"
#include "Table.h"

#include <cstdint>

namespace lodsmith::cli {

namespace {

constexpr double kKibibyte = 1024.0;

std::string number(const Json& value, int digits)
{
    return value.is_null() ? "-" : formatNumber(value.get<double>(), digits);
}

std::string count(const Json& value)
{
    return value.is_null() ? "-" : std::to_string(value.get<std::uint64_t>());
}

std::string percent(const Json& share)
{
    return formatNumber(100.0 * share.get<double>(), 3) + " %";
}

std::string levelTable(const Json& record)
{
    Table table(
        {"level", "from m", "triangles", "bytes", "zlib", "duplicates", "counts as", "share", "cost", "cost of a KiB"});
    for (const Json& level : record["levels"])
        table.add({count(level["level"]), number(level["distance"], 4), count(level["triangles"]),
                   count(level["bytes"]), count(level["zlib_bytes"]), count(level["duplicate_bytes"]),
                   number(level["counted_triangles"], 6), percent(level["share"]), number(level["cost"], 5),
                   formatNumber(kKibibyte * level["cost_per_byte"].get<double>(), 4)});
    table.add({"all", "", "", count(record["bytes"]), count(record["zlib_bytes"]), count(record["duplicate_bytes"]),
               number(record["weighted_triangles"], 6), "100 %", number(record["cost"], 5)});
    return table.text();
}

std::string heading(const Json& record)
{
    const Json& strategy = record["strategy"];
    return printable(record["input"].get<std::string>()) + ": costs " + number(record["cost"], 5) + " (preset "
           + record["preset"].get<std::string>() + ", " + record["sizes"].get<std::string>() + " bytes, radius "
           + number(record["radius"], 4) + " m, levels by "
           + (strategy.is_null() ? "the preset's ratios" : printable(strategy.get<std::string>())) + ")\n";
}

std::string advice(const Json& record)
{
    std::string text;
    if (record["levels"].size() > 1 && !record["shrink_first"].is_null())
        text += "shrink first: level " + count(record["shrink_first"]) + "\n";
    for (const Json& note : record["notes"])
        text += "note: " + printable(note.get<std::string>()) + "\n";
    return text;
}

std::string seenTable(const Json& seen)
{
    if (seen.empty())
        return "";
    Table table({"at m", "level", "bytes"});
    for (const Json& place : seen)
        table.add({number(place["distance"], 6), count(place["level"]), count(place["bytes"])});
    return table.text();
}

std::string cheapestTable(const Json& cheapest)
{
    if (cheapest.is_null())
        return "";
    std::string text = "cheapest within " + number(cheapest["pixels"], 4) + " pixels: costs "
                       + number(cheapest["cost"], 5) + ", " + number(cheapest["bytes"], 12) + " bytes\n";
    if (cheapest["levels"].empty())
        return text + "  no levels: none that may be shown would save anything\n";
    Table table({"from m", "pixels", "triangles", "deviation", "bytes", "share", "cost"});
    for (const Json& level : cheapest["levels"])
        table.add({number(level["distance"], 4), number(level["value"], 6), count(level["triangles"]),
                   number(level["deviation"], 4), number(level["bytes"], 12), percent(level["share"]),
                   number(level["cost"], 5)});
    return text + table.text() + "generate them with --strategy pixelcount --levels "
           + cheapest["option"].get<std::string>() + "\n";
}

} // namespace

std::string costReport(const Json& record)
{
    return heading(record) + levelTable(record) + advice(record) + seenTable(record["seen"])
           + cheapestTable(record["optimised"]);
}

} // namespace lodsmith::cli
