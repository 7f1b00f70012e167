#include "FrameFigures.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace lodsmith::samples {

namespace {

/// What so large a share of the values lies below. Of no values: 0.
template <class Number>
Number quantile(std::vector<Number> values, double share)
{
    if (values.empty())
        return Number(0);
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

} // namespace

bool FrameFigures::prequeueEntityMeshLodChanged(Ogre::EntityMeshLodChangedEvent& event)
{
    ++mObjects[std::min<std::size_t>(event.newLodIndex, mObjects.size() - 1)];
    mChanges += event.newLodIndex != event.previousLodIndex ? 1 : 0;
    return false;
}

void FrameFigures::endFrame(const Ogre::RenderTarget::FrameStats& statistics, double milliseconds)
{
    mMilliseconds.push_back(milliseconds);
    mTriangles.push_back(statistics.triangleCount);
    mBatches.push_back(statistics.batchCount);
}

void FrameFigures::restart()
{
    *this = FrameFigures();
}

std::string FrameFigures::news()
{
    std::ostringstream text;
    text << std::fixed << std::setprecision(1)
         << quantile<double>({mMilliseconds.begin() + static_cast<std::ptrdiff_t>(mFramesBefore), mMilliseconds.end()},
                             0.5)
         << " ms, " << mTriangles.back() << " triangles, " << mBatches.back() << " draw calls\nobjects by level:";
    const auto end = std::find_if(mObjects.rbegin(), mObjects.rend(), [](unsigned objects) { return objects > 0; });
    for (auto objects = mObjects.begin(); objects != end.base(); ++objects)
        text << ' ' << *objects;
    text << "\nlevels changed: " << mChanges - mChangesBefore;
    mFramesBefore = mMilliseconds.size();
    mChangesBefore = mChanges;
    return text.str();
}

std::string FrameFigures::summary() const
{
    const double processorTime = 1000.0 * static_cast<double>(std::clock() - mProcessorTime) / CLOCKS_PER_SEC;
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << mMilliseconds.size() << " frames: median "
         << quantile(mMilliseconds, 0.5) << " ms (95%: " << quantile(mMilliseconds, 0.95) << "), of processor time "
         << processorTime / static_cast<double>(mMilliseconds.size()) << " ms; median " << quantile(mTriangles, 0.5)
         << " triangles (most: " << quantile(mTriangles, 1.0) << "), median " << quantile(mBatches, 0.5)
         << " draw calls, " << mChanges << " changes of level";
    return text.str();
}

} // namespace lodsmith::samples
