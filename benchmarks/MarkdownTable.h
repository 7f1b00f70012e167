#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace lodsmith::benchmarks {

/// A Markdown table whose columns line up as plain text too.
class MarkdownTable {
public:
    explicit MarkdownTable(std::vector<std::string> header) : mHeader(std::move(header)) {}

    /// Missing cells at the end stay empty.
    void addRow(std::vector<std::string> cells) { mRows.push_back(std::move(cells)); }
    void print(std::ostream& out) const;

private:
    std::vector<std::string> mHeader;
    std::vector<std::vector<std::string>> mRows;
};

/// `value` with `digits` digits behind the point, "-" for NaN.
std::string fixed(double value, int digits);

} // namespace lodsmith::benchmarks
