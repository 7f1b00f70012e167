#include "Table.h"

#include <lodsmith/core/Assert.h>

#include <algorithm>

namespace lodsmith::cli {

Table::Table(std::vector<std::string> heading)
{
    mRows.push_back(std::move(heading));
}

void Table::add(std::vector<std::string> row)
{
    LODSMITH_ASSERT(row.size() <= mRows.front().size(), "a row is no longer than the heading");
    mRows.push_back(std::move(row));
}

std::string Table::text() const
{
    std::vector<std::size_t> widths(mRows.front().size(), 0);
    for (const auto& row : mRows)
        for (std::size_t column = 0; column < row.size(); ++column)
            widths[column] = std::max(widths[column], row[column].size());

    std::string text;
    for (const auto& row : mRows) {
        for (std::size_t column = 0; column < row.size(); ++column)
            text += std::string(column > 0 ? 2 : 0, ' ') + std::string(widths[column] - row[column].size(), ' ')
                    + row[column];
        text.erase(text.find_last_not_of(' ') + 1);
        text += '\n';
    }
    return text;
}

std::string printable(const std::string& text)
{
    std::string safe = text;
    std::replace_if(
        safe.begin(), safe.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
    return safe;
}

} // namespace lodsmith::cli
