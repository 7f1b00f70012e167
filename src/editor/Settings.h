#pragma once

#include <lodsmith/core/Result.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace lodsmith::editor {

/// Of the window when it was last closed, pixels of the screen.
struct WindowPlace {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    bool maximised = false;
};

/// What the editor remembers from one start to the next.
struct Settings {
    static constexpr std::size_t kMaxRecentFiles = 12;

    std::optional<WindowPlace> window;
    std::vector<std::string> recentFiles; ///< absolute, newest first, at most kMaxRecentFiles

    /// Puts a file at the head of recentFiles.
    void addRecentFile(const std::string& file);
};

/// "lodsmith/editor.json" in the user's directory for settings: $XDG_CONFIG_HOME, else ~/.config. Empty when neither is known.
std::filesystem::path settingsFile();

/// Reads settings. A file that does not exist holds the defaults. Errors: Io, BadFile.
Result<Settings> readSettings(const std::filesystem::path& file);

/// Writes settings, whole or not at all; directories on the way are made. Errors: Io.
Result<Done> writeSettings(const std::filesystem::path& file, const Settings& settings);

} // namespace lodsmith::editor
