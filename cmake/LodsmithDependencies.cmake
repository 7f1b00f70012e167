# What the installed libraries stand on. The packages are found here, not in the rooms, and made global, so that every
# directory sees their targets: the rooms, the tests, and a project that takes Lodsmith in with add_subdirectory().
# LodsmithConfig.cmake.in finds the same packages for users of an installed Lodsmith.

find_package(embree 3 CONFIG QUIET REQUIRED GLOBAL)
find_package(tinyxml2 CONFIG QUIET REQUIRED GLOBAL)
# Headers alone: compiled into lodsmith_cache, so that its users need not find it.
find_path(LODSMITH_XXHASH_INCLUDE_DIR xxhash.h REQUIRED)
mark_as_advanced(LODSMITH_XXHASH_INCLUDE_DIR)
if(LODSMITH_OGRE)
    find_package(meshoptimizer CONFIG QUIET REQUIRED GLOBAL)
    find_package(OGRE CONFIG QUIET REQUIRED GLOBAL)
    find_package(Threads REQUIRED GLOBAL)
    # sigc++ 2 comes without a CMake package.
    find_package(PkgConfig QUIET REQUIRED)
    pkg_check_modules(SIGCXX QUIET REQUIRED IMPORTED_TARGET GLOBAL sigc++-2.0)
endif()
