#pragma once

#include "JsonRecord.h"

#include <lodsmith/core/Progress.h>
#include <lodsmith/core/Result.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include <sys/types.h>

namespace lodsmith::cli {

/// Work for a child process. It may crash, hang or eat memory: the parent gets an error instead of a record.
using ChildWork = std::function<Result<Json>(Progress&)>;

/// What a child may use.
struct ChildLimits {
    std::uint64_t memoryBytes = 0; ///< of address space; 0 for no limit
    double seconds = 0.0;          ///< of wall time; 0 for no limit
};

/// One piece of work in a process of its own, made by fork().
///
/// The process that starts it has to be single-threaded; what it has made so far, such as OGRE's root, the child finds made.
/// The child's standard output leads nowhere; what it writes to standard error is kept and quoted when it dies. It ends
/// without destructors, and dies with its parent.
class ChildProcess {
public:
    /// Error: Io when the system has no process or pipe left.
    static Result<std::unique_ptr<ChildProcess>> start(const ChildWork& work, const ChildLimits& limits);

    /// Kills the child if it still runs.
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    pid_t id() const { return mId; }
    int resultDescriptor() const { return mResult.descriptor; }
    int messageDescriptor() const { return mMessages.descriptor; }

    /// How far the work is, 0..1.
    float fraction() const { return mProgress->fraction(); }
    double seconds() const;

    /// Reads what the child has sent so far and kills it when its time is over. False once it has nothing more to send.
    bool pump();

    /// Waits for the end, which is near once pump() has returned false. The record, or the error: the work's own, or
    /// BadFile naming the signal, OutOfMemory, or Cancelled when the time was over.
    Result<Json> finish();

private:
    struct Pipe {
        int descriptor = -1;
        std::string text;
    };

    ChildProcess(pid_t id, int result, int messages, Progress* progress, const ChildLimits& limits);
    static void receive(Pipe& pipe);
    Error describeDeath(int status) const;

    pid_t mId;
    Pipe mResult;
    Pipe mMessages;
    Progress* mProgress; // in memory shared with the child
    ChildLimits mLimits;
    std::chrono::steady_clock::time_point mStart;
    bool mOverTime = false;
};

} // namespace lodsmith::cli
