#include <lodsmith/loddef/LoddefFileName.h>

namespace lodsmith {

std::string loddefFileName(std::string_view meshName)
{
    const std::size_t separator = meshName.find_last_of("/\\");
    const std::size_t base = separator == std::string_view::npos ? 0 : separator + 1;
    if (base == meshName.size())
        return {};
    const std::size_t firstLetter = meshName.find_first_not_of('.', base);
    const std::size_t dot = meshName.rfind('.');
    const bool hasExtension =
        dot != std::string_view::npos && firstLetter != std::string_view::npos && dot > firstLetter;
    return std::string(meshName.substr(0, hasExtension ? dot : meshName.size())) + ".loddef";
}

} // namespace lodsmith
