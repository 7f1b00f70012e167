#include "LoddefReader.h"

#include "LoddefElements.h"
#include "NumberText.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

namespace lodsmith {

namespace {

bool contains(std::initializer_list<std::string_view> names, std::string_view name)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// Attributes by which XML tools say what a file is; they are nobody's mistake.
bool belongsToXml(std::string_view attribute)
{
    return attribute == "xmlns" || attribute.substr(0, 6) == "xmlns:" || attribute.substr(0, 4) == "xsi:"
           || attribute.substr(0, 4) == "xml:";
}

std::string tag(const tinyxml2::XMLElement& element)
{
    return "<" + shortened(element.Name()) + ">";
}

} // namespace

const tinyxml2::XMLElement* LoddefReader::Children::add(const Element& child)
{
    const auto [entry, isNew] = mByName.emplace(child.Name(), &child);
    return isNew ? nullptr : entry->second;
}

const tinyxml2::XMLElement* LoddefReader::Children::operator[](std::string_view name) const
{
    const auto entry = mByName.find(name);
    return entry == mByName.end() ? nullptr : entry->second;
}

LoddefReading LoddefReader::read(const tinyxml2::XMLDocument& document)
{
    const Element* root = findRoot(document);
    if (root && knowsVersion(*root))
        readRoot(*root);
    for (Error& error : findErrors(mDefinition, &mLines))
        mErrors.push_back(std::move(error));
    LoddefReading reading;
    if (mErrors.empty())
        reading.definition = std::move(mDefinition);
    reading.errors = std::move(mErrors);
    reading.warnings = std::move(mWarnings);
    return reading;
}

const tinyxml2::XMLElement* LoddefReader::findRoot(const tinyxml2::XMLDocument& document)
{
    const Element* root = document.RootElement();
    if (!root || std::string_view(root->Name()) != "lod") {
        fail(root ? root->GetLineNum() : 1,
             notAllowed("the outermost element", root ? root->Name() : "", "lod, as in <lod version=\"1\"/>"));
        return nullptr;
    }
    for (const tinyxml2::XMLNode* node = document.FirstChild(); node; node = node->NextSibling())
        if (node != root && (node->ToElement() || node->ToText()))
            fail(node->GetLineNum(), notAllowed("what stands beside <lod>", node->Value(), "comments"));
    return root;
}

bool LoddefReader::knowsVersion(const Element& root)
{
    const Attribute* attribute = root.FindAttribute("version");
    if (!attribute)
        return true;
    const std::string allowed = std::to_string(kLoddefVersion) + ", or no version for the original grammar";
    const std::optional<std::uint64_t> version = numberFromText<std::uint64_t>(trimmed(attribute->Value()));
    if (version && *version > kLoddefVersion) {
        fail(attribute->GetLineNum(),
             notAllowed("version", attribute->Value(), allowed) + "; this file is of a newer library",
             ErrorCode::Unsupported);
        return false;
    }
    if (!version || *version == 0)
        fail(attribute->GetLineNum(), notAllowed("version", attribute->Value(), allowed));
    return true;
}

void LoddefReader::readRoot(const Element& root)
{
    checkAttributes(root, {"version"});
    const Children children = childrenOf(root, {"automatic", "manual"});
    if (children["automatic"])
        readAutomatic(*children["automatic"]);
    if (children["manual"])
        readManual(*children["manual"]);
}

void LoddefReader::readAutomatic(const Element& automatic)
{
    checkAttributes(automatic, {"enabled"});
    childrenOf(automatic, {});
    const Attribute* enabled = automatic.FindAttribute("enabled");
    if (!enabled)
        return;
    if (const bool* meaning = meaningOf(kBooleans, trimmed(enabled->Value())))
        mDefinition.automatic = *meaning;
    else
        fail(enabled->GetLineNum(), notAllowed("enabled", enabled->Value(), wordList(kBooleans)));
}

void LoddefReader::readManual(const Element& manual)
{
    checkAttributes(manual);
    readSettings(childrenOf(manual, {"type", "strategy", "metric", "weights", "borders"}, {"subMesh", "level"}));
    for (const Element* child = manual.FirstChildElement("subMesh"); child;
         child = child->NextSiblingElement("subMesh"))
        readSubMesh(*child);
    std::size_t count = 0;
    for (const Element* child = manual.FirstChildElement("level"); child; child = child->NextSiblingElement("level")) {
        if (++count > kMaxLoddefLevels)
            return fail(child->GetLineNum(),
                        "there is one level more than is allowed: " + std::to_string(kMaxLoddefLevels));
        readLevel(*child);
    }
}

void LoddefReader::readSettings(const Children& children)
{
    readWord(children["type"], kTypes, mDefinition.type);
    readWord(children["strategy"], kStrategies, mDefinition.strategy);
    readWord(children["borders"], kBorders, mDefinition.lockBorders);
    if (children["metric"]) {
        Metric metric = Metric::Quadric;
        readWord(children["metric"], kMetrics, metric);
        mDefinition.metric = metric;
    }
    if (children["weights"])
        readWeights(*children["weights"]);
}

void LoddefReader::readWeights(const Element& weights)
{
    mLines.weights = weights.GetLineNum();
    checkAttributes(weights,
                    {kWeights[0].attribute, kWeights[1].attribute, kWeights[2].attribute, kWeights[3].attribute});
    childrenOf(weights, {});
    for (std::size_t i = 0; i < std::size(kWeights); ++i) {
        const Attribute* attribute = weights.FindAttribute(kWeights[i].attribute);
        float weight = 0.0f;
        if (attribute && readNumber(attribute, "a number of 0 or more", weight)) {
            mDefinition.weights.*kWeights[i].member = weight;
            mLines.weightOf[i] = attribute->GetLineNum();
        }
    }
}

void LoddefReader::readSubMesh(const Element& element)
{
    checkAttributes(element, {"index", "importance"});
    childrenOf(element, {});
    SubMeshImportance entry;
    const bool hasIndex =
        readNumber(neededAttribute(element, "index"), "a whole number from 0 to 65535", entry.subMesh);
    if (!readNumber(neededAttribute(element, "importance"), "a number from 0 to 1", entry.importance) || !hasIndex)
        return;
    mDefinition.subMeshes.push_back(entry);
    mLines.subMeshes.push_back(element.GetLineNum());
}

void LoddefReader::readLevel(const Element& element)
{
    LodLevelDefinition level;
    LevelLines lines;
    lines.level = element.GetLineNum();
    checkAttributes(element, {"distance"});
    const Attribute* distance = neededAttribute(element, "distance");
    const Children children = childrenOf(element, {"method", "value", "meshName"});
    readMeshName(children, level, lines);
    readTarget(element, children, level.target, lines);
    if (!readNumber(distance, "a number above 0 and at most 1e18", level.value))
        return;
    lines.value = distance->GetLineNum();
    level.original = printed(element);
    mDefinition.levels.push_back(std::move(level));
    mLines.levels.push_back(lines);
}

void LoddefReader::readMeshName(const Children& children, LodLevelDefinition& level, LevelLines& lines)
{
    const Element* meshName = children["meshName"];
    if (meshName) {
        level.meshName = leafText(*meshName);
        lines.meshName = meshName->GetLineNum();
    }
    const bool isUser = mDefinition.type == LodDefinitionType::User;
    for (const Element* child : {children["method"], children["value"]})
        if (child && (meshName || isUser))
            fail(child->GetLineNum(),
                 tag(*child) + (meshName ? " stands beside <meshName>" : " is in a level of the type user")
                     + "; allowed: <meshName> alone, or <method> and <value> under the type automatic");
}

void LoddefReader::readTarget(const Element& element, const Children& children, LevelTarget& target, LevelLines& lines)
{
    const bool known = readWord(children["method"], kMethods, target.kind);
    const std::string method = wordFor(kMethods, target.kind);
    if (const Element* value = children["value"]) {
        const std::string text = leafText(*value);
        const std::optional<double> amount = numberFromText<double>(text);
        if (!amount)
            fail(value->GetLineNum(), notAllowed("<value>", text, "a number, as in 0.5"));
        // Zero is in the range of every method: one mistake, one error.
        target.amount = known ? amount.value_or(0.0) : 0.0;
        lines.amount = value->GetLineNum();
    } else if (target.kind == LevelTarget::Kind::Triangles || target.kind == LevelTarget::Kind::Deviation) {
        fail(element.GetLineNum(), "the level has no <value>; allowed: one with the method " + method);
        target.amount = 0.0;
    } else if (children["method"] && known && target.kind != LevelTarget::Kind::Proportional) {
        warn(element.GetLineNum(),
             "the level has no <value>: 0.5 it is, which is seldom meant with the method " + method);
    }
}

LoddefReader::Children LoddefReader::childrenOf(const Element& parent, std::initializer_list<std::string_view> single,
                                                std::initializer_list<std::string_view> repeated)
{
    Children children;
    for (const tinyxml2::XMLNode* node = parent.FirstChild(); node; node = node->NextSibling()) {
        const Element* child = node->ToElement();
        if (node->ToText())
            fail(node->GetLineNum(),
                 notAllowed("the text in " + tag(parent), trimmed(node->Value()), "elements and comments"));
        else if (child && contains(single, child->Name())) {
            if (const Element* first = children.add(*child))
                fail(child->GetLineNum(), tag(*child) + " is there already, in line "
                                              + std::to_string(first->GetLineNum()) + "; allowed: once");
        } else if (child && !contains(repeated, child->Name()))
            warn(child->GetLineNum(), tag(*child) + " in " + tag(parent) + " is unknown; it means nothing and is kept");
    }
    return children;
}

void LoddefReader::checkAttributes(const Element& element, std::initializer_list<std::string_view> known)
{
    for (const Attribute* attribute = element.FirstAttribute(); attribute; attribute = attribute->Next())
        if (!contains(known, attribute->Name()) && !belongsToXml(attribute->Name()))
            warn(attribute->GetLineNum(), "the attribute " + quoted(attribute->Name()) + " of " + tag(element)
                                              + " is unknown; it means nothing and is kept");
}

const tinyxml2::XMLAttribute* LoddefReader::neededAttribute(const Element& element, const char* name)
{
    const Attribute* attribute = element.FindAttribute(name);
    if (!attribute)
        fail(element.GetLineNum(), tag(element) + " has no attribute '" + name + "'; allowed: one");
    return attribute;
}

std::string LoddefReader::leafText(const Element& element)
{
    checkAttributes(element);
    for (const Element* child = element.FirstChildElement(); child; child = child->NextSiblingElement())
        warn(child->GetLineNum(), tag(*child) + " in " + tag(element) + " is unknown; it means nothing and is kept");
    return textIn(element);
}

template <class T, std::size_t N>
bool LoddefReader::readWord(const Element* element, const LoddefWord<T> (&words)[N], T& target)
{
    if (!element)
        return true;
    const std::string text = leafText(*element);
    const T* meaning = meaningOf(words, text);
    if (meaning)
        target = *meaning;
    else
        fail(element->GetLineNum(), notAllowed(tag(*element), text, wordList(words)));
    return meaning != nullptr;
}

template <class T>
bool LoddefReader::readNumber(const Attribute* attribute, const std::string& allowed, T& target)
{
    if (!attribute)
        return false;
    const std::optional<T> number = numberFromText<T>(trimmed(attribute->Value()));
    if (!number)
        fail(attribute->GetLineNum(), notAllowed(attribute->Name(), attribute->Value(), allowed));
    target = number.value_or(target);
    return number.has_value();
}

void LoddefReader::fail(int line, std::string message, ErrorCode code)
{
    // One more than is reported, so that the report can say that there are more.
    if (mErrors.size() > kMaxLoddefErrors)
        return;
    Error error{code, std::move(message)};
    error.line = line;
    mErrors.push_back(std::move(error));
}

void LoddefReader::warn(int line, std::string message)
{
    if (mWarnings.size() > kMaxLoddefErrors)
        return;
    Error warning{ErrorCode::BadFile, std::move(message)};
    warning.line = line;
    mWarnings.push_back(std::move(warning));
}

} // namespace lodsmith
