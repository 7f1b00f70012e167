# One place for what every target of the project has in common.

include(GNUInstallDirs)

set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
if(LODSMITH_IS_TOP_LEVEL)
    option(BUILD_SHARED_LIBS "Build shared libraries" ON)
    set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
    set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib)
    set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib)
    if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
        set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
    endif()
endif()

# Where installed programs and libraries find the project's libraries, wherever the prefix is moved to.
file(RELATIVE_PATH LODSMITH_LIBDIR_FROM_BINDIR ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})

# Flags that belong to the project's own code, not to its users.
function(lodsmith_target_defaults target)
    target_compile_features(${target} PUBLIC cxx_std_17)
    set_target_properties(${target} PROPERTIES
        CXX_EXTENSIONS OFF
        INSTALL_RPATH "$ORIGIN;$ORIGIN/${LODSMITH_LIBDIR_FROM_BINDIR}")
    if(MSVC)
        target_compile_options(${target} PRIVATE /W4 /fp:precise)
    else()
        # No contraction to fused multiply-add: results must not depend on compiler or level of optimisation.
        target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -ffp-contract=off)
    endif()
    if(LODSMITH_SANITIZER)
        target_compile_options(${target} PRIVATE
            -fsanitize=${LODSMITH_SANITIZER} -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
        target_link_options(${target} PUBLIC -fsanitize=${LODSMITH_SANITIZER})
    endif()
endfunction()

# A library of the project: one room of src/, and the rooms and packages it may include. lodsmith_core is known to users
# as Lodsmith::core, and so on; lodsmith itself is Lodsmith::lodsmith.
function(lodsmith_add_library name)
    cmake_parse_arguments(ROOM "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
    string(REGEX REPLACE "^lodsmith_" "" exportName ${name})
    add_library(${name} ${ROOM_SOURCES})
    add_library(Lodsmith::${exportName} ALIAS ${name})
    target_include_directories(${name} PUBLIC
        $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
        $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    target_compile_definitions(${name} PRIVATE LODSMITH_BUILDING)
    if(NOT BUILD_SHARED_LIBS)
        target_compile_definitions(${name} PUBLIC LODSMITH_STATIC)
    endif()
    target_link_libraries(${name} PUBLIC ${ROOM_PUBLIC} PRIVATE ${ROOM_PRIVATE})
    set_target_properties(${name} PROPERTIES
        EXPORT_NAME ${exportName}
        VERSION ${PROJECT_VERSION}
        SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
    lodsmith_target_defaults(${name})
endfunction()
