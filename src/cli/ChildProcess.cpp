#include "ChildProcess.h"

#include "Numbers.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <new>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace lodsmith::cli {

namespace {

static_assert(std::atomic<float>::is_always_lock_free, "Progress is shared between processes");

constexpr std::size_t kQuotedBytes = 600;

// The sanitizers' shadow memory takes terabytes of address space.
#if defined(LODSMITH_SANITIZED)
constexpr bool kCanLimitMemory = false;
#else
constexpr bool kCanLimitMemory = true;
#endif

Error systemError(const char* what)
{
    return Error{ErrorCode::Io, std::string(what) + ": " + std::strerror(errno)};
}

void limit(int resource, rlim_t value)
{
    rlimit current = {};
    if (::getrlimit(static_cast<__rlimit_resource>(resource), &current) != 0)
        return;
    current.rlim_cur = std::min(value, current.rlim_max);
    ::setrlimit(static_cast<__rlimit_resource>(resource), &current);
}

void sendAll(int descriptor, const std::string& text)
{
    std::size_t sent = 0;
    while (sent < text.size()) {
        const ssize_t count = ::write(descriptor, text.data() + sent, text.size() - sent);
        if (count > 0)
            sent += static_cast<std::size_t>(count);
        else if (count < 0 && errno != EINTR)
            return;
    }
}

Json packed(const Result<Json>& outcome)
{
    return outcome ? Json{{"record", outcome.value()}} : Json{{"error", toJson(outcome.error())}};
}

Result<Json> guarded(const ChildWork& work, Progress& progress)
{
    try {
        return work(progress);
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::OutOfMemory, "needs more memory than the limit allows"};
    } catch (const std::exception& exception) {
        return Error{ErrorCode::BadFile, exception.what()};
    }
}

/// What the child does with its life.
[[noreturn]] void live(const ChildWork& work, const ChildLimits& limits, Progress& progress, int result, int messages)
{
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    ::signal(SIGTERM, SIG_DFL);
    // An interrupt from the terminal reaches the parent too, which then ends its children.
    ::signal(SIGINT, SIG_IGN);
    // A file that grows beyond the file size limit is an error of write(), not a death.
    ::signal(SIGXFSZ, SIG_IGN);
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    ::dup2(nowhere, STDOUT_FILENO);
    ::dup2(messages, STDERR_FILENO);
    limit(RLIMIT_CORE, 0);
    if (kCanLimitMemory && limits.memoryBytes > 0)
        limit(RLIMIT_AS, limits.memoryBytes);
    sendAll(result, toLine(packed(guarded(work, progress))));
    ::_exit(0);
}

/// The last thing that somebody said, on one line.
std::string lastWords(const std::string& messages)
{
    std::string text = messages.substr(messages.size() - std::min(messages.size(), kQuotedBytes));
    while (!text.empty() && text.back() == '\n')
        text.pop_back();
    for (char& c : text)
        if (c == '\n')
            c = ' ';
    return text;
}

} // namespace

Result<std::unique_ptr<ChildProcess>> ChildProcess::start(const ChildWork& work, const ChildLimits& limits)
{
    int result[2], messages[2];
    if (::pipe2(result, O_CLOEXEC) != 0)
        return systemError("no pipe to a child process");
    if (::pipe2(messages, O_CLOEXEC) != 0) {
        ::close(result[0]);
        ::close(result[1]);
        return systemError("no pipe to a child process");
    }
    void* shared = ::mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    const pid_t id = shared == MAP_FAILED ? -1 : ::fork();
    if (id == 0)
        live(work, limits, *new (shared) Progress, result[1], messages[1]);
    ::close(result[1]);
    ::close(messages[1]);
    if (id < 0) {
        const Error error = systemError("no child process");
        ::close(result[0]);
        ::close(messages[0]);
        if (shared != MAP_FAILED)
            ::munmap(shared, sizeof(Progress));
        return error;
    }
    // Fresh shared memory is zero, and so is a fresh Progress: it can be looked at before the child has made it.
    return std::unique_ptr<ChildProcess>(
        new ChildProcess(id, result[0], messages[0], static_cast<Progress*>(shared), limits));
}

ChildProcess::ChildProcess(pid_t id, int result, int messages, Progress* progress, const ChildLimits& limits)
    : mId(id), mProgress(progress), mLimits(limits), mStart(std::chrono::steady_clock::now())
{
    mResult.descriptor = result;
    mMessages.descriptor = messages;
    ::fcntl(result, F_SETFL, O_NONBLOCK);
    ::fcntl(messages, F_SETFL, O_NONBLOCK);
}

ChildProcess::~ChildProcess()
{
    if (mId > 0) {
        ::kill(mId, SIGKILL);
        ::waitpid(mId, nullptr, 0);
    }
    for (const Pipe* pipe : {&mResult, &mMessages})
        if (pipe->descriptor >= 0)
            ::close(pipe->descriptor);
    ::munmap(mProgress, sizeof(Progress));
}

double ChildProcess::seconds() const
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - mStart).count();
}

bool ChildProcess::pump()
{
    receive(mResult);
    receive(mMessages);
    const bool isAtWork = mResult.descriptor >= 0 || mMessages.descriptor >= 0;
    if (isAtWork && mLimits.seconds > 0.0 && seconds() > mLimits.seconds && !mOverTime) {
        mOverTime = true;
        ::kill(mId, SIGKILL);
    }
    return isAtWork;
}

void ChildProcess::receive(Pipe& pipe)
{
    char block[1 << 16];
    while (pipe.descriptor >= 0) {
        const ssize_t count = ::read(pipe.descriptor, block, sizeof block);
        if (count > 0) {
            pipe.text.append(block, static_cast<std::size_t>(count));
        } else if (count < 0 && errno == EINTR) {
            continue;
        } else if (count < 0 && errno == EAGAIN) {
            return;
        } else {
            ::close(pipe.descriptor);
            pipe.descriptor = -1;
        }
    }
}

Result<Json> ChildProcess::finish()
{
    int status = 0;
    while (::waitpid(mId, &status, 0) < 0 && errno == EINTR) {
    }
    mId = -1;
    const Json answer = Json::parse(mResult.text, nullptr, false);
    if (mOverTime || answer.is_discarded() || !answer.is_object() || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
        return describeDeath(status);
    if (answer.contains("record"))
        return answer.at("record");
    return errorFromJson(answer.at("error"));
}

Error ChildProcess::describeDeath(int status) const
{
    if (mOverTime)
        return Error{ErrorCode::Cancelled,
                     "took longer than the time limit of " + formatNumber(mLimits.seconds, 6) + " s"};
    std::string how = "ended with status " + std::to_string(WEXITSTATUS(status)) + " and no answer";
    if (WIFSIGNALED(status))
        how = std::string("died of signal ") + std::to_string(WTERMSIG(status)) + " (" + ::strsignal(WTERMSIG(status))
              + ")";
    const std::string words = lastWords(mMessages.text);
    return Error{ErrorCode::BadFile,
                 "the process that worked on it " + how + (words.empty() ? "" : "; it said: " + words)};
}

} // namespace lodsmith::cli
