#pragma once

#include <soci/soci.h>

#include <functional>
#include <stdexcept>
#include <string>

namespace lodsmith::benchmarks {

struct DatabaseError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A benchmark database: an SQLite file whose `PRAGMA user_version` is the number of steps of schema/ that it has had.
///
/// Whatever goes wrong is a DatabaseError that begins with the file's name: no such file, no database, another program's
/// database, one that a newer version has written, read-only, a full disk, another process that keeps it locked. Any number of
/// processes may use a file at once; of one object, one thread.
class Database {
public:
    enum class Mode {
        Existing,     ///< the file has to be there
        MakeIfAbsent, ///< and is made where it is not
    };

    /// Opens a database and brings it to the present schema.
    Database(const std::string& path, Mode mode);

    const std::string& path() const { return mPath; }

    /// Does some work on the database, with errors as above.
    void use(const std::function<void(soci::session&)>& work);

    /// The same in one transaction that nobody else writes in: all of it is kept, or nothing.
    void change(const std::function<void(soci::session&)>& work);

private:
    void checkIdentity();
    void migrate();

    std::string mPath;
    soci::session mSession;
};

} // namespace lodsmith::benchmarks
