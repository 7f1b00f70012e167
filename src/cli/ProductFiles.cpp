#include "ProductFiles.h"

#include "../files/AtomicFile.h"
#include "OutputPlan.h"

#include <algorithm>
#include <memory>
#include <string_view>
#include <vector>

namespace fs = std::filesystem;

namespace lodsmith::cli {

namespace {

bool isThere(const fs::path& path)
{
    std::error_code ignored;
    return fs::exists(fs::symlink_status(path, ignored));
}

bool hasContent(const fs::path& path, std::string_view content)
{
    const Result<std::string> present = readFile(path);
    return present && present.value() == content;
}

/// A file that goes along, on its way to its place.
struct Copy {
    fs::path source;
    fs::path target;
    std::string content;
    std::unique_ptr<AtomicFile> file; // null when it is there already
};

Result<Done> putInPlace(AtomicFile& file, const fs::path& target, std::string_view content)
{
    const auto committed = file.commit();
    // Another process may have brought the same in the meantime.
    return committed || hasContent(target, content) ? Result<Done>(Done{}) : committed;
}

Result<Done> writeRecord(const fs::path& output, const std::string& text, Existing existing)
{
    AtomicFile file(recordFile(output), existing, Durability::None);
    if (auto prepared = file.prepare(text); !prepared)
        return prepared;
    return file.commit();
}

Result<std::unique_ptr<AtomicFile>> prepared(const fs::path& target, std::string_view content)
{
    const Existing existing = isThere(target) ? Existing::Replace : Existing::Keep;
    auto file = std::make_unique<AtomicFile>(target, existing, Durability::None);
    const auto done = file->prepare(content);
    if (done)
        return file;
    // Another process may have brought it since it was looked for.
    if (existing == Existing::Keep && isThere(target) && isRecorded(target))
        return prepared(target, content);
    return done.error();
}

Result<Copy> prepareCopy(const Companion& companion, const fs::path& target, bool force)
{
    Result<std::string> content = companion.content ? *companion.content : readFile(companion.source);
    if (!content)
        return content.error();
    Copy copy{companion.source, target, std::move(content).value(), nullptr};
    if (hasContent(target, copy.content))
        return copy;
    if (auto allowed = checkProduct(target, force); !allowed)
        return allowed.error();
    auto file = prepared(target, copy.content);
    if (!file)
        return file.error();
    copy.file = std::move(file).value();
    return copy;
}

bool reads(const BuildRecord& record, const fs::path& source)
{
    return std::any_of(record.read.begin(), record.read.end(),
                       [wanted = identity(source)](const auto& file) { return identity(file.first) == wanted; });
}

/// Another mesh that brings a different file of this name, now and not just formerly: its source, or nothing.
std::optional<fs::path> rivalOf(const Copy& copy, const fs::path& output, const Json& settings)
{
    const std::optional<CompanionRecord> other = readCompanionRecord(copy.target);
    if (!other || identity(other->mesh) == identity(output) || identity(other->source) == identity(copy.source))
        return std::nullopt;
    const std::optional<std::string> hash = fileHash(other->source);
    if (!hash || *hash == contentHash(copy.content))
        return std::nullopt;
    // One without a record is being made at the moment.
    const std::optional<BuildRecord> record = readRecord(other->mesh);
    const bool brings = !record || (reads(*record, other->source) && isCurrent(*record, settings));
    return brings ? std::optional(other->source) : std::nullopt;
}

/// Meshes of different directories that go to one may bring different files of one name: two skeletons, for instance.
Result<Done> claim(const Copy& copy, const fs::path& output, const Json& settings)
{
    const std::string text = companionRecordText({copy.source, output}, copy.target);
    if (writeRecord(copy.target, text, Existing::Keep))
        return Done{};
    if (const std::optional<fs::path> rival = rivalOf(copy, output, settings))
        return Error{ErrorCode::InvalidSetting,
                     "both '" + copy.source.string() + "' and '" + rival->lexically_normal().string()
                         + "' would be this file; give the two meshes different output directories",
                     copy.target.string()};
    return writeRecord(copy.target, text, Existing::Replace);
}

Result<Done> placeCopy(Copy& copy, const fs::path& output, const Json& settings, bool force)
{
    // Somebody else's file that happens to be the same stays somebody else's.
    if (!copy.file && !force)
        return Done{};
    if (auto claimed = claim(copy, output, settings); !claimed)
        return claimed;
    return copy.file ? putInPlace(*copy.file, copy.target, copy.content) : Result<Done>(Done{});
}

/// The record, then the mesh: whoever has no record left finds a mesh that is not this program's.
Result<Done> placeMesh(AtomicFile& file, const fs::path& output, const GeneratedMesh& mesh, const BuildRecord& record)
{
    const std::string text = recordText(record, output);
    // Of several processes one alone is the first.
    const bool isFirst = writeRecord(output, text, Existing::Keep).ok();
    if (!isFirst)
        if (auto written = writeRecord(output, text, Existing::Replace); !written)
            return written;
    auto placed = putInPlace(file, output, mesh.bytes);
    std::error_code ignored;
    if (!placed && isFirst && hasContent(recordFile(output), text)) // nor has another process been here since
        fs::remove(recordFile(output), ignored);
    return placed;
}

} // namespace

Result<Done> checkProduct(const fs::path& output, bool force)
{
    return checkOutput(output, force || isRecorded(output) ? Existing::Replace : Existing::Keep);
}

Result<Done> writeProduct(const fs::path& output, const GeneratedMesh& mesh, BuildRecord record, bool force)
{
    // All are prepared before the first appears: whatever can run out has run out by then.
    std::vector<Copy> copies;
    for (const Companion& companion : mesh.companions) {
        Result<Copy> copy = prepareCopy(companion, output.parent_path() / companion.name, force);
        if (!copy)
            return copy.error();
        record.written[copy.value().target] = contentHash(copy.value().content);
        copies.push_back(std::move(copy).value());
    }
    if (auto allowed = checkProduct(output, force); !allowed)
        return allowed;
    auto file = prepared(output, mesh.bytes);
    if (!file)
        return file.error();
    record.written[output] = contentHash(mesh.bytes);

    for (Copy& copy : copies)
        if (auto placed = placeCopy(copy, output, record.settings, force); !placed)
            return placed;
    return placeMesh(*file.value(), output, mesh, record);
}

} // namespace lodsmith::cli
