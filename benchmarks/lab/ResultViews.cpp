#include "ResultViews.h"

#include <algorithm>

namespace lodsmith::benchmarks {

namespace {

using soci::into;
using soci::session;
using soci::use;

std::vector<std::string> strings(session& session, const std::string& query)
{
    const soci::rowset<std::string> rows = session.prepare << query;
    return {rows.begin(), rows.end()};
}

/// Columns of a view that are shown.
std::vector<std::string> columnsOf(session& session, const std::string& view, const std::vector<Filter>& filters)
{
    std::vector<std::string> columns =
        strings(session, "SELECT name FROM pragma_table_info('" + view + "') WHERE cid > 2");
    for (const Filter& filter : filters)
        columns.erase(std::remove(columns.begin(), columns.end(), filter.column), columns.end());
    return columns;
}

/// Every column as text, so that the rows need no types.
std::string queryOf(const std::string& view, const std::vector<std::string>& columns,
                    const std::vector<Filter>& filters)
{
    std::string query = "SELECT ";
    for (const std::string& column : columns)
        query += (&column == &columns.front() ? "" : ", ") + ("coalesce(CAST(\"" + column + "\" AS TEXT), '-')");
    query += " FROM " + view + " WHERE label = :label AND machine = :machine";
    for (const Filter& filter : filters)
        query += " AND \"" + filter.column + "\" = '" + filter.value + "'";
    return query + " ORDER BY position";
}

} // namespace

std::vector<Scope> scopesOf(Database& database, const std::string& label)
{
    std::vector<Scope> scopes;
    database.use([&](session& session) {
        std::string wanted = label;
        if (wanted.empty())
            session << "SELECT coalesce((SELECT label FROM result ORDER BY run_id DESC LIMIT 1), '')", into(wanted);
        const soci::rowset<std::string> machines =
            (session.prepare
                 << "SELECT machine FROM result WHERE label = :label GROUP BY machine ORDER BY max(run_id) DESC",
             use(wanted));
        for (const std::string& machine : machines)
            scopes.push_back({wanted, machine});
    });
    return scopes;
}

std::vector<std::string> viewNames(Database& database)
{
    std::vector<std::string> names;
    database.use([&](session& session) {
        names = strings(session, "SELECT name FROM sqlite_master WHERE type = 'view' AND EXISTS "
                                 "(SELECT * FROM pragma_table_info(sqlite_master.name) WHERE name = 'position') "
                                 "ORDER BY rowid");
    });
    return names;
}

MarkdownTable viewTable(Database& database, const std::string& view, const Scope& scope,
                        const std::vector<Filter>& filters)
{
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;
    database.use([&](session& session) {
        columns = columnsOf(session, view, filters);
        const soci::rowset<soci::row> found =
            (session.prepare << queryOf(view, columns, filters), use(scope.label), use(scope.machine));
        for (const soci::row& row : found) {
            std::vector<std::string>& cells = rows.emplace_back();
            for (std::size_t column = 0; column < columns.size(); ++column)
                cells.push_back(row.get<std::string>(column));
        }
    });
    MarkdownTable table(columns);
    for (std::vector<std::string>& cells : rows)
        table.addRow(std::move(cells));
    return table;
}

} // namespace lodsmith::benchmarks
