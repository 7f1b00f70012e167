#include "Database.h"

#include "SchemaSteps.h"

#include <soci/sqlite3/soci-sqlite3.h>

#include <filesystem>

namespace lodsmith::benchmarks {

namespace {

/// "LOD1" in the file's header, by which a benchmark database is told from those of other programs.
constexpr int kApplicationId = 0x4c4f4431;

/// Longer than any transaction takes.
constexpr const char* kPatience = "60000";

std::string troubleOf(const soci::sqlite3_soci_error& error)
{
    switch (error.result() & 0xff) { // without the extended part of the code
    case SQLITE_NOTADB: return "is no database";
    case SQLITE_CANTOPEN: return "cannot be opened";
    case SQLITE_READONLY: return "cannot be written to";
    case SQLITE_FULL: return "cannot be written: the disk is full";
    case SQLITE_IOERR: return "cannot be read or written";
    case SQLITE_BUSY: return "is locked by another process";
    case SQLITE_CORRUPT: return "is damaged";
    default: return error.what();
    }
}

/// The path as SOCI's connection string takes it.
std::string connection(const std::string& path)
{
    if (path.find('"') != std::string::npos)
        throw DatabaseError(path + ": the name of a database has no quotation marks");
    return "dbname=\"" + path + "\"";
}

/// One statement at a time, which is what SOCI takes. No step has a semicolon at a line's end within a statement.
void runAll(soci::session& session, const std::string& statements)
{
    std::size_t begin = 0;
    for (std::size_t end = 0; (end = statements.find(";\n", begin)) != std::string::npos; begin = end + 2)
        session << statements.substr(begin, end - begin);
}

int pragma(soci::session& session, const std::string& name)
{
    int value = 0;
    session << "PRAGMA " + name, soci::into(value);
    return value;
}

} // namespace

Database::Database(const std::string& path, Mode mode) : mPath(path)
{
    const std::string target = connection(path);
    if (mode == Mode::Existing && !std::filesystem::exists(path))
        throw DatabaseError(path + ": no such database");
    use([&](soci::session& session) {
        session.open(soci::sqlite3, target);
        session << std::string("PRAGMA busy_timeout = ") + kPatience;
        session << "PRAGMA foreign_keys = ON";
        checkIdentity();
    });
    migrate();
}

void Database::use(const std::function<void(soci::session&)>& work)
{
    try {
        work(mSession);
    } catch (const soci::sqlite3_soci_error& error) {
        throw DatabaseError(mPath + ": " + troubleOf(error));
    } catch (const soci::soci_error& error) {
        throw DatabaseError(mPath + ": " + error.what());
    }
}

void Database::change(const std::function<void(soci::session&)>& work)
{
    use([&](soci::session& session) {
        session << "BEGIN IMMEDIATE";
        try {
            work(session);
            session << "COMMIT";
        } catch (...) {
            try {
                session << "ROLLBACK";
            } catch (const soci::soci_error&) {
                // SQLite has rolled back by itself, as it does when the disk is full. The first error is the one to tell.
            }
            throw;
        }
    });
}

void Database::checkIdentity()
{
    int tables = 0;
    mSession << "SELECT count(*) FROM sqlite_master", soci::into(tables);
    if (tables > 0 && pragma(mSession, "application_id") != kApplicationId)
        throw DatabaseError(mPath + ": is another program's database");
    const int version = pragma(mSession, "user_version"), known = int(schemaSteps().size());
    if (version > known)
        throw DatabaseError(mPath + ": has schema version " + std::to_string(version)
                            + ", written by a newer lodsmith_lab; this one knows versions up to "
                            + std::to_string(known));
}

void Database::migrate()
{
    const auto isCurrent = [&] {
        int version = 0;
        use([&](soci::session& session) { version = pragma(session, "user_version"); });
        return version == int(schemaSteps().size());
    };
    if (isCurrent())
        return;
    change([&](soci::session& session) {
        // Looked at again: another process may have done it in the meantime.
        for (auto step = std::size_t(pragma(session, "user_version")); step < schemaSteps().size(); ++step)
            runAll(session, schemaSteps()[step]);
        session << "PRAGMA application_id = " + std::to_string(kApplicationId);
        session << "PRAGMA user_version = " + std::to_string(schemaSteps().size());
    });
}

} // namespace lodsmith::benchmarks
