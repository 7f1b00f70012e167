#include <lodsmith/loddef/LoddefXml.h>

#include "../files/AtomicFile.h"
#include "LoddefReader.h"
#include "LoddefWriter.h"
#include "XmlScan.h"

#include <tinyxml2.h>

#include <algorithm>
#include <utility>

namespace lodsmith {

namespace {

const char* sentenceFor(tinyxml2::XMLError error)
{
    switch (error) {
    case tinyxml2::XML_ERROR_PARSING_ELEMENT: return "an element is malformed; allowed: <name attribute=\"value\">";
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
        return "an attribute is malformed or given twice; allowed: name=\"value\", once";
    case tinyxml2::XML_ERROR_PARSING_TEXT:
        return "a text has no end: its element is not closed, or it stands outside of all; allowed: text in elements";
    case tinyxml2::XML_ERROR_PARSING_CDATA: return "a CDATA section does not end; allowed: <![CDATA[ ... ]]>";
    case tinyxml2::XML_ERROR_PARSING_COMMENT: return "a comment does not end; allowed: <!-- ... -->";
    case tinyxml2::XML_ERROR_PARSING_DECLARATION:
        return "a declaration <? ... ?> is allowed at the very beginning alone";
    case tinyxml2::XML_ERROR_EMPTY_DOCUMENT: return "there is nothing in it; allowed: at least <lod/>";
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
        return "the element that begins here is not closed, or another is before it; allowed: <name> ... </name>";
    case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED: return "elements nest deeper than is allowed: 100";
    default: return "this is no XML";
    }
}

/// Errors have a line and no file.
std::optional<Error> parseDocument(std::string_view text, tinyxml2::XMLDocument& document)
{
    if (text.size() > kMaxLoddefBytes)
        return Error{ErrorCode::BadFile, "is larger than " + std::to_string(kMaxLoddefBytes) + " bytes"};
    if (auto error = findForbiddenXml(text))
        return error;
    // TinyXML-2 takes a length of zero for an error of the caller.
    document.Parse(text.empty() ? " " : text.data(), std::max<std::size_t>(text.size(), 1));
    if (!document.Error())
        return std::nullopt;
    Error error{ErrorCode::BadFile, sentenceFor(document.ErrorID())};
    error.line = std::max(document.ErrorLineNum(), 1);
    return error;
}

/// In the order of the file, with a last one that says so when there are too many.
void tidy(std::vector<Error>& errors, const char* what, const std::string& fileName)
{
    std::stable_sort(errors.begin(), errors.end(), [](const Error& a, const Error& b) { return a.line < b.line; });
    if (errors.size() > kMaxLoddefErrors) {
        errors.resize(kMaxLoddefErrors);
        errors.back().message = std::string("there are more ") + what + ", which are not listed";
    }
    for (Error& error : errors)
        error.file = fileName;
}

LoddefReading failedReading(Error error)
{
    LoddefReading reading;
    reading.errors.push_back(std::move(error));
    return reading;
}

} // namespace

LoddefReading parseLoddef(std::string_view text, const std::string& fileName)
{
    tinyxml2::XMLDocument document;
    auto error = parseDocument(text, document);
    LoddefReading reading = error ? failedReading(std::move(*error)) : LoddefReader().read(document);
    tidy(reading.errors, "errors", fileName);
    tidy(reading.warnings, "warnings", fileName);
    if (reading.definition)
        reading.definition->original = std::string(text);
    return reading;
}

LoddefReading readLoddefFile(const std::filesystem::path& path)
{
    const Result<std::string> text = readFile(path, kMaxLoddefBytes);
    return text ? parseLoddef(text.value(), path.string()) : failedReading(text.error());
}

Result<std::string> loddefText(const LodDefinition& definition)
{
    const std::vector<Error> errors = findErrors(definition);
    if (!errors.empty())
        return errors.front();
    tinyxml2::XMLDocument document;
    if (!definition.original.empty()
        && (parseDocument(definition.original, document) || !LoddefReader().read(document).ok()))
        return Error{ErrorCode::BadFile, "the original of the definition is no definition"};
    if (auto written = writeDefinition(definition, document); !written)
        return written.error();
    tinyxml2::XMLPrinter printer;
    document.Print(&printer);
    std::string text(printer.CStr(), static_cast<std::size_t>(printer.CStrSize()) - 1);
    // What an `original` of a level brings along is the caller's; nothing is written that would not be read again.
    const LoddefReading reading = parseLoddef(text, "");
    if (!reading.ok() || *reading.definition != definition)
        return Error{ErrorCode::BadFile,
                     "the definition cannot be written: "
                         + (reading.ok() ? std::string("the original of a level does not belong to it")
                                         : describe(reading.errors.front()))};
    return text;
}

Result<Done> writeLoddefFile(const std::filesystem::path& path, const LodDefinition& definition)
{
    const Result<std::string> text = loddefText(definition);
    if (!text) {
        Error error = text.error();
        error.file = path.string();
        return error;
    }
    AtomicFile file(path, Existing::Replace);
    auto prepared = file.prepare(text.value());
    return prepared ? file.commit() : prepared;
}

} // namespace lodsmith
