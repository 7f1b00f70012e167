#pragma once

#include "Invariants.h"

#include <lodsmith/core/Simplify.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace lodsmith::test {

inline LevelTarget removedShare(double share)
{
    return {LevelTarget::Kind::Proportional, share};
}

inline LevelTarget removedVertices(double count)
{
    return {LevelTarget::Kind::Constant, count};
}

inline LevelTarget keptTriangles(double count)
{
    return {LevelTarget::Kind::Triangles, count};
}

inline LevelTarget greatestDeviation(double worldUnits)
{
    return {LevelTarget::Kind::Deviation, worldUnits};
}

inline LevelTarget dearestCollapse(double worldUnits)
{
    return {LevelTarget::Kind::CollapseCost, worldUnits};
}

/// simplify() that is expected to succeed, with every invariant checked. On a failure, which fails the test, the
/// result is a chain of empty levels, so that the test can go on reading.
inline LodChain simplifyChecked(const MeshView& mesh, const std::vector<LevelTarget>& targets,
                                const SimplifyOptions& options = {}, const InvariantOptions& check = {})
{
    Result<LodChain> result = simplify(mesh, targets, options);
    if (!result) {
        ADD_FAILURE() << toString(result.error().code) << ": " << describe(result.error());
        LodChain none;
        none.levels.resize(targets.size());
        for (LodChainLevel& level : none.levels)
            level.indices.resize(mesh.subMeshes.size());
        return none;
    }
    EXPECT_THAT(brokenInvariants(mesh, targets, options, result.value(), check), ::testing::IsEmpty());
    return std::move(result).value();
}

} // namespace lodsmith::test
