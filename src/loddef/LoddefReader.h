#pragma once

#include "DefinitionCheck.h"
#include "LoddefWords.h"

#include <lodsmith/loddef/LoddefXml.h>

#include <tinyxml2.h>

#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace lodsmith {

/// Turns a parsed document into a definition, and says what is wrong with it. Errors and warnings have lines and no file,
/// and come in no order; LodDefinition::original stays empty.
class LoddefReader {
public:
    LoddefReading read(const tinyxml2::XMLDocument& document);

private:
    using Element = tinyxml2::XMLElement;
    using Attribute = tinyxml2::XMLAttribute;

    /// The known children of an element by name; null for what is absent.
    class Children {
    public:
        /// Returns the child that has the name already, or null after having added this one.
        const Element* add(const Element& child);
        const Element* operator[](std::string_view name) const;

    private:
        std::map<std::string_view, const Element*> mByName;
    };

    const Element* findRoot(const tinyxml2::XMLDocument& document);
    bool knowsVersion(const Element& root);
    void readRoot(const Element& root);
    void readAutomatic(const Element& automatic);
    void readManual(const Element& manual);
    void readSettings(const Children& children);
    void readWeights(const Element& weights);
    void readSubMesh(const Element& element);
    void readLevel(const Element& element);
    void readMeshName(const Children& children, LodLevelDefinition& level, LevelLines& lines);
    void readTarget(const Element& element, const Children& children, LevelTarget& target, LevelLines& lines);

    Children childrenOf(const Element& parent, std::initializer_list<std::string_view> single,
                        std::initializer_list<std::string_view> repeated = {});
    void checkAttributes(const Element& element, std::initializer_list<std::string_view> known = {});
    const Attribute* neededAttribute(const Element& element, const char* name);
    std::string leafText(const Element& element);

    /// False when there is a word that the table does not have.
    template <class T, std::size_t N>
    bool readWord(const Element* element, const LoddefWord<T> (&words)[N], T& target);
    template <class T>
    bool readNumber(const Attribute* attribute, const std::string& allowed, T& target);

    void fail(int line, std::string message, ErrorCode code = ErrorCode::BadFile);
    void warn(int line, std::string message);

    LodDefinition mDefinition;
    DefinitionLines mLines;
    std::vector<Error> mErrors;
    std::vector<Error> mWarnings;
};

} // namespace lodsmith
