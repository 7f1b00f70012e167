#include "Settings.h"

#include "../files/AtomicFile.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>

namespace lodsmith::editor {

namespace {

using nlohmann::json;

constexpr std::uintmax_t kLargestFile = 1 << 20;

json toJson(const Settings& settings)
{
    json root{{"recentFiles", settings.recentFiles}};
    if (const auto& window = settings.window)
        root["window"] = {{"x", window->x},
                          {"y", window->y},
                          {"width", window->width},
                          {"height", window->height},
                          {"maximised", window->maximised}};
    return root;
}

Settings fromJson(const json& root)
{
    Settings settings;
    if (const auto window = root.find("window"); window != root.end())
        settings.window = WindowPlace{window->at("x"), window->at("y"), window->at("width"), window->at("height"),
                                      window->at("maximised")};
    const std::vector<std::string> files = root.at("recentFiles");
    settings.recentFiles.assign(files.begin(),
                                files.begin() + std::ptrdiff_t(std::min(files.size(), Settings::kMaxRecentFiles)));
    return settings;
}

std::filesystem::path absoluteDirectory(const char* variable)
{
    const char* const value = std::getenv(variable);
    const std::filesystem::path path = value ? value : "";
    return path.is_absolute() ? path : std::filesystem::path();
}

} // namespace

void Settings::addRecentFile(const std::string& file)
{
    recentFiles.erase(std::remove(recentFiles.begin(), recentFiles.end(), file), recentFiles.end());
    recentFiles.insert(recentFiles.begin(), file);
    recentFiles.resize(std::min(recentFiles.size(), kMaxRecentFiles));
}

std::filesystem::path settingsFile()
{
    std::filesystem::path directory = absoluteDirectory("XDG_CONFIG_HOME");
    if (directory.empty()) {
        directory = absoluteDirectory("HOME");
        if (directory.empty())
            return {};
        directory /= ".config";
    }
    return directory / "lodsmith" / "editor.json";
}

Result<Settings> readSettings(const std::filesystem::path& file)
{
    auto text = readFile(file, kLargestFile);
    if (!text && text.error().code == ErrorCode::NotFound)
        return Settings{};
    if (!text)
        return text.error();
    try {
        return fromJson(json::parse(text.value()));
    } catch (const json::exception& exception) {
        return Error{ErrorCode::BadFile, std::string("not the editor's settings: ") + exception.what(), file.string()};
    }
}

Result<Done> writeSettings(const std::filesystem::path& file, const Settings& settings)
{
    // File names need not be UTF-8; what is not is replaced rather than refused.
    const std::string text = toJson(settings).dump(4, ' ', false, json::error_handler_t::replace) + "\n";
    AtomicFile target(file, Existing::Replace, Durability::None);
    if (auto prepared = target.prepare(text); !prepared)
        return prepared;
    return target.commit();
}

} // namespace lodsmith::editor
