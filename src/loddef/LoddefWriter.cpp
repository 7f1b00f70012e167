#include "LoddefWriter.h"

#include "LoddefElements.h"
#include "LoddefWords.h"
#include "NumberText.h"

#include <lodsmith/loddef/LoddefXml.h>

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lodsmith {

namespace {

using Document = tinyxml2::XMLDocument;
using Element = tinyxml2::XMLElement;
using Node = tinyxml2::XMLNode;

/// The last child with one of these names, null when there is none.
Node* lastOf(Element& parent, std::initializer_list<const char*> names)
{
    for (Node* node = parent.LastChild(); node; node = node->PreviousSibling())
        for (const char* name : names)
            if (node->ToElement() && std::string_view(node->Value()) == name)
                return node;
    return nullptr;
}

void insertAfter(Element& parent, Node* before, Node* added)
{
    if (before)
        parent.InsertAfterChild(before, added);
    else
        parent.InsertFirstChild(added);
}

/// The child of that name; when there is none it is made, behind those of the siblings `before` that are there.
Element& childOf(Element& parent, const char* name, std::initializer_list<const char*> before)
{
    if (Element* child = parent.FirstChildElement(name))
        return *child;
    Element* child = parent.GetDocument()->NewElement(name);
    insertAfter(parent, lastOf(parent, before), child);
    return *child;
}

void removeChild(Element& parent, const char* name)
{
    if (Element* child = parent.FirstChildElement(name))
        parent.DeleteChild(child);
}

/// Comments and unknown elements within stay.
void setText(Element& element, const std::string& text)
{
    if (textIn(element) == text)
        return;
    for (Node* node = element.FirstChild(); node;) {
        Node* next = node->NextSibling();
        if (node->ToText())
            element.DeleteChild(node);
        node = next;
    }
    element.InsertFirstChild(element.GetDocument()->NewText(text.c_str()));
}

template <class T, std::size_t N>
void setWord(Element& element, const LoddefWord<T> (&words)[N], T meaning)
{
    const T* present = meaningOf(words, textIn(element));
    if (!present || *present != meaning)
        setText(element, wordFor(words, meaning));
}

template <class T>
bool saysNumber(const char* text, T number)
{
    return text && numberFromText<T>(trimmed(text)) == number;
}

template <class T>
void setNumber(Element& element, const char* attribute, T number)
{
    if (!saysNumber(element.Attribute(attribute), number))
        element.SetAttribute(attribute, textFromNumber(number).c_str());
}

void writeAutomatic(Element& root, bool automatic)
{
    Element& element = childOf(root, "automatic", {});
    const char* text = element.Attribute("enabled");
    const bool* present = text ? meaningOf(kBooleans, trimmed(text)) : nullptr;
    if (!present || *present != automatic)
        element.SetAttribute("enabled", wordFor(kBooleans, automatic));
}

void writeWeights(Element& manual, const GivenAttributeWeights& weights)
{
    if (!weights.any() && !manual.FirstChildElement("weights"))
        return;
    Element& element = childOf(manual, "weights", {"type", "strategy", "metric"});
    for (const LoddefWeight& weight : kWeights) {
        if (const std::optional<float>& given = weights.*weight.member)
            setNumber(element, weight.attribute, *given);
        else
            element.DeleteAttribute(weight.attribute);
    }
    if (!element.FirstAttribute() && element.NoChildren())
        manual.DeleteChild(&element);
}

void writeSettings(Element& manual, const LodDefinition& definition)
{
    setWord(childOf(manual, "type", {}), kTypes, definition.type);
    setWord(childOf(manual, "strategy", {"type"}), kStrategies, definition.strategy);
    if (definition.metric)
        setWord(childOf(manual, "metric", {"type", "strategy"}), kMetrics, *definition.metric);
    else
        removeChild(manual, "metric");
    writeWeights(manual, definition.weights);
    if (definition.lockBorders || manual.FirstChildElement("borders"))
        setWord(childOf(manual, "borders", {"type", "strategy", "metric", "weights"}), kBorders,
                definition.lockBorders);
}

/// The elements of one name below a parent, brought into step with a list of entries. Each entry keeps the element that it
/// was read from where that stands, as long as entries and elements are in the same order.
class ElementList {
public:
    template <class KeyOf>
    ElementList(Element& parent, const char* name, Node* place, const KeyOf& keyOf) : mParent(parent), mBefore(place)
    {
        for (Element* element = parent.FirstChildElement(name); element; element = element->NextSiblingElement(name))
            mSlots.push_back({element, keyOf(*element), false});
        if (!mSlots.empty())
            mBefore = mSlots.front().element->PreviousSibling();
    }

    /// The element of the next entry, null when there is none with its key.
    Element* take(const std::string& key)
    {
        for (std::size_t i = mNext; i < mSlots.size(); ++i) {
            if (mSlots[i].key != key)
                continue;
            mSlots[i].taken = true;
            mNext = i + 1;
            mBefore = mSlots[i].element;
            return mSlots[i].element;
        }
        return nullptr;
    }

    /// A new element for the next entry.
    void add(Node* element)
    {
        insertAfter(mParent, mBefore, element);
        mBefore = element;
    }

    void removeRest()
    {
        for (const Slot& slot : mSlots)
            if (!slot.taken)
                mParent.DeleteChild(slot.element);
    }

private:
    struct Slot {
        Element* element;
        std::string key;
        bool taken;
    };

    Element& mParent;
    Node* mBefore; ///< what the next new element comes after, null for the front
    std::vector<Slot> mSlots;
    std::size_t mNext = 0;
};

std::string subMeshKey(const Element& element)
{
    const std::optional<std::uint16_t> number = numberFromText<std::uint16_t>(trimmed(element.Attribute("index")));
    return number ? std::to_string(*number) : std::string();
}

void writeSubMeshes(Element& manual, const std::vector<SubMeshImportance>& subMeshes)
{
    Node* place = lastOf(manual, {"type", "strategy", "metric", "weights", "borders"});
    ElementList list(manual, "subMesh", place, subMeshKey);
    for (const SubMeshImportance& entry : subMeshes) {
        const std::string key = std::to_string(entry.subMesh);
        Element* element = list.take(key);
        if (!element) {
            element = manual.GetDocument()->NewElement("subMesh");
            element->SetAttribute("index", key.c_str());
            list.add(element);
        }
        setNumber(*element, "importance", entry.importance);
    }
    list.removeRest();
}

Result<Element*> makeLevel(Document& document, const LodLevelDefinition& level)
{
    if (level.original.empty())
        return document.NewElement("level");
    Document original;
    original.Parse(level.original.data(), level.original.size());
    const Element* root = original.RootElement();
    if (original.Error() || !root || std::string_view(root->Name()) != "level")
        return Error{ErrorCode::BadFile, "the original of a level is no <level>"};
    return root->DeepClone(&document)->ToElement();
}

void writeLevel(Element& element, const LodLevelDefinition& level)
{
    setNumber(element, "distance", level.value);
    if (level.isManual()) {
        removeChild(element, "method");
        removeChild(element, "value");
        setText(childOf(element, "meshName", {}), level.meshName);
        return;
    }
    removeChild(element, "meshName");
    setWord(childOf(element, "method", {}), kMethods, level.target.kind);
    Element& value = childOf(element, "value", {"method"});
    if (!saysNumber(textIn(value).c_str(), level.target.amount))
        setText(value, textFromNumber(level.target.amount));
}

Result<Done> writeLevels(Element& manual, const std::vector<LodLevelDefinition>& levels)
{
    Node* place = lastOf(manual, {"type", "strategy", "metric", "weights", "borders", "subMesh"});
    ElementList list(manual, "level", place, printed);
    for (const LodLevelDefinition& level : levels) {
        Element* element = list.take(level.original);
        if (!element) {
            const Result<Element*> made = makeLevel(*manual.GetDocument(), level);
            if (!made)
                return made.error();
            element = made.value();
            list.add(element);
        }
        writeLevel(*element, level);
    }
    list.removeRest();
    return Done{};
}

} // namespace

Result<Done> writeDefinition(const LodDefinition& definition, tinyxml2::XMLDocument& document)
{
    if (!document.RootElement())
        document.InsertEndChild(document.NewElement("lod"));
    Element& root = *document.RootElement();
    if (!root.Attribute("version"))
        root.SetAttribute("version", kLoddefVersion);
    writeAutomatic(root, definition.automatic);
    Element& manual = childOf(root, "manual", {"automatic"});
    writeSettings(manual, definition);
    writeSubMeshes(manual, definition.subMeshes);
    return writeLevels(manual, definition.levels);
}

} // namespace lodsmith
