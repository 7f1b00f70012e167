# Lua packages: code that tolua++ generates from .pkg files, as part of a library.

set(LODSMITH_TOLUA_HOOKS ${PROJECT_SOURCE_DIR}/lua-bindings/hooks.lua)

# Generates a package at build time and compiles it into `target`.
#   package   NAME.pkg; gives int tolua_NAME_open(lua_State*), which has to be declared by whoever calls it
#   PARTS     files that it takes in with $pfile, by their names in its directory
# The runtime of tolua++ goes into the library and stays inside: whoever links the library may have another copy, as CEGUI's
# script module does.
function(lodsmith_add_package target package)
    cmake_parse_arguments(PACKAGE "" "" "PARTS" ${ARGN})
    get_filename_component(source ${package} ABSOLUTE)
    get_filename_component(directory ${source} DIRECTORY)
    get_filename_component(name ${package} NAME_WE)
    set(generated ${CMAKE_CURRENT_BINARY_DIR}/${name}Package.cpp)
    list(TRANSFORM PACKAGE_PARTS PREPEND ${directory}/)
    add_custom_command(OUTPUT ${generated}
        COMMAND ${LODSMITH_TOLUA} -n ${name} -L ${LODSMITH_TOLUA_HOOKS} -o ${generated} ${name}.pkg
        WORKING_DIRECTORY ${directory}
        DEPENDS ${source} ${PACKAGE_PARTS} ${LODSMITH_TOLUA_HOOKS}
        COMMENT "Lua package ${name}"
        VERBATIM)
    target_sources(${target} PRIVATE ${generated})
    if(NOT MSVC)
        # Nobody has written it.
        set_source_files_properties(${generated} PROPERTIES COMPILE_OPTIONS -w)
    endif()
    target_link_libraries(${target} PRIVATE ${LODSMITH_TOLUA_LIBRARY})
    if(UNIX AND NOT APPLE)
        get_filename_component(archive ${LODSMITH_TOLUA_LIBRARY} NAME)
        target_link_options(${target} PRIVATE LINKER:--exclude-libs,${archive})
    endif()
endfunction()
