#include <lodsmith/panel/AssetsManagerPanel.h>

#include <cstdlib>
#include <dlfcn.h>

namespace lodsmith {

namespace {

/// Of the library that this code is in; empty when the system does not tell.
std::filesystem::path libraryDirectory()
{
    Dl_info info = {};
    if (dladdr(reinterpret_cast<const void*>(&guiDirectory), &info) == 0 || !info.dli_fname)
        return {};
    std::error_code ignored;
    return std::filesystem::weakly_canonical(info.dli_fname, ignored).parent_path();
}

} // namespace

std::filesystem::path guiDirectory()
{
    if (const char* named = std::getenv("LODSMITH_GUI_DIR"))
        return named;
    std::error_code ignored;
    const std::filesystem::path installed = libraryDirectory() / LODSMITH_DATADIR_FROM_LIBDIR "/lodsmith/gui-layouts";
    return std::filesystem::is_directory(installed, ignored) ? installed.lexically_normal() : LODSMITH_GUI_SOURCE_DIR;
}

} // namespace lodsmith
