#pragma once

/// Marks what the shared library exports. `LODSMITH_STATIC` is defined for static builds and their users,
/// `LODSMITH_BUILDING` while the library itself is compiled; both are set by the CMake targets.
#if defined(LODSMITH_STATIC)
#    define LODSMITH_API
#elif defined(_MSC_VER)
#    if defined(LODSMITH_BUILDING)
#        define LODSMITH_API __declspec(dllexport)
#    else
#        define LODSMITH_API __declspec(dllimport)
#    endif
#else
#    define LODSMITH_API __attribute__((visibility("default")))
#endif
