#pragma once

#include "Database.h"

#include "../MarkdownTable.h"

#include <string>
#include <vector>

namespace lodsmith::benchmarks {

/// What one table is about: the figures of one build, by its label, on one machine.
struct Scope {
    std::string label;
    std::string machine;
};

/// The machines of a label, or of the label with the newest run when it is empty. Empty when there are no runs of it.
std::vector<Scope> scopesOf(Database& database, const std::string& label);

/// The views made for people: those that begin with the columns label, machine and position.
std::vector<std::string> viewNames(Database& database);

/// A view's rows by position, without those three columns.
/// @param view   one of viewNames()
/// @param where  a column and the value that it has in all rows to be shown; it is left out then
struct Filter {
    std::string column;
    std::string value;
};
MarkdownTable viewTable(Database& database, const std::string& view, const Scope& scope,
                        const std::vector<Filter>& filters = {});

} // namespace lodsmith::benchmarks
