// libFuzzer target for .loddef files: any bytes are read as a definition. What comes out has to be errors with lines within
// the text, or a definition that is in order, is written, and is the same when read again and written once more.

#include <lodsmith/loddef/LoddefXml.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

using namespace lodsmith;

[[noreturn]] void fail(const std::string& sentence)
{
    std::fprintf(stderr, "%s\n", sentence.c_str());
    std::abort();
}

void checkPlaces(const std::vector<Error>& errors, std::string_view text)
{
    const auto lines = 1 + std::count(text.begin(), text.end(), '\n');
    for (const Error& error : errors)
        if (error.message.empty() || error.line < 1 || error.line > lines)
            fail("misplaced: " + describe(error));
}

std::string textOf(const LodDefinition& definition)
{
    const Result<std::string> text = loddefText(definition);
    if (!text)
        fail("not written: " + describe(text.error()));
    return text.value();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const LoddefReading reading = parseLoddef(text, "");
    checkPlaces(reading.errors, text);
    checkPlaces(reading.warnings, text);
    if (reading.ok() != reading.errors.empty())
        fail("a definition with errors, or neither");
    if (!reading.ok())
        return 0;
    if (!findErrors(*reading.definition).empty())
        fail("not in order: " + describe(findErrors(*reading.definition).front()));
    const std::string written = textOf(*reading.definition);
    const LoddefReading again = parseLoddef(written, "");
    if (!again.ok() || *again.definition != *reading.definition)
        fail("read differently:\n" + written);
    if (textOf(*again.definition) != written)
        fail("written differently:\n" + written + textOf(*again.definition));
    return 0;
}
