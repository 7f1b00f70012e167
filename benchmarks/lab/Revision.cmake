# Writes Revision.h: which state of the sources is built. Run at every build; writes only what has changed.
#   cmake -DSOURCE_DIR=... -DOUTPUT=... -P Revision.cmake
# The revision is the commit; where the sources differ from it, "+" and a hash of how. Empty outside a git checkout.

set(measured include src benchmarks cmake CMakeLists.txt)
set(revision "")
execute_process(COMMAND git -C ${SOURCE_DIR} rev-parse --short=12 HEAD
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE failed ERROR_QUIET)
if(NOT failed)
    execute_process(COMMAND git -C ${SOURCE_DIR} diff HEAD -- ${measured} OUTPUT_VARIABLE changes ERROR_QUIET)
    execute_process(COMMAND git -C ${SOURCE_DIR} ls-files --others --exclude-standard -- ${measured}
        OUTPUT_VARIABLE others ERROR_QUIET)
    string(REGEX REPLACE "\n" ";" others "${others}")
    foreach(file IN LISTS others)
        if(file)
            file(SHA256 ${SOURCE_DIR}/${file} hash)
            string(APPEND changes "${file} ${hash}\n")
        endif()
    endforeach()
    set(revision ${commit})
    if(NOT changes STREQUAL "")
        string(SHA256 hash "${changes}")
        string(SUBSTRING ${hash} 0 8 hash)
        string(APPEND revision "+${hash}")
    endif()
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "#define LODSMITH_REVISION \"@revision@\"\n" @ONLY)
