#pragma once

#include <string>
#include <vector>

namespace lodsmith::cli {

/// Text in columns: the first row is the heading; every column is as wide as it has to be.
class Table {
public:
    explicit Table(std::vector<std::string> heading);

    /// A row of at most as many cells as the heading has.
    void add(std::vector<std::string> row);

    /// All rows, columns two blanks apart, numbers' ends under each other (cells are set to the right, the first
    /// column's too), each row ending in a line break and in no blanks.
    std::string text() const;

private:
    std::vector<std::vector<std::string>> mRows;
};

/// A text from a file or a file's name without control characters, which a terminal would obey.
std::string printable(const std::string& text);

} // namespace lodsmith::cli
