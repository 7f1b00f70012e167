#include "Subject.h"

#include "Tessellation.h"

#include <OgreHardwareBufferManager.h>
#include <OgreMeshManager.h>
#include <OgreResourceGroupManager.h>
#include <OgreSubMesh.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include <fnmatch.h>

namespace lodsmith::benchmarks {

namespace {

namespace fs = std::filesystem;

std::vector<std::uint32_t> readIndices(const Ogre::IndexData& data)
{
    std::vector<std::uint32_t> indices(data.indexCount);
    if (indices.empty())
        return indices;
    const auto& buffer = data.indexBuffer;
    const bool wide = buffer->getType() == Ogre::HardwareIndexBuffer::IT_32BIT;
    Ogre::HardwareBufferLockGuard lock(buffer, Ogre::HardwareBuffer::HBL_READ_ONLY);
    for (std::size_t i = 0; i < indices.size(); ++i) {
        const std::size_t at = data.indexStart + i;
        indices[i] = wide ? static_cast<const std::uint32_t*>(lock.pData)[at]
                          : static_cast<const std::uint16_t*>(lock.pData)[at];
    }
    return indices;
}

bool standsForNothing(const std::vector<std::uint32_t>& indices)
{
    return indices.size() == 3 && indices[0] == indices[1] && indices[1] == indices[2];
}

std::unique_ptr<Subject> loadFile(const std::string& name, const fs::path& path)
{
    // A group of its own for each file: meshes and skeletons of one name exist in several directories.
    const std::string group = path.string();
    auto& groups = Ogre::ResourceGroupManager::getSingleton();
    if (!groups.resourceGroupExists(group)) {
        groups.createResourceGroup(group, false);
        groups.addResourceLocation(path.parent_path().string(), "FileSystem", group);
    }
    return std::make_unique<Subject>(name, Ogre::MeshManager::getSingleton().load(path.filename().string(), group));
}

SubjectSource tessellationSource(Surface surface, std::uint32_t triangles, const std::string& size)
{
    const std::string name = (surface == Surface::Planet ? "planet-" : "terrain-") + size;
    constexpr double kBytesOfTriangle = 30.0;
    return {name, name, kBytesOfTriangle * triangles,
            [=] { return std::make_unique<Subject>(name, tessellate(name, surface, triangles)); }};
}

SubjectSource fileSource(const std::string& name, const fs::path& file)
{
    return {name, fs::absolute(file).lexically_normal().string(), double(fs::file_size(file)),
            [=] { return loadFile(name, file); }};
}

void addFiles(const fs::path& directory, std::vector<SubjectSource>& sources)
{
    if (directory.empty() || !fs::is_directory(directory))
        return;
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(directory))
        if (entry.is_regular_file() && entry.path().extension() == ".mesh")
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) {
        const std::string name = fs::relative(file, directory).replace_extension().generic_string();
        sources.push_back(fileSource(name, file));
    }
}

/// By the whole name or its last part.
bool matches(const std::string& name, const std::string& pattern)
{
    const std::string last = name.substr(name.rfind('/') + 1);
    return fnmatch(pattern.c_str(), name.c_str(), 0) == 0 || fnmatch(pattern.c_str(), last.c_str(), 0) == 0;
}

void addWish(const std::string& wish, std::vector<SubjectSource>& sources)
{
    const std::size_t before = sources.size();
    if (fs::is_directory(wish))
        addFiles(wish, sources);
    else if (fs::is_regular_file(wish))
        sources.push_back(fileSource(fs::path(wish).stem().string(), wish));
    else
        for (SubjectSource& source : allSubjects({}))
            if (matches(source.name, wish))
                sources.push_back(std::move(source));
    if (sources.size() == before)
        throw std::runtime_error(wish + ": no mesh, no directory of meshes, and no mesh of this name");
}

} // namespace

Subject::Subject(std::string name, Ogre::MeshPtr mesh)
    : mName(std::move(name)), mMesh(std::move(mesh)), mData(MeshReader::read(*mMesh))
{
    if (!mData)
        throw std::runtime_error(describe(mData.error()));
    for (const SubMeshView& subMesh : view().subMeshes)
        mTriangles += subMesh.indexCount / 3;
    removeLevels();
}

Subject::~Subject()
{
    Ogre::MeshManager::getSingleton().remove(mMesh);
}

bool Subject::hasUvs() const
{
    const auto& buffers = view().vertexBuffers;
    return std::any_of(buffers.begin(), buffers.end(), [](const auto& buffer) { return !buffer.uvSets.empty(); });
}

bool Subject::hasNormals() const
{
    const auto& buffers = view().vertexBuffers;
    return std::any_of(buffers.begin(), buffers.end(), [](const auto& buffer) { return bool(buffer.normals); });
}

void Subject::removeLevels()
{
    mMesh->freeEdgeList();
    mMesh->removeLodLevels();
}

LevelIndices Subject::storedLevel(unsigned short stored) const
{
    LevelIndices level(view().subMeshes.size());
    const std::vector<int>& subMeshOf = mData.value().subMeshOf();
    for (std::size_t i = 0; i < subMeshOf.size(); ++i) {
        if (subMeshOf[i] < 0)
            continue;
        std::vector<std::uint32_t> indices = readIndices(*mMesh->getSubMesh(i)->mLodFaceList.at(stored - 1));
        if (!standsForNothing(indices))
            level[std::size_t(subMeshOf[i])] = std::move(indices);
    }
    return level;
}

MeshView levelView(const MeshView& original, const LevelIndices& level)
{
    MeshView view = original;
    for (std::size_t i = 0; i < view.subMeshes.size(); ++i) {
        view.subMeshes[i].indices = level[i].data();
        view.subMeshes[i].indexCount = static_cast<std::uint32_t>(level[i].size());
        view.subMeshes[i].indexBytes = 4;
    }
    return view;
}

std::vector<SubjectSource> scalingSubjects()
{
    return {
        tessellationSource(Surface::Planet, 1000, "1k"),     tessellationSource(Surface::Planet, 4000, "4k"),
        tessellationSource(Surface::Planet, 16000, "16k"),   tessellationSource(Surface::Planet, 64000, "64k"),
        tessellationSource(Surface::Planet, 256000, "256k"), tessellationSource(Surface::Planet, 1000000, "1M"),
    };
}

SubjectSource hugeSubject()
{
    return tessellationSource(Surface::Planet, 10000000, "10M");
}

namespace {

std::vector<SubjectSource> tessellations()
{
    std::vector<SubjectSource> sources = scalingSubjects();
    sources.push_back(tessellationSource(Surface::Terrain, 64000, "64k"));
    sources.push_back(tessellationSource(Surface::Terrain, 1000000, "1M"));
    return sources;
}

} // namespace

std::vector<SubjectSource> allSubjects(const std::vector<std::string>& furtherMedia)
{
    std::vector<SubjectSource> sources;
    addFiles(LODSMITH_BENCHMARK_MEDIA, sources);
    addFiles(LODSMITH_BENCHMARK_EXTRA_MEDIA, sources);
    for (const std::string& directory : furtherMedia)
        addFiles(directory, sources);
    for (SubjectSource& source : tessellations())
        sources.push_back(std::move(source));
    return sources;
}

SubjectSource sourceFrom(const std::string& origin)
{
    if (fs::is_regular_file(origin))
        return fileSource(fs::path(origin).stem().string(), origin);
    for (SubjectSource& source : tessellations())
        if (source.origin == origin)
            return std::move(source);
    if (SubjectSource huge = hugeSubject(); huge.origin == origin)
        return huge;
    throw std::runtime_error(origin + ": no such mesh");
}

std::vector<SubjectSource> chosenSubjects(const std::vector<std::string>& wishes)
{
    if (wishes.empty())
        return allSubjects({});
    std::vector<SubjectSource> sources;
    for (const std::string& wish : wishes)
        addWish(wish, sources);
    return sources;
}

} // namespace lodsmith::benchmarks
