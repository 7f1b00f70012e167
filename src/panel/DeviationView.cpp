#include "DeviationView.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace lodsmith {

namespace {

using Distances = std::vector<std::vector<float>>;

Distances noDistances(const MeshView& mesh)
{
    Distances distances;
    for (const VertexBufferView& buffer : mesh.vertexBuffers)
        distances.emplace_back(buffer.vertexCount, 0.0f);
    return distances;
}

bool areOf(const MeshView& mesh, const Distances& distances)
{
    return std::equal(
        mesh.vertexBuffers.begin(), mesh.vertexBuffers.end(), distances.begin(), distances.end(),
        [](const VertexBufferView& buffer, const auto& list) { return buffer.vertexCount == list.size(); });
}

/// What one vertex in twenty of those that are off is beyond: the greatest distance of all may be that of a single vertex, next to
/// which the rest would look alike.
double scaleOf(const Distances& distances)
{
    std::vector<float> off;
    for (const auto& list : distances)
        std::copy_if(list.begin(), list.end(), std::back_inserter(off), [](float distance) { return distance > 0; });
    if (off.empty())
        return 0;
    const auto nth = off.begin() + static_cast<long>((off.size() - 1) * 19 / 20);
    std::nth_element(off.begin(), nth, off.end());
    return static_cast<double>(*nth);
}

} // namespace

DeviationView::DeviationView(LevelAnalyser& analyser, Ogre::SceneNode& node, const Ogre::MaterialPtr& material)
    : mAnalyser(analyser), mNode(node), mMaterial(material)
{
}

void DeviationView::forget()
{
    mLevels.clear();
    mMesh.reset();
    mWanted.clear();
    mError.clear();
    mHasChanged = true;
}

void DeviationView::forgetLevels()
{
    mError.clear();
    for (auto& [number, level] : mLevels) {
        level.isCurrent = level.hasFailed = false;
        level.job.reset();
    }
}

void DeviationView::hide()
{
    mWanted.clear();
    for (auto& [number, level] : mLevels)
        level.map.reset();
}

void DeviationView::want(const Ogre::MeshPtr& mesh, const std::vector<unsigned>& levels)
{
    if (!readMesh(*mesh))
        return;
    const bool areOthers = levels != mWanted;
    if (areOthers)
        hide();
    mWanted = levels;
    for (const unsigned level : levels)
        if (!mLevels[level].isCurrent && !mLevels[level].job && !mLevels[level].hasFailed)
            measure(mesh, level);
    if (areOthers)
        paint();
}

bool DeviationView::readMesh(const Ogre::Mesh& mesh)
{
    if (mMesh || !mError.empty())
        return mMesh.has_value();
    Result<MeshData> read = MeshReader::read(mesh);
    if (read)
        mMesh = std::move(read).value();
    else
        mError = describe(read.error());
    return mMesh.has_value();
}

void DeviationView::measure(const Ogre::MeshPtr& mesh, unsigned level)
{
    if (level == 0) {
        receive(0, noDistances(mMesh->view()));
        return;
    }
    auto job = mAnalyser.distances(mesh, level, [this, level](const auto& distances) { receive(level, distances); });
    if (job)
        mLevels[level].job = std::move(job).value();
    else
        fail(mLevels[level], job.error());
}

void DeviationView::receive(unsigned number, const Result<Distances>& distances)
{
    Level& level = mLevels[number];
    // Destroyed once the callback that this may be in has returned.
    const LevelAnalyser::JobPtr job = std::move(level.job);
    if (!distances)
        return fail(level, distances.error());
    if (!areOf(mMesh->view(), distances.value()))
        return fail(level, Error{ErrorCode::InvalidGeometry, "the mesh was changed while it was measured"});
    level.distances = distances.value();
    level.scale = scaleOf(level.distances);
    level.isCurrent = true;
    paint();
}

void DeviationView::fail(Level& level, const Error& error)
{
    level.hasFailed = true;
    level.map.reset();
    level.distances.clear();
    mError = describe(error);
    mHasChanged = true;
}

void DeviationView::paint()
{
    double scale = 0;
    for (const unsigned number : mWanted)
        scale = std::max(scale, mLevels[number].scale);
    for (const unsigned number : mWanted) {
        Level& level = mLevels[number];
        if (level.distances.empty())
            continue;
        if (!level.map)
            level.map = std::make_unique<HeatMap>(mNode, mMaterial);
        level.map->paint(mMesh->view(), level.distances, scale);
    }
    mHasChanged = true;
}

HeatMap* DeviationView::mapOf(unsigned level)
{
    const auto found = mLevels.find(level);
    return found == mLevels.end() ? nullptr : found->second.map.get();
}

bool DeviationView::takeChange()
{
    return std::exchange(mHasChanged, false);
}

std::optional<double> DeviationView::scale() const
{
    double scale = 0;
    for (const unsigned number : mWanted) {
        const auto level = mLevels.find(number);
        if (level == mLevels.end() || !level->second.isCurrent)
            return std::nullopt;
        scale = std::max(scale, level->second.scale);
    }
    return mWanted.empty() ? std::nullopt : std::optional(scale);
}

} // namespace lodsmith
