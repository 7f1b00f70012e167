#include "CommandLine.h"

#include "support/Child.h"
#include "support/TestDirectory.h"

#include <sstream>
#include <stdexcept>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace lodsmith::cli::test {

namespace {

[[noreturn]] void become(const std::vector<std::string>& command, const std::string& out, const std::string& err,
                         unsigned long fileSizeLimit)
{
    ::dup2(::open(out.c_str(), O_WRONLY | O_CREAT, 0600), STDOUT_FILENO);
    ::dup2(::open(err.c_str(), O_WRONLY | O_CREAT, 0600), STDERR_FILENO);
    if (fileSizeLimit > 0) {
        const rlimit limit = {fileSizeLimit, fileSizeLimit};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    std::vector<char*> words;
    for (const std::string& word : command)
        words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    ::execvp(words[0], words.data());
    ::_exit(127);
}

} // namespace

std::vector<nlohmann::json> Outcome::records() const
{
    std::vector<nlohmann::json> records;
    std::istringstream lines(out);
    for (std::string line; std::getline(lines, line);) {
        records.push_back(nlohmann::json::parse(line));
        if (!records.back().is_object())
            throw std::runtime_error("no JSON object: " + line);
    }
    return records;
}

Outcome runProgram(const std::vector<std::string>& command, unsigned long fileSizeLimit)
{
    const lodsmith::test::TestDirectory directory;
    const std::string out = (directory / "out").string(), err = (directory / "err").string();
    const pid_t id = ::fork();
    if (id == 0)
        become(command, out, err, fileSizeLimit);
    int status = 0;
    ::waitpid(id, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, lodsmith::test::contentOf(out),
            lodsmith::test::contentOf(err)};
}

Outcome runLodsmith(const std::vector<std::string>& arguments, unsigned long fileSizeLimit)
{
    std::vector<std::string> command{LODSMITH_PROGRAM};
    command.insert(command.end(), arguments.begin(), arguments.end());
    return runProgram(command, fileSizeLimit);
}

pid_t startLodsmith(const std::vector<std::string>& arguments)
{
    std::vector<std::string> command{LODSMITH_PROGRAM};
    command.insert(command.end(), arguments.begin(), arguments.end());
    // Children of a process that was killed come to this one, which can wait for them.
    ::prctl(PR_SET_CHILD_SUBREAPER, 1);
    const pid_t leader = lodsmith::test::startChild([&]() -> bool {
        ::setpgid(0, 0);
        become(command, "/dev/null", "/dev/null", 0);
    });
    ::setpgid(leader, leader); // whoever of the two comes first
    return leader;
}

int waitForGroup(pid_t leader)
{
    const int status = lodsmith::test::waitFor(leader);
    while (::waitpid(-leader, nullptr, 0) > 0) {
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

} // namespace lodsmith::cli::test
