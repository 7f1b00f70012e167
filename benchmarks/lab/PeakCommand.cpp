#include "Commands.h"

#include "Measurement.h"

#include "../OgreSession.h"
#include "../PeakMemory.h"

#include <iostream>
#include <stdexcept>

namespace lodsmith::benchmarks {

namespace {

/// What a process of its own does: one mesh, one generator, one configuration, one number.
struct PeakArguments {
    std::string origin;
    std::string generator;
    std::string configuration;
};

int printPeak(const PeakArguments& arguments)
{
    try {
        const std::unique_ptr<Subject> subject = sourceFrom(arguments.origin).load();
        const std::unique_ptr<Peer> generator = makePeer(arguments.generator);
        for (const Configuration& configuration : makeConfigurations())
            if (generator && configuration.name == arguments.configuration) {
                std::cout << peakGrowthKb([&] { make(*subject, configuration, *generator); }) << std::endl;
                return kExitDone;
            }
        throw std::runtime_error("no such generator or configuration");
    } catch (const std::exception& error) {
        std::cout << error.what() << std::endl;
        return kExitFailed;
    }
}

} // namespace

void addPeakCommand(CLI::App& app, int& exitCode)
{
    auto arguments = std::make_shared<PeakArguments>();
    CLI::App* command = app.add_subcommand(kPeakCommand, "")->group("");
    command->add_option("origin", arguments->origin)->required();
    command->add_option("generator", arguments->generator)->required();
    command->add_option("configuration", arguments->configuration)->required();
    command->callback([arguments, &exitCode] {
        const OgreSession session;
        exitCode = printPeak(*arguments);
    });
}

} // namespace lodsmith::benchmarks
