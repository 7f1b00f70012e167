# What the installed libraries stand on. The packages are found here, not in the rooms, and made global, so that every
# directory sees their targets: the rooms, the tests, and a project that takes Lodsmith in with add_subdirectory().
# LodsmithConfig.cmake.in finds the same packages for users of an installed Lodsmith.

find_package(Threads REQUIRED GLOBAL)
find_package(embree 3 CONFIG QUIET REQUIRED GLOBAL)
find_package(tinyxml2 CONFIG QUIET REQUIRED GLOBAL)
# Headers alone: compiled into lodsmith_cache, so that its users need not find it.
find_path(LODSMITH_XXHASH_INCLUDE_DIR xxhash.h REQUIRED)
mark_as_advanced(LODSMITH_XXHASH_INCLUDE_DIR)
if(LODSMITH_OGRE)
    find_package(meshoptimizer CONFIG QUIET REQUIRED GLOBAL)
    find_package(OGRE CONFIG QUIET REQUIRED GLOBAL)
    # sigc++ 2 comes without a CMake package.
    find_package(PkgConfig QUIET REQUIRED)
    pkg_check_modules(SIGCXX QUIET REQUIRED IMPORTED_TARGET GLOBAL sigc++-2.0)
endif()
if(LODSMITH_LUA)
    pkg_check_modules(LUA51 QUIET REQUIRED IMPORTED_TARGET GLOBAL lua5.1)
    # tolua++ comes without a package file of any kind.
    find_program(LODSMITH_TOLUA NAMES tolua++5.1 REQUIRED)
    find_library(LODSMITH_TOLUA_LIBRARY NAMES libtolua++5.1.a REQUIRED)
    mark_as_advanced(LODSMITH_TOLUA LODSMITH_TOLUA_LIBRARY)
endif()
if(LODSMITH_PANEL)
    pkg_check_modules(CEGUI QUIET REQUIRED IMPORTED_TARGET GLOBAL CEGUI-0 CEGUI-0-LUA CEGUI-0-OGRE)
    pkg_get_variable(LODSMITH_CEGUI_DATA_DIR CEGUI-0 datafiles)
    if(LODSMITH_TESTS)
        # A renderer that draws nothing.
        pkg_check_modules(CEGUI_NULL QUIET REQUIRED IMPORTED_TARGET GLOBAL CEGUI-0-NULL)
    endif()
endif()
if(LODSMITH_CLI)
    # What contact sheets and the editor write in.
    set(LODSMITH_FONT_DIR /usr/share/fonts/truetype/dejavu CACHE PATH "Directory of DejaVuSans.ttf and DejaVuSans-Bold.ttf")
endif()
if(LODSMITH_EDITOR)
    find_package(SDL2 CONFIG QUIET REQUIRED GLOBAL)
endif()
