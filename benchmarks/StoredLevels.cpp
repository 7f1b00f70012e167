#include "StoredLevels.h"

namespace lodsmith::benchmarks {

LevelIndices originalIndices(const MeshView& view)
{
    LevelIndices level;
    for (const SubMeshView& subMesh : view.subMeshes) {
        std::vector<std::uint32_t>& indices = level.emplace_back(subMesh.indexCount);
        for (std::uint32_t i = 0; i < subMesh.indexCount; ++i)
            indices[i] = subMesh.index(i);
    }
    return level;
}

std::vector<PeerLevel> storedLevels(const Subject& subject, const std::vector<bool>& skipped)
{
    std::vector<PeerLevel> levels;
    unsigned short stored = 0;
    for (const bool skip : skipped) {
        if (!skip)
            levels.push_back({subject.storedLevel(++stored), ""});
        else if (levels.empty())
            levels.push_back({originalIndices(subject.view()), ""});
        else
            levels.push_back(levels.back());
    }
    return levels;
}

std::vector<PeerLevel> chainLevels(const MeshView& original, const LodChain& chain)
{
    std::vector<PeerLevel> levels;
    LevelIndices current = originalIndices(original);
    for (const LodChainLevel& level : chain.levels) {
        if (!level.skipped)
            current = level.indices;
        levels.push_back({current, stopWord(level.stop)});
    }
    return levels;
}

const char* stopWord(StopReason stop)
{
    switch (stop) {
    case StopReason::TargetReached: return "";
    case StopReason::Locked: return "locked";
    case StopReason::Seam: return "seam";
    case StopReason::Topology: return "topology";
    }
    return "unknown";
}

} // namespace lodsmith::benchmarks
