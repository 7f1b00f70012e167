#include "MeshFile.h"

#include "../ogre/OgreVersion.h"
#include "MeshStreams.h"
#include "OgreSession.h"

#include <OgreAnimation.h>
#include <OgrePose.h>
#include <OgreSubMesh.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <memory>
#include <optional>
#include <thread>

#include <sys/stat.h>

namespace fs = std::filesystem;

namespace lodsmith::cli {

namespace {

Error withMessage(ErrorCode code, std::string message)
{
    return Error{code, std::move(message)};
}

bool swapsBytes(Ogre::Serializer::Endian endian)
{
#if OGRE_ENDIAN == OGRE_ENDIAN_BIG
    return endian == Ogre::Serializer::ENDIAN_LITTLE;
#else
    return endian == Ogre::Serializer::ENDIAN_BIG;
#endif
}

bool canSwap(const Ogre::VertexElement& element)
{
    const auto type = Ogre::VertexElement::getBaseType(element.getType());
    switch (type) {
    case Ogre::VET_FLOAT1:
    case Ogre::VET_DOUBLE1:
    case Ogre::VET_SHORT1:
    case Ogre::VET_USHORT1:
    case Ogre::VET_INT1:
    case Ogre::VET_UINT1:
    case Ogre::VET_UBYTE4: return true;
    default: return packedColour(type) != PackedColour::None;
    }
}

bool canSwap(const Ogre::VertexData* data)
{
    if (data)
        for (const Ogre::VertexElement& element : data->vertexDeclaration->getElements())
            if (!canSwap(element))
                return false;
    return true;
}

bool canSwap(const Ogre::Mesh& mesh)
{
    for (const Ogre::SubMesh* subMesh : mesh.getSubMeshes())
        if (!subMesh->useSharedVertices && !canSwap(subMesh->vertexData))
            return false;
    return canSwap(mesh.sharedVertexData);
}

/// Names end with a line in mesh files. Of those that OGRE would not find again, the first.
std::optional<std::string> nameOfTwoLines(const Ogre::Mesh& mesh)
{
    std::vector<std::string> names{mesh.getSkeletonName()};
    for (const Ogre::SubMesh* subMesh : mesh.getSubMeshes())
        names.push_back(subMesh->getMaterialName());
    for (const auto& [name, number] : mesh.getSubMeshNameMap())
        names.push_back(name);
    for (unsigned short level = 1; level < mesh.getNumLodLevels(); ++level)
        names.push_back(mesh.getLodLevel(level).manualName);
    for (const Ogre::Pose* pose : mesh.getPoseList())
        names.push_back(pose->getName());
    for (unsigned short i = 0; i < mesh.getNumAnimations(); ++i)
        names.push_back(mesh.getAnimation(i)->getName());
    const auto found = std::find_if(names.begin(), names.end(),
                                    [](const std::string& name) { return name.find('\n') != std::string::npos; });
    return found == names.end() ? std::nullopt : std::optional(*found);
}

Result<Done> checkFormat(const Ogre::Mesh& mesh, const MeshFormat& format)
{
    if (const auto name = nameOfTwoLines(mesh))
        return withMessage(ErrorCode::Unsupported,
                           "the name '" + *name + "' has a line end in it, where names end in mesh files");
    if (!holdsLevels(format.version) && mesh.getNumLodLevels() > 1)
        return withMessage(ErrorCode::Unsupported, "OGRE writes no levels of detail in mesh formats 1.0 and 1.4");
    if (swapsBytes(format.endian) && !canSwap(mesh))
        return withMessage(
            ErrorCode::Unsupported,
            "has vertex elements (colours, for one) whose byte order OGRE cannot turn; use --endian native");
    return Done{};
}

std::int64_t nanoseconds(const timespec& time)
{
    return std::int64_t(time.tv_sec) * 1000000000 + time.tv_nsec;
}

/// A companion on its way to its place.
struct Copy {
    std::unique_ptr<AtomicFile> file; // null when nothing has to be done
    fs::path target;
    std::string content;
};

bool hasContent(const fs::path& path, const std::string& content)
{
    const Result<std::string> present = readFile(path);
    return present && present.value() == content;
}

Error withHint(Error error, const fs::path& target, Existing existing)
{
    std::error_code ignored;
    if (existing == Existing::Keep && fs::exists(fs::symlink_status(target, ignored))
        && AtomicFile::checkTarget(target, Existing::Replace))
        error.message += "; --force overwrites it";
    return error;
}

Result<Copy> prepareCopy(const Companion& companion, const fs::path& target, Existing existing)
{
    Result<std::string> content = companion.content ? *companion.content : readFile(companion.source);
    if (!content)
        return content.error();
    Copy copy{nullptr, target, std::move(content).value()};
    if (!hasContent(target, copy.content)) {
        copy.file = std::make_unique<AtomicFile>(target, existing);
        if (auto prepared = copy.file->prepare(copy.content); !prepared)
            return withHint(prepared.error(), target, existing);
    }
    return copy;
}

/// Meshes of different directories that go to one may bring different files of one name: two skeletons, for instance.
Result<Done> checkOtherMeshes(const Copy& copy, std::int64_t runBegan)
{
    struct stat status = {};
    if (::stat(copy.target.c_str(), &status) != 0 || nanoseconds(status.st_mtim) < runBegan
        || hasContent(copy.target, copy.content))
        return Done{};
    Error error =
        withMessage(ErrorCode::InvalidSetting, "another mesh of this run has brought a different file of this name; "
                                               "give the two meshes different output directories");
    error.file = copy.target.string();
    return error;
}

Result<Done> commitCopy(const Copy& copy, const Overwriting& overwriting)
{
    if (!copy.file)
        return Done{};
    if (overwriting.existing == Existing::Replace)
        if (auto free = checkOtherMeshes(copy, overwriting.runBegan); !free)
            return free;
    auto committed = copy.file->commit();
    // Another process may have brought the same file in the meantime, for a mesh with the same skeleton.
    return committed || hasContent(copy.target, copy.content) ? Result<Done>(Done{}) : committed;
}

} // namespace

Result<Ogre::MeshVersion> parseMeshVersion(const std::string& word)
{
    if (word == "1.0")
        return Ogre::MESH_VERSION_1_0;
    if (word == "1.4")
        return Ogre::MESH_VERSION_1_4;
    if (word == "1.41")
        return Ogre::MESH_VERSION_1_7;
    if (word == "1.8")
        return Ogre::MESH_VERSION_1_8;
    if (word == "1.10")
        return Ogre::MESH_VERSION_1_10;
    return withMessage(ErrorCode::InvalidSetting,
                       "'" + word + "' is no mesh version; there are 1.0, 1.4, 1.41, 1.8 and 1.10");
}

Result<Ogre::Serializer::Endian> parseEndian(const std::string& word)
{
    if (word == "native")
        return Ogre::Serializer::ENDIAN_NATIVE;
    if (word == "little")
        return Ogre::Serializer::ENDIAN_LITTLE;
    if (word == "big")
        return Ogre::Serializer::ENDIAN_BIG;
    return withMessage(ErrorCode::InvalidSetting, "'" + word + "' is no byte order; there are native, little and big");
}

bool holdsLevels(Ogre::MeshVersion version)
{
    return version != Ogre::MESH_VERSION_1_4 && version != Ogre::MESH_VERSION_1_0;
}

Result<std::string> meshBytes(const Ogre::Mesh& mesh, const MeshFormat& format)
{
    if (auto possible = checkFormat(mesh, format); !possible)
        return possible.error();
    const auto stream = std::make_shared<CollectingStream>();
    try {
        Ogre::MeshSerializer().exportMesh(&mesh, stream, format.version, format.endian);
    } catch (const Ogre::Exception& exception) {
        return withMessage(ErrorCode::Unsupported, "OGRE cannot write it: " + exception.getDescription());
    }
    return stream->bytes();
}

std::vector<Companion> findSkeleton(const Ogre::Mesh& mesh, const fs::path& meshPath, std::vector<std::string>& notes)
{
    if (!mesh.hasSkeleton())
        return {};
    const std::string& name = mesh.getSkeletonName();
    const fs::path source = meshPath.parent_path() / name;
    std::error_code ignored;
    if (!OgreSession::staysInside(name) || fs::path(name).extension() != ".skeleton")
        notes.push_back("skeleton '" + name
                        + "' is no .skeleton file below the mesh's directory: not read, not copied");
    else if (!fs::exists(source, ignored))
        notes.push_back("skeleton '" + name + "' is not there: not copied");
    else
        return {{source, name, std::nullopt}};
    return {};
}

std::int64_t nextFileTime()
{
    // Time stamps are taken from the clock of ticks, which lags behind, or from the exact one.
    timespec exact = {}, ticks = {};
    ::clock_gettime(CLOCK_REALTIME, &exact);
    do {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        ::clock_gettime(CLOCK_REALTIME_COARSE, &ticks);
    } while (nanoseconds(ticks) <= nanoseconds(exact));
    return nanoseconds(ticks);
}

Result<Done> checkOutput(const fs::path& target, Existing existing)
{
    const Result<Done> allowed = AtomicFile::checkTarget(target, existing);
    return allowed ? allowed : withHint(allowed.error(), target, existing);
}

Result<Done> writeMeshFiles(const fs::path& target, const std::string& bytes, const std::vector<Companion>& companions,
                            const Overwriting& overwriting)
{
    // All are prepared before the first appears: whatever can run out has run out by then.
    std::vector<Copy> copies;
    for (const Companion& companion : companions) {
        Result<Copy> copy = prepareCopy(companion, target.parent_path() / companion.name, overwriting.existing);
        if (!copy)
            return copy.error();
        copies.push_back(std::move(copy).value());
    }
    AtomicFile mesh(target, overwriting.existing);
    if (auto prepared = mesh.prepare(bytes); !prepared)
        return withHint(prepared.error(), target, overwriting.existing);

    for (const Copy& copy : copies)
        if (auto committed = commitCopy(copy, overwriting); !committed)
            return committed;
    return mesh.commit();
}

} // namespace lodsmith::cli
