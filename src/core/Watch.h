#pragma once

#include "CollapseMesh.h"

#include <lodsmith/core/Progress.h>

#include <algorithm>

namespace lodsmith {

/// Reports how many of the vertices that the levels ask to remove are gone, and hears of a cancel.
class Watch {
public:
    /// @param progress may be null
    /// @param vertices of the mesh
    /// @param least    that are to be left of them
    Watch(Progress* progress, std::uint32_t vertices, std::uint32_t least)
        : mProgress(progress), mVertices(vertices), mWanted(mVertices - std::min<double>(least, mVertices))
    {
    }

    /// One thread at a time reports, and counts that do not rise. False when cancelled.
    bool report(std::uint32_t left) const
    {
        if (mProgress)
            mProgress->report(mWanted > 0.0 ? static_cast<float>(std::min(1.0, (mVertices - left) / mWanted)) : 0.0f);
        return !isCancelled();
    }

    /// Any thread may ask.
    bool isCancelled() const { return mProgress && mProgress->cancelled(); }

private:
    Progress* mProgress;
    double mVertices, mWanted;
};

} // namespace lodsmith
