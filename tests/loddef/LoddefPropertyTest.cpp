#include <lodsmith/loddef/LoddefXml.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace lodsmith {

namespace {

using Kind = LevelTarget::Kind;

/// Any bits that make a number between two bounds, small ones and those with every digit alike.
template <class T>
rc::Gen<T> numbers(T least, T most)
{
    const auto anyBits = rc::gen::map(rc::gen::arbitrary<std::uint64_t>(), [](std::uint64_t bits) {
        T number;
        std::memcpy(&number, &bits, sizeof number);
        return number;
    });
    const auto plain =
        rc::gen::map(rc::gen::inRange<int>(0, 100000), [](int number) { return static_cast<T>(number) / T(64); });
    return rc::gen::suchThat(rc::gen::weightedOneOf<T>({{1, anyBits}, {2, plain}}),
                             [=](T number) { return number >= least && number <= most; });
}

rc::Gen<std::string> meshNames()
{
    const auto parts = rc::gen::element<std::string>("a", "B", "/", "\\", ".", "&", "<", ">", "'", "\"", "]]>", "--",
                                                     "&amp;", "\xc3\xa9", "\xf0\x9f\x8c\xb2", " x");
    return rc::gen::map(rc::gen::container<std::vector<std::string>>(parts),
                        [](const std::vector<std::string>& pieces) {
                            std::string name = "m";
                            for (const std::string& piece : pieces)
                                name += piece;
                            return name;
                        });
}

LevelTarget makeTarget()
{
    const Kind kind =
        *rc::gen::element(Kind::Proportional, Kind::Constant, Kind::Triangles, Kind::Deviation, Kind::CollapseCost);
    switch (kind) {
    case Kind::Proportional: return {kind, *numbers(0.0, 1.0)};
    case Kind::Constant: return {kind, *numbers(0.0, 4294967295.0)};
    case Kind::Triangles: return {kind, static_cast<double>(*rc::gen::arbitrary<std::uint32_t>())};
    default: return {kind, *numbers(0.0, std::numeric_limits<double>::max())};
    }
}

std::vector<LodLevelDefinition> makeLevels(LodDefinitionType type)
{
    std::vector<LodLevelDefinition> levels;
    const auto values = *rc::gen::container<std::set<float>>(numbers(std::numeric_limits<float>::denorm_min(), 1e18f));
    for (const float value : values) {
        const bool manual = type == LodDefinitionType::User || *rc::gen::inRange(0, 4) == 0;
        levels.push_back({value, manual ? LevelTarget() : makeTarget(), manual ? *meshNames() : "", ""});
        if (levels.size() == 12)
            break;
    }
    return levels;
}

std::optional<float> maybeWeight()
{
    return *rc::gen::arbitrary<bool>() ? std::optional(*numbers(0.0f, std::numeric_limits<float>::max()))
                                       : std::nullopt;
}

LodDefinition makeDefinition()
{
    LodDefinition definition;
    definition.automatic = *rc::gen::arbitrary<bool>();
    definition.type = *rc::gen::element(LodDefinitionType::Automatic, LodDefinitionType::User);
    definition.strategy = *rc::gen::element(LodStrategy::DistanceSphere, LodStrategy::DistanceBox,
                                            LodStrategy::PixelCount, LodStrategy::ScreenRatioPixelCount);
    definition.levels = makeLevels(definition.type);
    definition.metric = *rc::gen::element<std::optional<Metric>>(std::nullopt, Metric::Quadric, Metric::Curvature);
    if (simplifyOptions(definition).metric == Metric::Quadric)
        definition.weights = {maybeWeight(), maybeWeight(), maybeWeight(), maybeWeight()};
    definition.lockBorders = *rc::gen::arbitrary<bool>();
    for (const std::uint16_t subMesh :
         *rc::gen::container<std::set<std::uint16_t>>(rc::gen::arbitrary<std::uint16_t>()))
        definition.subMeshes.push_back({subMesh, *numbers(0.0f, 1.0f)});
    return definition;
}

std::string textOf(const LodDefinition& definition)
{
    const Result<std::string> text = loddefText(definition);
    if (!text)
        RC_FAIL(describe(text.error()));
    return text.value();
}

LodDefinition readBack(const std::string& text)
{
    const LoddefReading reading = parseLoddef(text, "");
    if (!reading.ok())
        RC_FAIL(describe(reading.errors.front()));
    RC_ASSERT(reading.warnings.empty());
    return *reading.definition;
}

} // namespace

RC_GTEST_PROP(LoddefProperty, WhatIsWrittenIsReadAgain, ())
{
    const LodDefinition definition = makeDefinition();
    const std::string text = textOf(definition);
    const LodDefinition again = readBack(text);
    RC_ASSERT(again == definition);
    RC_ASSERT(textOf(again) == text);
}

RC_GTEST_PROP(LoddefProperty, ADefinitionWrittenOverAnyOtherIsReadAgain, ())
{
    const LodDefinition first = readBack(textOf(makeDefinition()));
    LodDefinition second = makeDefinition();
    second.original = first.original;
    // Some levels are those of the first, edited.
    for (std::size_t i = 0; i < second.levels.size() && i < first.levels.size(); ++i)
        if (*rc::gen::arbitrary<bool>())
            second.levels[i].original = first.levels[*rc::gen::inRange<std::size_t>(0, first.levels.size())].original;
    const std::string text = textOf(second);
    RC_ASSERT(readBack(text) == second);
    RC_ASSERT(textOf(readBack(text)) == text);
}

} // namespace lodsmith
