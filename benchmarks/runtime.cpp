// What background generation costs a running program, as Markdown tables.

#include "FrameTimes.h"
#include "MainThreadShare.h"
#include "OgreSession.h"
#include "Throughput.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>

namespace lodsmith::benchmarks {

namespace {

void run(const std::vector<std::string>& parts, int rounds)
{
    const auto wants = [&](const char* part) { return std::count(parts.begin(), parts.end(), part) > 0; };
    {
        const OgreSession session;
        if (wants("main-thread"))
            printMainThreadShare(std::cout, rounds);
        if (wants("throughput"))
            printThroughput(std::cout, rounds);
    }
    if (wants("frames"))
        printFrameTimes(std::cout);
}

} // namespace

} // namespace lodsmith::benchmarks

int main(int argc, char** argv)
{
    std::vector<std::string> parts{"main-thread", "throughput", "frames"};
    int rounds = 5;
    CLI::App app{"Measures what background generation costs a running program."};
    app.add_option("--parts", parts, "what to measure: main-thread, throughput, frames")
        ->delimiter(',')
        ->check(CLI::IsMember({"main-thread", "throughput", "frames"}));
    app.add_option("--rounds", rounds, "runs of everything that is timed")->check(CLI::PositiveNumber);
    CLI11_PARSE(app, argc, argv);
    try {
        lodsmith::benchmarks::run(parts, rounds);
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
    return 0;
}
