#include "VirtualDisplay.h"

#include <filesystem>
#include <sstream>
#include <stdexcept>

#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace lodsmith::test {

namespace {

constexpr const char* kServer = "Xvfb";

/// The child's part. The server writes the number of the display that it has found free to `ready`.
[[noreturn]] void becomeServer(int ready, pid_t parent, const std::string& screen)
{
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (::getppid() != parent)
        ::_exit(1); // it has ended before the line above
    const int nowhere = ::open("/dev/null", O_RDWR);
    ::dup2(nowhere, STDOUT_FILENO);
    ::dup2(nowhere, STDERR_FILENO);
    const std::string descriptor = std::to_string(ready);
    ::execlp(kServer, kServer, "-displayfd", descriptor.c_str(), "-screen", "0", screen.c_str(), "-nolisten", "tcp",
             "+extension", "GLX", static_cast<char*>(nullptr));
    ::_exit(1);
}

/// What comes until a line's end, or until nobody can write any more.
std::string lineFrom(int descriptor)
{
    std::string line;
    for (char next = 0; ::read(descriptor, &next, 1) == 1 && next != '\n';)
        line += next;
    return line;
}

} // namespace

bool VirtualDisplay::isAvailable()
{
    const char* path = ::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (::access((fs::path(folder) / kServer).c_str(), X_OK) == 0)
            return true;
    return false;
}

VirtualDisplay::VirtualDisplay(int width, int height)
{
    int ready[2];
    if (::pipe(ready) != 0)
        throw std::runtime_error("no pipe");
    const pid_t self = ::getpid();
    mServer = ::fork();
    if (mServer == 0) {
        ::close(ready[0]);
        becomeServer(ready[1], self, std::to_string(width) + "x" + std::to_string(height) + "x24");
    }
    ::close(ready[1]);
    const std::string number = lineFrom(ready[0]);
    ::close(ready[0]);
    if (number.empty()) {
        if (mServer > 0)
            ::waitpid(mServer, nullptr, 0);
        throw std::runtime_error("Xvfb does not start");
    }
    if (const char* before = ::getenv("DISPLAY"))
        mBefore = before;
    ::setenv("DISPLAY", (":" + number).c_str(), 1);
}

VirtualDisplay::~VirtualDisplay()
{
    if (mBefore)
        ::setenv("DISPLAY", mBefore->c_str(), 1);
    else
        ::unsetenv("DISPLAY");
    ::kill(mServer, SIGTERM);
    ::waitpid(mServer, nullptr, 0);
}

} // namespace lodsmith::test
