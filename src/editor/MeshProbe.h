#pragma once

#include <lodsmith/core/Result.h>

#include <filesystem>
#include <memory>

#include <sys/types.h>

namespace lodsmith::editor {

/// Tries a mesh file before the editor loads it: OGRE ends the process on some broken files, and unsaved work with it. Each
/// file is loaded in a process of its own, of which a process that was forked early on takes care.
class MeshProbe {
public:
    static constexpr double kSeconds = 20.0;

    /// To be called while the process has one thread and no OGRE. Error: Io when the system has no process or socket left.
    static Result<std::unique_ptr<MeshProbe>> start();
    ~MeshProbe();
    MeshProbe(const MeshProbe&) = delete;
    MeshProbe& operator=(const MeshProbe&) = delete;

    /// Waits until the file has been loaded elsewhere, for kSeconds at most. Errors: those of loading (NotFound, Io, BadFile,
    /// OutOfMemory), BadFile when OGRE did not survive it, Cancelled when it took too long; Io when the process is gone.
    Result<Done> check(const std::filesystem::path& mesh);

private:
    MeshProbe(pid_t process, int socket) : mProcess(process), mSocket(socket) {}

    pid_t mProcess;
    int mSocket;
};

} // namespace lodsmith::editor
