#pragma once

#include "Subject.h"

#include <lodsmith/core/Simplify.h>

#include <memory>
#include <string>
#include <vector>

namespace lodsmith::benchmarks {

/// A level that a peer is asked for.
struct PlannedLevel {
    LevelTarget target;
    /// pixel_count at which the level appears (LodConfig.h); 0 where nobody has said.
    double pixels = 0.0;
};

/// What a peer is asked for.
struct Plan {
    std::vector<PlannedLevel> levels;
    /// Above 0 the levels are candidates of which the peer chooses at most so many, LodConfig::mostLevels.
    unsigned mostLevels = 0;
};

/// Levels that nobody has said when to show.
Plan anywhere(const std::vector<LevelTarget>& targets);

/// One level as a peer left it.
struct PeerLevel {
    LevelIndices indices;
    std::string stop; ///< why it holds more than its target, empty when the peer does not say
};

/// One way to make a chain of levels, measured beside the others on the same work.
class Peer {
public:
    explicit Peer(std::string name) : mName(std::move(name)) {}
    virtual ~Peer() = default;

    const std::string& name() const { return mName; }

    /// The options of a peer that is Lodsmith's own; null for the others.
    virtual const SimplifyOptions* options() const { return nullptr; }

    /// False for a target kind that the peer does not know: OGRE's generator has no triangle targets.
    virtual bool knows(LevelTarget::Kind kind) const = 0;

    /// True for a peer that chooses among candidates.
    virtual bool chooses() const { return false; }

    /// Makes the whole chain and returns the seconds that count. The subject has no levels yet; one thread.
    virtual double generate(Subject& subject, const Plan& plan) = 0;

    /// What the last generate() made, one level for each that was asked for; level 1 first.
    virtual std::vector<PeerLevel> levels(const Subject& subject) const = 0;

    /// Drops what generate() made. Not timed.
    virtual void reset(Subject& subject) = 0;

private:
    std::string mName;
};

/// Names of the peers that tables compare with.
inline constexpr const char* kOgreCurvature = "ogre-curvature";
inline constexpr const char* kMeshoptimizer = "meshoptimizer";
inline constexpr const char* kLodsmith = "lodsmith";
inline constexpr const char* kLodsmithCore = "lodsmith-core";
inline constexpr const char* kLodsmithPositions = "lodsmith-positions";
inline constexpr const char* kLodsmithCurvature = "lodsmith-curvature";

/// Every peer, in the order of the tables' columns.
std::vector<std::unique_ptr<Peer>> makePeers();

/// One of them by name; null where there is none of that name.
std::unique_ptr<Peer> makePeer(const std::string& name);

/// Four levels at 0.5, 0.75, 0.875 and 0.9375 of the vertices removed.
Plan halvings();

/// One level for each number of triangles.
Plan atTriangles(const std::vector<std::uint32_t>& counts);

std::vector<LevelTarget> targetsOf(const Plan& plan);

std::uint32_t triangleCount(const LevelIndices& level);

} // namespace lodsmith::benchmarks
