#include "Commands.h"

#include "Measurement.h"
#include "Provenance.h"
#include "RunProgress.h"
#include "RunStore.h"

#include "../MarkdownTable.h"
#include "../OgreSession.h"

#include <algorithm>
#include <iostream>

namespace lodsmith::benchmarks {

namespace {

struct RunArguments {
    std::string database;
    std::vector<std::string> meshes;
    std::vector<std::string> generators;
    std::vector<std::string> configurations;
    std::string label;
    MeasurementOptions measurement;
    bool again = false;
};

bool isWanted(const std::vector<std::string>& names, const std::string& name)
{
    return names.empty() || std::count(names.begin(), names.end(), name) > 0;
}

class Run {
public:
    explicit Run(const RunArguments& arguments);

    /// Measures what is not there yet. False when something failed, which has been said.
    bool measureAll();

private:
    void measureMesh(const SubjectSource& source, RunProgress& progress);
    std::string measureConfiguration(Subject& subject, const std::string& origin, const MeshRecord& mesh,
                                     const Configuration& configuration);
    std::string outcomeOf(const RunRecord& record);
    std::vector<Peer*> missing(const RunStore::Place& place, const Configuration& configuration);

    const RunArguments& mArguments;
    std::vector<SubjectSource> mSources; // before the database: a wish for a mesh that is not there makes none
    Database mDatabase;
    RunStore mStore;
    std::vector<std::unique_ptr<Peer>> mGenerators;
    std::vector<Configuration> mConfigurations;
    bool mGood = true;
};

Run::Run(const RunArguments& arguments)
    : mArguments(arguments), mSources(chosenSubjects(arguments.meshes)),
      mDatabase(arguments.database, Database::Mode::MakeIfAbsent),
      mStore(mDatabase, thisMachine(), thisBuild(arguments.label), arguments.measurement)
{
    for (std::unique_ptr<Peer>& peer : makePeers())
        if (isWanted(arguments.generators, peer->name()))
            mGenerators.push_back(std::move(peer));
    for (Configuration& configuration : makeConfigurations())
        if (isWanted(arguments.configurations, configuration.name))
            mConfigurations.push_back(std::move(configuration));
}

bool Run::measureAll()
{
    double weight = 0.0;
    for (const SubjectSource& source : mSources)
        weight += source.weight;
    RunProgress progress(mSources.size() * mConfigurations.size(), weight);
    for (const SubjectSource& source : mSources)
        measureMesh(source, progress);
    return mGood;
}

void Run::measureMesh(const SubjectSource& source, RunProgress& progress)
{
    const double weight = source.weight / double(mConfigurations.size());
    std::size_t left = mConfigurations.size();
    try {
        const std::unique_ptr<Subject> subject = source.load();
        const MeshRecord mesh = describeMesh(*subject);
        for (const Configuration& configuration : mConfigurations) {
            const std::string outcome = measureConfiguration(*subject, source.origin, mesh, configuration);
            --left;
            if (outcome.empty())
                progress.skipped(weight);
            else
                progress.measured(source.name + ", " + configuration.name + ": " + outcome, weight);
        }
    } catch (const DatabaseError&) {
        throw; // without it there is no use in going on
    } catch (const std::exception& error) {
        std::cerr << source.name << ": " << error.what() << '\n';
        mGood = false;
    }
    for (; left > 0; --left)
        progress.skipped(weight);
}

/// What came out, in words; empty when there was nothing to do.
std::string Run::measureConfiguration(Subject& subject, const std::string& origin, const MeshRecord& mesh,
                                      const Configuration& configuration)
{
    const RunStore::Place place = mStore.place(mesh, configuration);
    const std::vector<Peer*> generators = missing(place, configuration);
    std::string outcome;
    for (const RunRecord& record :
         measureTogether(subject, origin, configuration, generators, mArguments.measurement)) {
        mStore.save(place, record, mArguments.again ? RunStore::IfDone::Replace : RunStore::IfDone::Keep);
        outcome += (outcome.empty() ? "" : ", ") + outcomeOf(record);
    }
    return outcome;
}

std::string Run::outcomeOf(const RunRecord& record)
{
    if (!record.error.empty()) {
        mGood = false;
        return record.generator + " failed (" + record.error + ')';
    }
    std::vector<double> seconds;
    for (const Round& round : record.rounds)
        seconds.push_back(round.seconds);
    return record.generator + ' ' + fixed(1000.0 * median(seconds), 2) + " ms";
}

/// Those that can be asked for the configuration and have not been, or are to be asked again.
std::vector<Peer*> Run::missing(const RunStore::Place& place, const Configuration& configuration)
{
    const std::set<std::string> done = mArguments.again ? std::set<std::string>() : mStore.done(place);
    std::vector<Peer*> generators;
    for (const auto& generator : mGenerators)
        if (done.count(generator->name()) == 0 && configuration.suits(*generator))
            generators.push_back(generator.get());
    return generators;
}

std::vector<std::string> generatorNames()
{
    std::vector<std::string> names;
    for (const std::unique_ptr<Peer>& peer : makePeers())
        names.push_back(peer->name());
    return names;
}

std::vector<std::string> configurationNames()
{
    std::vector<std::string> names;
    for (const Configuration& configuration : makeConfigurations())
        names.push_back(configuration.name);
    return names;
}

} // namespace

void addRunCommand(CLI::App& app, int& exitCode)
{
    auto arguments = std::make_shared<RunArguments>();
    CLI::App* command = app.add_subcommand("run", "measure what the database does not have yet");
    command->add_option("database", arguments->database, "the file, which is made if it is absent")->required();
    command->add_option("--meshes", arguments->meshes,
                        "directories, .mesh files, and names with * and ? of media and tessellations; default all");
    command->add_option("--generators", arguments->generators, "only these")
        ->delimiter(',')
        ->check(CLI::IsMember(generatorNames()));
    command->add_option("--configurations", arguments->configurations, "only these")
        ->delimiter(',')
        ->check(CLI::IsMember(configurationNames()));
    command->add_option("--rounds", arguments->measurement.timing.rounds, "times that everything is run, at least")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command
        ->add_option("--least-seconds", arguments->measurement.timing.leastSeconds,
                     "further rounds up to this much time")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    command
        ->add_option("--samples", arguments->measurement.deviation.samples,
                     "points on each surface when deviations are taken")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command->add_option("--label", arguments->label,
                        "what comparisons call this build; default its version and commit");
    command->add_flag("--again", arguments->again, "measure anew what is there already, and keep the new figures");
    command->callback([arguments, &exitCode] {
        const OgreSession session;
        exitCode = Run(*arguments).measureAll() ? kExitDone : kExitFailed;
    });
}

} // namespace lodsmith::benchmarks
