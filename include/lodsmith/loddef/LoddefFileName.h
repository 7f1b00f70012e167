#pragma once

#include <lodsmith/core/Export.h>

#include <string>
#include <string_view>

namespace lodsmith {

/// The name of the definition that belongs to a mesh: the mesh's name with its last extension replaced by ".loddef". The
/// only such mapping there is.
///
///     dir/a.b.mesh -> dir/a.b.loddef     a.b/c  -> a.b/c.loddef     .mesh -> .mesh.loddef
///
/// The directory stays as it is; both '/' and '\\' end it, and neither is turned into the other. A name without an
/// extension is appended to. Leading dots belong to the base name, so that a hidden file's name is no extension.
/// Two names share a definition only when they differ in nothing but the last extension ("a.mesh", "a.MESH", "a.xml", "a").
/// Empty for a name without a base name ("", "dir/"): there is no definition then.
LODSMITH_API std::string loddefFileName(std::string_view meshName);

} // namespace lodsmith
