#include "PeakMemory.h"

#include <fstream>
#include <stdexcept>

#include <fcntl.h>
#include <malloc.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace lodsmith::benchmarks {

namespace {

long statusKb(const std::string& key)
{
    std::ifstream status("/proc/self/status");
    std::string word;
    long value = 0;
    while (status >> word)
        if (word == key && status >> value)
            return value;
    throw std::runtime_error("/proc/self/status has no " + key);
}

void resetPeak()
{
    std::ofstream clear("/proc/self/clear_refs");
    clear << "5" << std::flush;
    if (!clear)
        throw std::runtime_error("/proc/self/clear_refs cannot be written");
}

std::string readAll(int descriptor)
{
    std::string text;
    char buffer[256];
    ssize_t size = 0;
    while ((size = read(descriptor, buffer, sizeof buffer)) > 0)
        text.append(buffer, std::size_t(size));
    return text;
}

/// Starts this program again with its standard output going into `output`.
std::optional<pid_t> startSelf(const std::vector<std::string>& arguments, int output)
{
    std::vector<char*> argv{const_cast<char*>("/proc/self/exe")};
    for (const std::string& argument : arguments)
        argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
    pid_t child = 0;
    const int failed = posix_spawn(&child, argv[0], &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    return failed ? std::nullopt : std::optional(child);
}

} // namespace

long peakGrowthKb(const std::function<void()>& work)
{
    malloc_trim(0);
    resetPeak();
    const long before = statusKb("VmHWM:");
    work();
    return statusKb("VmHWM:") - before;
}

Trial tryInOwnProcess(const std::vector<std::string>& arguments)
{
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
        return {{}, "no pipe can be made"};
    const std::optional<pid_t> child = startSelf(arguments, ends[1]);
    close(ends[1]);
    const std::string text = readAll(ends[0]);
    close(ends[0]);
    int status = 0;
    if (!child || waitpid(*child, &status, 0) != *child)
        return {{}, "no process can be started"};
    if (WIFSIGNALED(status))
        return {{}, "ended by signal " + std::to_string(WTERMSIG(status))};
    if (WEXITSTATUS(status) != 0)
        return {{}, text.substr(0, text.find('\n'))};
    return {std::stol(text), ""};
}

} // namespace lodsmith::benchmarks
