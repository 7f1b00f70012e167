#include "BatchTimes.h"

#include "MarkdownTable.h"
#include "Subject.h"
#include "Timing.h"

#include "../tests/support/TestDirectory.h"

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <ostream>
#include <stdexcept>
#include <thread>

namespace lodsmith::benchmarks {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMeshes = 1000;
constexpr std::uint32_t kMostTriangles = 100100;

std::vector<fs::path> meshFiles()
{
    std::vector<fs::path> files;
    for (const SubjectSource& source : allSubjects({}))
        if (fs::is_regular_file(source.origin) && source.load()->triangles() <= kMostTriangles)
            files.push_back(source.origin);
    return files;
}

/// A mesh with the skeletons beside it, in a directory of its own.
void copyMesh(const fs::path& mesh, const fs::path& directory)
{
    fs::create_directories(directory);
    for (const fs::directory_entry& entry : fs::directory_iterator(mesh.parent_path()))
        if (entry.path() == mesh || entry.path().extension() == ".skeleton")
            fs::copy_file(entry.path(), directory / entry.path().filename());
}

void copyMeshes(const fs::path& directory)
{
    const std::vector<fs::path> files = meshFiles();
    if (files.empty())
        throw std::runtime_error("no mesh files");
    for (std::size_t i = 0; i < kMeshes; ++i)
        copyMesh(files[i % files.size()], directory / std::to_string(i));
}

double generate(const fs::path& input, const fs::path& output, unsigned processes)
{
    const fs::path log = output.string() + ".log";
    const std::string command = "'" LODSMITH_PROGRAM "' generate '" + input.string() + "' -o '" + output.string()
                                + "' -j " + std::to_string(processes) + " >'" + log.string() + "' 2>&1";
    const auto start = std::chrono::steady_clock::now();
    if (std::system(command.c_str()) != 0) // NOLINT(concurrency-mt-unsafe): this program has one thread
        throw std::runtime_error(command + '\n' + test::contentOf(log));
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

} // namespace

void printBatch(std::ostream& out, int rounds)
{
    const unsigned processors = std::thread::hardware_concurrency();
    const test::TestDirectory directory;
    const fs::path input = directory / "in", output = directory / "out";
    copyMeshes(input);
    std::vector<double> alone, together, again;
    for (int round = 0; round < rounds; ++round) {
        alone.push_back(generate(input, output, 1));
        fs::remove_all(output);
        together.push_back(generate(input, output, processors));
        again.push_back(generate(input, output, processors));
        fs::remove_all(output);
    }
    MarkdownTable table(
        {"meshes", "one process, s", std::to_string(processors) + " processes, s", "times as fast", "up to date, s"});
    table.addRow({std::to_string(kMeshes), fixed(median(alone), 1), fixed(median(together), 1),
                  fixed(median(alone) / median(together), 2), fixed(median(again), 2)});
    out << "## A batch\n\n";
    table.print(out);
}

} // namespace lodsmith::benchmarks
