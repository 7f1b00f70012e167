#include "MeshProbe.h"

#include "../cli/ChildProcess.h"
#include "../cli/OgreSession.h"

#include <OgreSkeleton.h>
#include <OgreSubMesh.h>

#include <cmath>
#include <csignal>
#include <string>

#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace lodsmith::editor {

namespace {

// Both ways, one packet a message: a path, and the error as JSON, which is empty when there is none.
constexpr std::size_t kLargestMessage = 1 << 16;

bool send(int socket, const std::string& message)
{
    return ::send(socket, message.data(), message.size(), MSG_NOSIGNAL) == ssize_t(message.size());
}

/// False at the end of the other side.
bool receive(int socket, std::string& message)
{
    message.resize(kLargestMessage);
    const ssize_t length = ::recv(socket, message.data(), message.size(), 0);
    message.resize(length > 0 ? std::size_t(length) : 0);
    return length > 0;
}

Result<Done> checkBones(const Ogre::Mesh::VertexBoneAssignmentList& assignments, const Ogre::Skeleton& skeleton)
{
    for (const auto& [vertex, assignment] : assignments)
        if (assignment.boneIndex >= skeleton.getNumBones())
            return Error{ErrorCode::BadFile, "vertex " + std::to_string(vertex) + " follows bone "
                                                 + std::to_string(assignment.boneIndex) + ", and the skeleton has "
                                                 + std::to_string(skeleton.getNumBones())};
    return Done{};
}

/// What OGRE takes, and asserts about, or reads beyond, when it draws.
Result<Done> checkDrawable(const Ogre::Mesh& mesh)
{
    if (!std::isfinite(mesh.getBoundingSphereRadius()))
        return Error{ErrorCode::InvalidGeometry, "the radius of the mesh's bounds is no number"};
    if (!mesh.hasSkeleton() || !mesh.getSkeleton())
        return Done{};
    Result<Done> checked = checkBones(mesh.getBoneAssignments(), *mesh.getSkeleton());
    for (const Ogre::SubMesh* subMesh : mesh.getSubMeshes())
        if (checked)
            checked = checkBones(subMesh->getBoneAssignments(), *mesh.getSkeleton());
    return checked;
}

Result<cli::Json> load(const std::filesystem::path& path)
{
    cli::OgreSession session;
    const auto mesh = session.load(path);
    if (!mesh)
        return mesh.error();
    if (const auto checked = checkDrawable(*mesh.value()); !checked)
        return checked.error();
    return cli::Json::object();
}

Result<cli::Json> loadInChild(const std::filesystem::path& path)
{
    const auto work = [&](Progress&) { return load(path); };
    auto child = cli::ChildProcess::start(work, {0, MeshProbe::kSeconds});
    if (!child)
        return child.error();
    while (child.value()->pump()) {
        pollfd descriptors[] = {{child.value()->resultDescriptor(), POLLIN, 0},
                                {child.value()->messageDescriptor(), POLLIN, 0}};
        ::poll(descriptors, 2, 100);
    }
    return child.value()->finish();
}

/// The other process.
[[noreturn]] void serve(int socket)
{
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    // Ctrl+C at the terminal is the editor's; this process ends with it.
    std::signal(SIGINT, SIG_IGN);
    for (std::string path; receive(socket, path);) {
        const auto outcome = loadInChild(path);
        if (!send(socket, outcome ? "{}" : cli::toLine(cli::toJson(outcome.error()))))
            break;
    }
    ::_exit(0);
}

} // namespace

Result<std::unique_ptr<MeshProbe>> MeshProbe::start()
{
    int sockets[2];
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, sockets) != 0)
        return Error{ErrorCode::Io, "no sockets to try meshes through"};
    const pid_t process = ::fork();
    if (process == 0) {
        ::close(sockets[0]);
        serve(sockets[1]);
    }
    ::close(sockets[1]);
    if (process < 0) {
        ::close(sockets[0]);
        return Error{ErrorCode::Io, "no process to try meshes in"};
    }
    return std::unique_ptr<MeshProbe>(new MeshProbe(process, sockets[0]));
}

MeshProbe::~MeshProbe()
{
    ::close(mSocket);
    ::waitpid(mProcess, nullptr, 0);
}

Result<Done> MeshProbe::check(const std::filesystem::path& mesh)
{
    const std::string path = std::filesystem::absolute(mesh).string();
    std::string answer;
    if (path.size() > kLargestMessage || !send(mSocket, path) || !receive(mSocket, answer))
        return Error{ErrorCode::Io, "the process that tries meshes is gone", path};
    const cli::Json error = cli::Json::parse(answer);
    if (error.empty())
        return Done{};
    Error result = cli::errorFromJson(error);
    if (result.file.empty())
        result.file = path;
    return result;
}

} // namespace lodsmith::editor
