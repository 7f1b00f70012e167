#include <lodsmith/cache/SimplifyCached.h>

#include <algorithm>
#include <utility>

namespace lodsmith {

namespace {

bool fits(const std::vector<std::uint32_t>& indices, std::uint32_t vertexCount)
{
    return indices.size() % 3 == 0
           && std::all_of(indices.begin(), indices.end(), [=](std::uint32_t index) { return index < vertexCount; });
}

bool fits(const LodChainLevel& level, const MeshView& mesh)
{
    if (level.skipped)
        return level.indices.empty();
    if (level.indices.size() != mesh.subMeshes.size())
        return false;
    for (std::size_t i = 0; i < mesh.subMeshes.size(); ++i)
        if (!fits(level.indices[i], mesh.vertexBuffers[mesh.subMeshes[i].vertexBuffer].vertexCount))
            return false;
    return true;
}

bool fits(const LodChain& chain, const MeshView& mesh, std::size_t levels)
{
    return chain.levels.size() == levels
           && std::all_of(chain.levels.begin(), chain.levels.end(),
                          [&](const LodChainLevel& level) { return fits(level, mesh); });
}

} // namespace

Result<CachedChain> simplifyCached(LodCache& cache, const MeshView& mesh, const std::vector<LevelTarget>& targets,
                                   const SimplifyOptions& options, Progress* progress,
                                   const std::function<void()>& inputRead, const ChainFinish& finish)
{
    const CacheKey key = cacheKey(mesh, targets, options, finish.name);
    auto found = cache.find(key);
    if (progress && progress->cancelled())
        return Error{ErrorCode::Cancelled, "cancelled"};
    if (found && fits(*found, mesh, targets.size())) {
        if (inputRead)
            inputRead();
        if (progress)
            progress->report(1.0f);
        return CachedChain{std::move(*found), true, std::nullopt};
    }
    Result<LodChain> made = simplify(mesh, targets, options, progress, inputRead);
    if (!made)
        return made.error();
    if (finish.apply)
        finish.apply(made.value());
    const Result<Done> stored = cache.store(key, made.value());
    return CachedChain{std::move(made).value(), false, stored ? std::nullopt : std::optional<Error>(stored.error())};
}

} // namespace lodsmith
