// What large meshes and many meshes take, as Markdown tables.

#include "BatchTimes.h"
#include "LargeMesh.h"
#include "OgreSession.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>

namespace lodsmith::benchmarks {

namespace {

void run(const std::vector<std::string>& parts, int rounds)
{
    const auto wants = [&](const char* part) { return std::count(parts.begin(), parts.end(), part) > 0; };
    const OgreSession session;
    if (wants("threads"))
        printThreads(std::cout, rounds);
    if (wants("ten-million"))
        printTenMillion(std::cout, rounds);
    if (wants("batch"))
        printBatch(std::cout, rounds);
}

int peak(const std::string& origin)
{
    const OgreSession session;
    printPeak(std::cout, origin);
    return 0;
}

int main(int argc, char** argv)
{
    std::vector<std::string> parts{"threads", "ten-million", "batch"};
    int rounds = 3;
    std::string peakOrigin;
    CLI::App app{"Measures what large meshes and many meshes take.", "lodsmith_scale"};
    app.add_option("--parts", parts, "what to measure: threads, ten-million, batch")
        ->delimiter(',')
        ->check(CLI::IsMember({"threads", "ten-million", "batch"}));
    app.add_option("--rounds", rounds, "runs of everything that is timed")->check(CLI::PositiveNumber);
    app.add_option(kPeakCommand, peakOrigin)->group(""); // not for people: what the program starts itself with
    CLI11_PARSE(app, argc, argv);
    if (!peakOrigin.empty())
        return peak(peakOrigin);
    run(parts, rounds);
    return 0;
}

} // namespace

} // namespace lodsmith::benchmarks

int main(int argc, char** argv)
{
    try {
        return lodsmith::benchmarks::main(argc, argv);
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}
