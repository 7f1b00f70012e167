#include "MarkdownTable.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>

namespace lodsmith::benchmarks {

namespace {

void printRow(std::ostream& out, const std::vector<std::string>& cells, const std::vector<std::size_t>& widths)
{
    for (std::size_t column = 0; column < widths.size(); ++column) {
        const std::string cell = column < cells.size() ? cells[column] : "";
        const std::string padding(widths[column] - cell.size(), ' ');
        out << "| " << (column == 0 ? cell + padding : padding + cell) << ' ';
    }
    out << "|\n";
}

} // namespace

void MarkdownTable::print(std::ostream& out) const
{
    std::vector<std::size_t> widths;
    for (const std::string& title : mHeader)
        widths.push_back(std::max<std::size_t>(title.size(), 4));
    for (const auto& row : mRows)
        for (std::size_t column = 0; column < row.size(); ++column)
            widths[column] = std::max(widths[column], row[column].size());

    std::vector<std::string> rules;
    for (std::size_t column = 0; column < widths.size(); ++column)
        rules.push_back(std::string(widths[column] - 1, '-') + (column == 0 ? '-' : ':'));
    printRow(out, mHeader, widths);
    printRow(out, rules, widths);
    for (const auto& row : mRows)
        printRow(out, row, widths);
    out << '\n';
}

std::string fixed(double value, int digits)
{
    if (std::isnan(value))
        return "-";
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    return text;
}

} // namespace lodsmith::benchmarks
