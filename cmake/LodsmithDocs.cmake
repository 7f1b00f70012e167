# Target `docs`: the reference of the public headers, as HTML. A warning is an error.

find_package(Doxygen QUIET)
if(DOXYGEN_FOUND)
    configure_file(${PROJECT_SOURCE_DIR}/docs/Doxyfile.in ${PROJECT_BINARY_DIR}/Doxyfile @ONLY)
    add_custom_target(docs
        COMMAND Doxygen::doxygen ${PROJECT_BINARY_DIR}/Doxyfile
        COMMENT "Reference in ${PROJECT_BINARY_DIR}/docs/html/index.html"
        VERBATIM)
endif()
