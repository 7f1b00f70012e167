#include <lodsmith/loddef/LoddefFileName.h>
#include <lodsmith/loddef/LoddefXml.h>

#include <cstdio>

/// A program without OGRE that makes a definition, writes it and reads it again.
int main()
{
    lodsmith::LodDefinition definition;
    definition.automatic = false;
    definition.levels.push_back({20.0f, {lodsmith::LevelTarget::Kind::Triangles, 400}, "", ""});
    const auto text = lodsmith::loddefText(definition);
    if (!text) {
        std::fprintf(stderr, "%s\n", lodsmith::describe(text.error()).c_str());
        return 1;
    }
    const std::string name = lodsmith::loddefFileName("models/tree.mesh");
    const lodsmith::LoddefReading reading = lodsmith::parseLoddef(text.value(), name);
    std::printf("%s: %zu level\n", name.c_str(), reading.ok() ? reading.definition->levels.size() : 0);
    return reading.ok() && *reading.definition == definition ? 0 : 1;
}
