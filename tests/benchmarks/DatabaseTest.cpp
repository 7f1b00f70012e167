#include "Database.h"

#include "ResultViews.h"
#include "SchemaSteps.h"
#include "StoredRuns.h"

#include "support/Child.h"
#include "support/TestDirectory.h"

#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include <sys/stat.h>
#include <unistd.h>

namespace lodsmith::benchmarks {

namespace {

using lodsmith::test::contentOf;
using lodsmith::test::inChild;
using lodsmith::test::TestDirectory;
using soci::into;
using soci::session;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class DatabaseTest : public testing::Test {
protected:
    /// What is said when a database cannot be opened; empty when it can.
    std::string trouble(Database::Mode mode = Database::Mode::MakeIfAbsent) const
    {
        try {
            Database(path(), mode);
            return "";
        } catch (const DatabaseError& error) {
            return error.what();
        }
    }

    /// Writes a database without this program's part in it.
    void write(const std::string& statements) const
    {
        session session;
        session.open("sqlite3", "dbname=\"" + path() + "\"");
        std::istringstream lines(statements);
        std::string statement;
        for (std::string line; std::getline(lines, line);) {
            statement += line + '\n';
            if (!line.empty() && line.back() == ';' && line.rfind("--", 0) != 0) {
                session << statement;
                statement.clear();
            }
        }
    }

    std::string path() const { return (mDirectory / "lab results.db").string(); }

    TestDirectory mDirectory;
};

int number(Database& database, const std::string& query)
{
    int value = -1;
    database.use([&](session& session) { session << query, into(value); });
    return value;
}

TEST_F(DatabaseTest, isMadeWithTheNewestSchema)
{
    Database database(path(), Database::Mode::MakeIfAbsent);
    EXPECT_EQ(number(database, "PRAGMA user_version"), int(schemaSteps().size()));
    EXPECT_THAT(viewNames(database), testing::IsSupersetOf({"speed_up", "quality", "worst_cases"}));
    EXPECT_THAT(scopesOf(database, ""), IsEmpty());
}

TEST_F(DatabaseTest, ofVersionOneKeepsWhatItHas)
{
    write(contentOf(LODSMITH_TEST_DATA "/version1.sql"));
    Database database(path(), Database::Mode::Existing);
    EXPECT_EQ(number(database, "PRAGMA user_version"), 2);
    EXPECT_EQ(number(database, "SELECT count(*) FROM run"), 4);
    EXPECT_EQ(number(database, "SELECT count(*) FROM round"), 12);
    EXPECT_EQ(number(database, "SELECT count(*) FROM level"), 16);
    const std::vector<Scope> scopes = scopesOf(database, "");
    ASSERT_EQ(scopes.size(), 1U);
    EXPECT_EQ(scopes[0].label, "first");
    const StoredRuns runs = readRuns(database, scopes[0].label, scopes[0].machine);
    ASSERT_EQ(runs.size(), 4U);
    const auto& [key, run] = *runs.begin();
    EXPECT_EQ(key.mesh, "planet-1k");
    EXPECT_THAT(run.processor, IsEmpty()); // which version 1 did not measure
    EXPECT_THAT(run.reference, IsEmpty());
    EXPECT_EQ(run.levels.size(), 4U);
    for (const std::string& view : viewNames(database))
        EXPECT_NO_THROW(viewTable(database, view, scopes[0])) << view;
}

TEST_F(DatabaseTest, ofVersionOneHasTheSchemaOfANewOneAfterwards)
{
    write(contentOf(LODSMITH_TEST_DATA "/version1.sql"));
    Database old(path(), Database::Mode::Existing);
    Database made((mDirectory / "new.db").string(), Database::Mode::MakeIfAbsent);
    const auto schemaOf = [](Database& database) {
        std::string all;
        database.use([&](session& session) {
            session << "SELECT group_concat(name || sql, char(10)) FROM (SELECT name, sql FROM sqlite_master "
                       "WHERE sql IS NOT NULL ORDER BY name)",
                into(all);
        });
        return all;
    };
    EXPECT_EQ(schemaOf(old), schemaOf(made));
}

TEST_F(DatabaseTest, ofANewerVersionIsLeftAlone)
{
    {
        Database database(path(), Database::Mode::MakeIfAbsent);
    }
    write("PRAGMA user_version = 99;\n");
    const std::string before = contentOf(path());
    EXPECT_THAT(trouble(), StartsWith(path() + ": has schema version 99, written by a newer lodsmith_lab"));
    EXPECT_EQ(contentOf(path()), before);
}

TEST_F(DatabaseTest, ofAnotherProgramIsLeftAlone)
{
    write("CREATE TABLE song (title TEXT);\n");
    EXPECT_EQ(trouble(), path() + ": is another program's database");
}

TEST_F(DatabaseTest, thatIsNoneIsSaidToBeNone)
{
    mDirectory.write("lab results.db", std::string(5000, 'x'));
    EXPECT_EQ(trouble(), path() + ": is no database");
    EXPECT_EQ(contentOf(path()), std::string(5000, 'x'));
}

TEST_F(DatabaseTest, thatDoesNotExistIsNotMadeForReading)
{
    EXPECT_EQ(trouble(Database::Mode::Existing), path() + ": no such database");
    EXPECT_THAT(mDirectory.files(), IsEmpty());
}

TEST_F(DatabaseTest, inADirectoryThatIsNotThereCannotBeOpened)
{
    EXPECT_THROW(Database((mDirectory / "none" / "lab.db").string(), Database::Mode::MakeIfAbsent), DatabaseError);
}

TEST_F(DatabaseTest, thatIsReadOnlyCanBeReadAndNotChanged)
{
    {
        Database database(path(), Database::Mode::MakeIfAbsent);
    }
    ::chmod(path().c_str(), 0444);
    ::chmod(mDirectory.path().c_str(), 0555);
    EXPECT_TRUE(inChild([&] {
        constexpr uid_t kNobody = 65534; // root may write anywhere
        if (::geteuid() == 0 && (::setgid(kNobody) != 0 || ::setuid(kNobody) != 0))
            return false;
        Database database(path(), Database::Mode::Existing);
        if (number(database, "SELECT count(*) FROM run") != 0)
            return false;
        try {
            database.change([](session& session) { session << "DELETE FROM run"; });
        } catch (const DatabaseError& error) {
            return error.what() == path() + ": cannot be written to";
        }
        return false;
    }));
    ::chmod(mDirectory.path().c_str(), 0755);
}

TEST_F(DatabaseTest, onAFullDiskKeepsWhatItHad)
{
    Database database(path(), Database::Mode::MakeIfAbsent);
    const auto fill = [](session& session) {
        for (int i = 0; i < 2000; ++i) {
            const std::string name = "mesh " + std::to_string(i);
            session << "INSERT INTO mesh (name, hash, triangles, vertices, radius, has_normals, has_uvs) "
                       "VALUES (:name, 'h', 1, 1, 1, 0, 0)",
                soci::use(name);
        }
    };
    database.use([](session& session) {
        int pages = 0;
        session << "PRAGMA page_count", into(pages);
        session << "PRAGMA max_page_count = " + std::to_string(pages + 4);
    });
    try {
        database.change(fill);
        FAIL() << "there was room";
    } catch (const DatabaseError& error) {
        EXPECT_EQ(error.what(), path() + ": cannot be written: the disk is full");
    }
    EXPECT_EQ(number(database, "SELECT count(*) FROM mesh"), 0);
    database.use([](session& session) { session << "PRAGMA max_page_count = 1000000"; });
    database.change(fill);
    EXPECT_EQ(number(database, "SELECT count(*) FROM mesh"), 2000);
}

TEST_F(DatabaseTest, changesAreAllThereOrNotAtAll)
{
    Database database(path(), Database::Mode::MakeIfAbsent);
    EXPECT_THROW(database.change([](session& session) {
        session << "INSERT INTO configuration (name, rule) VALUES ('a', 'b')";
        throw std::logic_error("stop");
    }),
                 std::logic_error);
    EXPECT_EQ(number(database, "SELECT count(*) FROM configuration"), 0);
}

TEST_F(DatabaseTest, withAQuotationMarkInItsNameIsRefused)
{
    EXPECT_THROW(Database((mDirectory / "a\"b.db").string(), Database::Mode::MakeIfAbsent), DatabaseError);
    EXPECT_THAT(mDirectory.files(), IsEmpty());
}

} // namespace

} // namespace lodsmith::benchmarks
