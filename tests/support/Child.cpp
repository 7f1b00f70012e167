#include "Child.h"

#include <sys/wait.h>
#include <unistd.h>

namespace lodsmith::test {

pid_t startChild(const std::function<bool()>& work)
{
    const pid_t child = ::fork();
    if (child == 0)
        ::_exit(work() ? 0 : 1);
    return child;
}

int waitFor(pid_t child)
{
    int status = -1;
    ::waitpid(child, &status, 0);
    return status;
}

bool inChild(const std::function<bool()>& work)
{
    return waitFor(startChild(work)) == 0;
}

} // namespace lodsmith::test
