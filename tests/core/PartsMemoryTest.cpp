// Compiled with parts of 64 vertices, and with the allocation of FailingMemory.cpp.

#include "DeterminismCases.h"
#include "FailingMemory.h"

#include <gtest/gtest.h>

namespace lodsmith {

namespace {

using namespace test;

TEST(Parts, MemoryThatRunsOutOnAnyThreadIsAnError)
{
    const TestMesh mesh = makeTerrain(40);
    const MeshView view = mesh.view();
    SimplifyOptions options;
    options.threads = 2;
    const std::string expected = outcomeOf(mesh, options);
    bool hasFailed = true;
    for (long allocations = 0; hasFailed; allocations += 1 + allocations / 8) {
        allocationsLeft = allocations;
        const Result<LodChain> result = simplify(view, kDeterminismTargets, options);
        hasFailed = allocationsLeft.exchange(-1) < 0;
        EXPECT_TRUE(hasFailed || allocations > 0) << "the allocation is not this program's own";
        if (result.ok()) // it was a thread that could not be started, or none failed
            EXPECT_EQ(bytesOf(result.value()), expected);
        else
            EXPECT_EQ(result.error().code, ErrorCode::OutOfMemory) << allocations;
    }
}

} // namespace

} // namespace lodsmith
