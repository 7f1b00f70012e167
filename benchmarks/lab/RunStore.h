#pragma once

#include "Database.h"
#include "Measurement.h"
#include "Records.h"

#include <set>
#include <string>

namespace lodsmith::benchmarks {

/// Writes the runs of one build on one machine.
class RunStore {
public:
    /// @param options  what was measured with fewer rounds, or with another number of samples, has to be measured again
    RunStore(Database& database, const Machine& machine, const Build& build, const MeasurementOptions& options);

    /// What a mesh and a configuration are called in the database.
    struct Place {
        long long mesh = 0;
        long long configuration = 0;
        int rounds = 0; ///< that a run there has at least
    };

    /// Makes them where they are not there yet.
    Place place(const MeshRecord& mesh, const Configuration& configuration);

    /// The generators that this build has measured there on this machine. Those that failed count: they would fail again.
    std::set<std::string> done(const Place& place);

    /// What happens to a run that is done already, by another process meanwhile or on purpose.
    enum class IfDone { Keep, Replace };

    /// Keeps a run, all of it or nothing.
    void save(const Place& place, const RunRecord& record, IfDone ifDone);

private:
    std::set<std::string> doneIn(soci::session& session, const Place& place) const;
    long long insertRun(soci::session& session, const Place& place, const RunRecord& record) const;

    Database& mDatabase;
    MeasurementOptions mOptions;
    long long mMachine = 0;
    long long mBuild = 0;
};

} // namespace lodsmith::benchmarks
