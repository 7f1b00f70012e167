#include "BackgroundThread.h"

#if defined(__linux__)
#    include <pthread.h>
#    include <sched.h>
#    include <sys/resource.h>
#    include <unistd.h>
#endif

namespace lodsmith {

void becomeBackgroundThread()
{
#if defined(__linux__)
    constexpr int kNicer = 10; // a tenth of the weight
    const sched_param none{};
    pthread_setschedparam(pthread_self(), SCHED_BATCH, &none);
    // With Linux niceness is a thread's own. That of the thread that made this one is where it begins.
    const auto thread = static_cast<id_t>(gettid());
    setpriority(PRIO_PROCESS, thread, getpriority(PRIO_PROCESS, thread) + kNicer);
#endif
}

} // namespace lodsmith
