#include "support/Invariants.h"
#include "support/MeshFromBytes.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdint>
#include <vector>

namespace lodsmith {

namespace {

using namespace test;

using Bytes = std::vector<std::uint8_t>;

/// Long enough to reach into every choice that a case makes.
rc::Gen<Bytes> bytes()
{
    return rc::gen::mapcat(rc::gen::inRange<std::size_t>(0, 600), [](std::size_t size) {
        return rc::gen::container<Bytes>(size, rc::gen::arbitrary<std::uint8_t>());
    });
}

SimplifyCase caseOf(const Bytes& source, Trust trust)
{
    ByteSource stream(source.data(), source.size());
    return caseFromBytes(stream, trust);
}

RC_GTEST_PROP(Property, ValidMeshesGiveSoundChains, ())
{
    const SimplifyCase made = caseOf(*bytes(), Trust::Valid);
    const MeshView view = made.mesh.view();
    const Result<LodChain> result = simplify(view, made.targets, made.options);
    if (!result)
        RC_FAIL(describe(result.error()));
    for (const std::string& sentence : brokenInvariants(view, made.targets, made.options, result.value(), {200}))
        RC_FAIL(sentence);
}

RC_GTEST_PROP(Property, GarbageIsCleanedOrRefused, ())
{
    const SimplifyCase made = caseOf(*bytes(), Trust::Garbage);
    const MeshView view = made.mesh.view();
    const Result<LodChain> result = simplify(view, made.targets, made.options);
    if (!result) {
        const ErrorCode code = result.error().code;
        RC_ASSERT(code == ErrorCode::InvalidGeometry || code == ErrorCode::IndexOutOfRange
                  || code == ErrorCode::InvalidSetting);
        RC_ASSERT(!result.error().message.empty());
        return;
    }
    for (const std::string& sentence : brokenInvariants(view, made.targets, made.options, result.value(), {200}))
        RC_FAIL(sentence);
}

RC_GTEST_PROP(Property, UnreferencedVerticesInFrontChangeNothingButTheIndices, ())
{
    SimplifyCase made = caseOf(*bytes(), Trust::Valid);
    made.mesh.buffers.resize(1);
    made.mesh.subMeshes.resize(1);
    const Result<LodChain> before = simplify(made.mesh.view(), made.targets, made.options);
    RC_ASSERT(before.ok());
    TestBuffer& buffer = made.mesh.buffers[0];
    const auto prepend = [](std::vector<float>& stream, std::size_t count) {
        if (!stream.empty())
            stream.insert(stream.begin(), count, 0.25f);
    };
    prepend(buffer.positions, 3);
    prepend(buffer.normals, 3);
    prepend(buffer.colours, 4);
    prepend(buffer.importance, 1);
    for (std::vector<float>& set : buffer.uvSets)
        prepend(set, 2);
    for (std::vector<std::vector<float>>* streams : {&buffer.offsets, &buffer.poses})
        for (std::vector<float>& stream : *streams)
            prepend(stream, 3);
    if (!buffer.bones.empty())
        buffer.bones.insert(buffer.bones.begin(), BoneInfluences());
    for (std::uint32_t& index : made.mesh.subMeshes[0].indices)
        ++index;

    const Result<LodChain> after = simplify(made.mesh.view(), made.targets, made.options);
    RC_ASSERT(after.ok());
    for (std::size_t i = 0; i < made.targets.size(); ++i) {
        RC_ASSERT(after.value().levels[i].deviation == before.value().levels[i].deviation);
        std::vector<std::vector<std::uint32_t>> shifted = before.value().levels[i].indices;
        for (std::vector<std::uint32_t>& list : shifted) {
            for (std::uint32_t& index : list)
                ++index;
        }
        RC_ASSERT(after.value().levels[i].indices == shifted);
    }
}

RC_GTEST_PROP(Property, ALevelIsAMeshThatCanBeSimplifiedOn, ())
{
    SimplifyCase made = caseOf(*bytes(), Trust::Valid);
    made.targets = {{LevelTarget::Kind::Proportional, 0.3}};
    const Result<LodChain> first = simplify(made.mesh.view(), made.targets, made.options);
    RC_ASSERT(first.ok());
    if (first.value().levels[0].skipped)
        return;
    const MeshView level = made.mesh.view(first.value().levels[0]);
    const Result<LodChain> second = simplify(level, made.targets, made.options);
    RC_ASSERT(second.ok());
    RC_ASSERT(second.value().vertices == first.value().levels[0].vertices);
    RC_ASSERT(second.value().cleaned.degenerateTriangles == 0u);
    RC_ASSERT(second.value().cleaned.repeatedTriangles == 0u);
    for (const std::string& sentence : brokenInvariants(level, made.targets, made.options, second.value(), {200}))
        RC_FAIL(sentence);
}

} // namespace

} // namespace lodsmith
