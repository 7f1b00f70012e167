#pragma once

#include <lodsmith/loddef/LodDefinition.h>

#include <iterator>
#include <string>
#include <string_view>

namespace lodsmith {

/// A word of the grammar. Several may mean the same; the first of them is the one that is written.
template <class T>
struct LoddefWord {
    const char* text;
    T meaning;
};

constexpr LoddefWord<bool> kBooleans[] = {{"true", true}, {"false", false}, {"1", true}, {"0", false}};

constexpr LoddefWord<LodDefinitionType> kTypes[] = {{"automatic", LodDefinitionType::Automatic},
                                                    {"user", LodDefinitionType::User}};

constexpr LoddefWord<LodStrategy> kStrategies[] = {
    {"distance", LodStrategy::DistanceSphere},        {"pixelcount", LodStrategy::PixelCount},
    {"distance_sphere", LodStrategy::DistanceSphere}, {"distance_box", LodStrategy::DistanceBox},
    {"pixel_count", LodStrategy::PixelCount},         {"screen_ratio_pixel_count", LodStrategy::ScreenRatioPixelCount}};

constexpr LoddefWord<LevelTarget::Kind> kMethods[] = {{"proportional", LevelTarget::Kind::Proportional},
                                                      {"constant", LevelTarget::Kind::Constant},
                                                      {"collapsecost", LevelTarget::Kind::CollapseCost},
                                                      {"triangles", LevelTarget::Kind::Triangles},
                                                      {"deviation", LevelTarget::Kind::Deviation}};

constexpr LoddefWord<Metric> kMetrics[] = {{"quadric", Metric::Quadric}, {"curvature", Metric::Curvature}};

constexpr LoddefWord<bool> kBorders[] = {{"locked", true}, {"free", false}};

/// A weight's attribute and where it is kept.
struct LoddefWeight {
    const char* attribute;
    std::optional<float> GivenAttributeWeights::*member;
};

constexpr LoddefWeight kWeights[] = {{"normal", &GivenAttributeWeights::normal},
                                     {"uv", &GivenAttributeWeights::uv},
                                     {"colour", &GivenAttributeWeights::colour},
                                     {"bone", &GivenAttributeWeights::bone}};

/// What a word means; null for one that the table does not have.
template <class T, std::size_t N>
const T* meaningOf(const LoddefWord<T> (&words)[N], std::string_view text)
{
    for (const LoddefWord<T>& word : words)
        if (text == word.text)
            return &word.meaning;
    return nullptr;
}

/// The word to write.
template <class T, std::size_t N>
const char* wordFor(const LoddefWord<T> (&words)[N], T meaning)
{
    for (const LoddefWord<T>& word : words)
        if (word.meaning == meaning)
            return word.text;
    return "";
}

/// "a, b and c".
template <class T, std::size_t N>
std::string wordList(const LoddefWord<T> (&words)[N])
{
    std::string list = words[0].text;
    for (std::size_t i = 1; i < N; ++i)
        list += std::string(i + 1 < N ? ", " : " and ") + words[i].text;
    return list;
}

} // namespace lodsmith
