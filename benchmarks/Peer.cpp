#include "Peer.h"

#include "CorePeer.h"
#include "LodsmithPeer.h"
#include "MeshoptPeer.h"
#include "OgrePeer.h"

namespace lodsmith::benchmarks {

std::vector<std::unique_ptr<Peer>> makePeers()
{
    SimplifyOptions curvature;
    curvature.metric = Metric::Curvature;
    SimplifyOptions positions;
    positions.weights = {0.0f, 0.0f, 0.0f, 0.0f};

    std::vector<std::unique_ptr<Peer>> peers;
    peers.push_back(std::make_unique<OgrePeer>(kOgreCurvature, OgrePeer::Cost::Curvature));
    peers.push_back(std::make_unique<OgrePeer>("ogre-quadric", OgrePeer::Cost::Quadric));
    peers.push_back(std::make_unique<MeshoptPeer>(kMeshoptimizer));
    peers.push_back(std::make_unique<LodsmithPeer>(kLodsmith, SimplifyOptions{}));
    peers.push_back(std::make_unique<CorePeer>(kLodsmithCore, SimplifyOptions{}));
    peers.push_back(std::make_unique<LodsmithPeer>(kLodsmithPositions, positions));
    peers.push_back(std::make_unique<LodsmithPeer>(kLodsmithCurvature, curvature));
    return peers;
}

std::unique_ptr<Peer> makePeer(const std::string& name)
{
    for (std::unique_ptr<Peer>& peer : makePeers())
        if (peer->name() == name)
            return std::move(peer);
    return nullptr;
}

Plan anywhere(const std::vector<LevelTarget>& targets)
{
    Plan plan;
    for (const LevelTarget& target : targets)
        plan.levels.push_back({target, 0.0});
    return plan;
}

Plan halvings()
{
    std::vector<LevelTarget> targets;
    for (const double share : {0.5, 0.75, 0.875, 0.9375})
        targets.push_back({LevelTarget::Kind::Proportional, share});
    return anywhere(targets);
}

Plan atTriangles(const std::vector<std::uint32_t>& counts)
{
    std::vector<LevelTarget> targets;
    for (const std::uint32_t count : counts)
        targets.push_back({LevelTarget::Kind::Triangles, double(count)});
    return anywhere(targets);
}

std::vector<LevelTarget> targetsOf(const Plan& plan)
{
    std::vector<LevelTarget> targets;
    for (const PlannedLevel& level : plan.levels)
        targets.push_back(level.target);
    return targets;
}

std::uint32_t triangleCount(const LevelIndices& level)
{
    std::size_t indices = 0;
    for (const auto& subMesh : level)
        indices += subMesh.size();
    return static_cast<std::uint32_t>(indices / 3);
}

} // namespace lodsmith::benchmarks
