# What users get: headers, libraries, the command, a CMake package with one component a room, and pkg-config files.

include(CMakePackageConfigHelpers)

set(LODSMITH_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/Lodsmith)
set(LODSMITH_PKGCONFIG_DIR ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
set(LODSMITH_COMPONENTS "")

# From the .pc files to the prefix, so that an installed tree can be moved.
file(RELATIVE_PATH LODSMITH_PREFIX_FROM_PKGCONFIG
    ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" LODSMITH_PREFIX_FROM_PKGCONFIG "${LODSMITH_PREFIX_FROM_PKGCONFIG}")

# Installs one library, its headers, its targets file and its .pc file.
#   target     the library
#   component  what find_package(Lodsmith COMPONENTS ...) calls it, and its folder of headers
#   PC         name of the .pc file; REQUIRES and LIBS_PRIVATE (for static linking) are what it needs, as pkg-config words it
function(lodsmith_install_library target component)
    cmake_parse_arguments(INSTALLED "" "PC;REQUIRES;LIBS_PRIVATE" "" ${ARGN})
    install(TARGETS ${target} EXPORT Lodsmith-${component}
        RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR}
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
    install(EXPORT Lodsmith-${component} NAMESPACE Lodsmith:: DESTINATION ${LODSMITH_CMAKE_DIR})
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/lodsmith/${component}
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/lodsmith
        FILES_MATCHING PATTERN "*.h")
    set(LODSMITH_PC_CFLAGS "")
    if(NOT BUILD_SHARED_LIBS)
        set(LODSMITH_PC_CFLAGS " -DLODSMITH_STATIC")
    endif()
    configure_file(${PROJECT_SOURCE_DIR}/cmake/lodsmith.pc.in ${PROJECT_BINARY_DIR}/${INSTALLED_PC}.pc @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/${INSTALLED_PC}.pc DESTINATION ${LODSMITH_PKGCONFIG_DIR})
    set(LODSMITH_COMPONENTS ${LODSMITH_COMPONENTS} ${component} PARENT_SCOPE)
endfunction()

lodsmith_install_library(lodsmith_core core
    PC lodsmith-core LIBS_PRIVATE -pthread)
lodsmith_install_library(lodsmith_analysis analysis
    PC lodsmith-analysis REQUIRES lodsmith-core LIBS_PRIVATE -lembree3)
lodsmith_install_library(lodsmith_generators generators
    PC lodsmith-generators REQUIRES "lodsmith-core lodsmith-analysis")
lodsmith_install_library(lodsmith_loddef loddef
    PC lodsmith-loddef REQUIRES lodsmith-core LIBS_PRIVATE -ltinyxml2)
install(FILES ${PROJECT_SOURCE_DIR}/docs/loddef.xsd DESTINATION ${CMAKE_INSTALL_DATADIR}/lodsmith)
lodsmith_install_library(lodsmith_cache cache
    PC lodsmith-cache REQUIRES lodsmith-core)
if(LODSMITH_OGRE)
    lodsmith_install_library(lodsmith ogre
        PC lodsmith REQUIRES "lodsmith-core lodsmith-analysis lodsmith-generators lodsmith-loddef lodsmith-cache OGRE sigc++-2.0"
        LIBS_PRIVATE -lmeshoptimizer)
    lodsmith_install_library(lodsmith_render render PC lodsmith-render REQUIRES lodsmith)
    # With the prefix of OGRE's package, where OGRE's own plugins are.
    get_filename_component(LODSMITH_PLUGIN_FOLDER "${OGRE_PLUGIN_DIR}" NAME)
    install(TARGETS Plugin_Lodsmith
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/${LODSMITH_PLUGIN_FOLDER}
        RUNTIME DESTINATION ${CMAKE_INSTALL_LIBDIR}/${LODSMITH_PLUGIN_FOLDER})
    install(FILES ${PROJECT_SOURCE_DIR}/plugin/lodsmith.cfg DESTINATION ${CMAKE_INSTALL_DATADIR}/lodsmith)
endif()
if(LODSMITH_LUA)
    lodsmith_install_library(lodsmith_lua lua
        PC lodsmith-lua REQUIRES "lodsmith lua5.1" LIBS_PRIVATE ${LODSMITH_TOLUA_LIBRARY})
endif()
if(LODSMITH_PANEL)
    lodsmith_install_library(lodsmith_panel panel
        PC lodsmith-panel REQUIRES "lodsmith-lua lodsmith-render CEGUI-0 CEGUI-0-LUA CEGUI-0-OGRE" LIBS_PRIVATE -ldl)
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/gui-layouts DESTINATION ${CMAKE_INSTALL_DATADIR}/lodsmith)
endif()
if(LODSMITH_EDITOR)
    install(TARGETS lodsmith_editor RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
if(LODSMITH_CLI)
    install(TARGETS lodsmith_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/LodsmithConfig.cmake.in
    ${PROJECT_BINARY_DIR}/LodsmithConfig.cmake
    INSTALL_DESTINATION ${LODSMITH_CMAKE_DIR}
    NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/LodsmithConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/LodsmithConfig.cmake ${PROJECT_BINARY_DIR}/LodsmithConfigVersion.cmake
    DESTINATION ${LODSMITH_CMAKE_DIR})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md
    DESTINATION ${CMAKE_INSTALL_DOCDIR})
