#pragma once

#include "Database.h"

#include "cli/CommandLine.h"
#include "support/TestDirectory.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace lodsmith::benchmarks {

/// Runs lodsmith_lab on a database in a directory of its own.
class LabFixture : public testing::Test {
protected:
    using Words = std::vector<std::string>;

    /// What `run` is asked for: by default little, which takes a moment.
    struct Work {
        Words meshes{"planet-1k"};
        std::string generators = "lodsmith,ogre-curvature";
        std::string configurations = "halvings,classic";
        std::string rounds = "2";
    };

    Words runWords(const std::string& database, const Work& work, const Words& further = {}) const
    {
        Words words{"run", path(database), "--least-seconds", "0", "--samples", "500"};
        words.insert(words.end(), {"--generators", work.generators, "--configurations", work.configurations});
        words.insert(words.end(), {"--rounds", work.rounds, "--meshes"});
        words.insert(words.end(), work.meshes.begin(), work.meshes.end());
        words.insert(words.end(), further.begin(), further.end());
        return words;
    }

    Words runWords(const std::string& database, const Words& further = {}) const
    {
        return runWords(database, Work{}, further);
    }

    static Work withRounds(const std::string& rounds)
    {
        Work work;
        work.rounds = rounds;
        return work;
    }

    std::string path(const std::string& name) const { return (mDirectory / name).string(); }

    int count(const std::string& database, const std::string& query) const
    {
        Database opened(path(database), Database::Mode::Existing);
        int value = -1;
        opened.use([&](soci::session& session) { session << query, soci::into(value); });
        return value;
    }

    /// Everything that does not change from one run to the next, as text.
    std::string shapes(const std::string& database) const
    {
        Database opened(path(database), Database::Mode::Existing);
        std::string text;
        opened.use([&](soci::session& session) {
            session
                << "SELECT coalesce(group_concat(line, char(10)), '') FROM (SELECT mesh.name || hash || "
                   "configuration.name || generator || samples || coalesce(error, '') || "
                   "(SELECT count(*) FROM round WHERE run_id = run.id) || ' ' || "
                   "coalesce((SELECT group_concat(number || ' ' || vertices || ' ' || triangles || ' ' || bytes || ' ' "
                   "|| surface_mean || ' ' || surface_rms || ' ' || surface_maximum || ' ' || normal_mean || ' ' "
                   "|| uv_mean || ' ' || flipped_triangles || ' ' || coalesce(visible_px, '-')) "
                   "FROM level WHERE run_id = run.id), '') AS line "
                   "FROM run JOIN mesh ON mesh.id = mesh_id JOIN configuration ON configuration.id = configuration_id "
                   "ORDER BY line)",
                soci::into(text);
        });
        return text;
    }

    const lodsmith::test::TestDirectory mDirectory;
};

} // namespace lodsmith::benchmarks
