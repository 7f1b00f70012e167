#include "DefinitionCheck.h"

#include "NumberText.h"
#include "XmlScan.h"

#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace lodsmith {

namespace {

// The distance strategies square their values, and a float has to hold the square.
constexpr float kLargestValue = 1e18f;
constexpr double kLargestCount = 4294967295.0;
constexpr std::size_t kLongestQuote = 60;
constexpr const char* kBlanks = " \t\r\n";

bool within(double number, double least, double most)
{
    return number >= least && number <= most;
}

/// What is wrong with an amount; none when nothing is.
std::optional<std::string> findAmountError(const LevelTarget& target)
{
    const auto wrong = [&target](const char* allowed) {
        const std::string method = wordFor(kMethods, target.kind);
        return notAllowed("the value for the method " + method, textFromNumber(target.amount), allowed);
    };
    switch (target.kind) {
    case LevelTarget::Kind::Proportional:
        if (!within(target.amount, 0.0, 1.0))
            return wrong("the share of vertices removed, 0 to 1");
        break;
    case LevelTarget::Kind::Constant:
        if (!within(target.amount, 0.0, kLargestCount))
            return wrong("the number of vertices removed, 0 to 4294967295");
        break;
    case LevelTarget::Kind::Triangles:
        if (!within(target.amount, 0.0, kLargestCount) || target.amount != std::floor(target.amount))
            return wrong("the number of triangles kept, a whole number from 0 to 4294967295");
        break;
    case LevelTarget::Kind::Deviation:
    case LevelTarget::Kind::CollapseCost:
        if (!(target.amount >= 0.0) || std::isinf(target.amount))
            return wrong("a length in world units, 0 or more");
        break;
    }
    return std::nullopt;
}

std::optional<std::string> findNameError(const std::string& name)
{
    const std::string allowed = "the name of a mesh, 1 to " + std::to_string(kMaxMeshNameBytes)
                                + " bytes of UTF-8 without control characters and without blanks around it";
    const bool blankAround =
        !name.empty() && (name.find_first_of(kBlanks) == 0 || name.find_last_of(kBlanks) == name.size() - 1);
    if (name.empty() || name.size() > kMaxMeshNameBytes || blankAround || !isXmlText(name)
        || name.find_first_of("\t\r\n") != std::string::npos)
        return notAllowed("the mesh name", name, allowed);
    return std::nullopt;
}

class DefinitionCheck {
public:
    DefinitionCheck(const LodDefinition& definition, const DefinitionLines* lines)
        : mDefinition(definition), mLines(lines)
    {
    }

    std::vector<Error> run()
    {
        if (mDefinition.levels.size() > kMaxLoddefLevels)
            add(-1, std::to_string(mDefinition.levels.size())
                        + " levels are too many; allowed: " + std::to_string(kMaxLoddefLevels));
        for (std::size_t i = 0; i < mDefinition.levels.size(); ++i)
            checkLevel(i);
        checkWeights();
        for (std::size_t i = 0; i < mDefinition.subMeshes.size(); ++i)
            checkSubMesh(i);
        return std::move(mErrors);
    }

private:
    void add(int line, std::string message)
    {
        Error error{ErrorCode::InvalidSetting, std::move(message)};
        error.line = line;
        mErrors.push_back(std::move(error));
    }

    LevelLines linesOf(std::size_t level) const { return mLines ? mLines->levels[level] : LevelLines(); }

    /// A line says where; without lines the number of the level does.
    void addForLevel(std::size_t level, int line, const std::string& message)
    {
        add(line, mLines ? message : "level " + std::to_string(level + 1) + ": " + message);
    }

    void checkLevel(std::size_t index)
    {
        const LodLevelDefinition& level = mDefinition.levels[index];
        const LevelLines lines = linesOf(index);
        if (!within(level.value, std::numeric_limits<float>::denorm_min(), kLargestValue))
            addForLevel(index, lines.value,
                        notAllowed("distance", textFromNumber(level.value), "a number above 0 and at most 1e18"));
        else
            checkFirst(index, lines.value);
        const bool named = mLines ? lines.meshName >= 0 : level.isManual();
        if (named) {
            if (auto message = findNameError(level.meshName))
                addForLevel(index, lines.meshName, *message);
        } else if (mDefinition.type == LodDefinitionType::User) {
            addForLevel(index, lines.level, "the level has no mesh name; under the type user every level needs one");
        } else if (auto message = findAmountError(level.target)) {
            addForLevel(index, lines.amount, *message);
        }
    }

    void checkFirst(std::size_t index, int line)
    {
        const auto [first, isNew] = mLevelOfValue.emplace(mDefinition.levels[index].value, index);
        if (isNew)
            return;
        const std::string other = mLines ? "the level in line " + std::to_string(linesOf(first->second).level)
                                         : "level " + std::to_string(first->second + 1);
        addForLevel(index, line,
                    "distance " + quoted(textFromNumber(first->first)) + " is that of " + other
                        + " already; allowed: each distance once");
    }

    void checkWeights()
    {
        for (std::size_t i = 0; i < std::size(kWeights); ++i) {
            const std::optional<float>& given = mDefinition.weights.*kWeights[i].member;
            if (given && !within(*given, 0.0, std::numeric_limits<float>::max()))
                add(mLines ? mLines->weightOf[i] : -1, notAllowed(std::string("the weight ") + kWeights[i].attribute,
                                                                  textFromNumber(*given), "a number of 0 or more"));
        }
        if (mDefinition.weights.any() && simplifyOptions(mDefinition).metric == Metric::Curvature)
            add(mLines ? mLines->weights : -1,
                "weights are given, and the metric is 'curvature' (as it is when none is named and a level has the "
                "method collapsecost), which knows none; allowed: the metric quadric");
    }

    void checkSubMesh(std::size_t index)
    {
        const SubMeshImportance& entry = mDefinition.subMeshes[index];
        const int line = mLines ? mLines->subMeshes[index] : -1;
        const std::string name = "submesh " + std::to_string(entry.subMesh);
        if (!within(entry.importance, 0.0, 1.0))
            add(line,
                notAllowed("the importance of " + name, textFromNumber(entry.importance), "a number from 0 to 1"));
        if (!mEntryOfSubMesh.emplace(entry.subMesh, index).second)
            add(line, name + " has an importance already; allowed: one each");
    }

    const LodDefinition& mDefinition;
    const DefinitionLines* mLines;
    std::vector<Error> mErrors;
    std::map<float, std::size_t> mLevelOfValue;
    std::map<std::uint16_t, std::size_t> mEntryOfSubMesh;
};

} // namespace

std::string shortened(std::string_view text)
{
    if (text.size() <= kLongestQuote)
        return std::string(text);
    std::size_t end = kLongestQuote;
    // Not within a UTF-8 sequence.
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80)
        --end;
    return std::string(text.substr(0, end)) + "...";
}

std::string quoted(std::string_view text)
{
    return "'" + shortened(text) + "'";
}

std::string notAllowed(const std::string& what, std::string_view found, const std::string& allowed)
{
    return what + " is " + quoted(found) + "; allowed: " + allowed;
}

std::vector<Error> findErrors(const LodDefinition& definition, const DefinitionLines* lines)
{
    return DefinitionCheck(definition, lines).run();
}

} // namespace lodsmith
