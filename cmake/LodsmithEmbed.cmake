# Puts text files into a program, as they are.
#   lodsmith_embed(TARGET SOURCE NAMESPACE VARIABLE FILE [VARIABLE FILE]...)
# makes SOURCE at build time and adds it to TARGET: each VARIABLE is an `extern const std::string_view` of NAMESPACE
# that holds its FILE. Also the script that does it: cmake -DOUTPUT=... -DNAMESPACE=... -DPAIRS=... -P LodsmithEmbed.cmake

if(CMAKE_SCRIPT_MODE_FILE)
    set(text "#include <string_view>\n\nnamespace ${NAMESPACE} {\n\n")
    string(REPLACE "|" ";" PAIRS "${PAIRS}")
    while(PAIRS)
        list(POP_FRONT PAIRS variable file)
        file(READ "${file}" content)
        string(APPEND text "extern const std::string_view ${variable};\n"
            "const std::string_view ${variable} = R\"embedded(${content})embedded\";\n")
    endwhile()
    string(APPEND text "\n} // namespace ${NAMESPACE}\n")
    file(WRITE "${OUTPUT}" "${text}")
    return()
endif()

set(LODSMITH_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_FILE})

function(lodsmith_embed target source namespace)
    set(pairs "")
    set(files "")
    while(ARGN)
        list(POP_FRONT ARGN variable file)
        list(APPEND pairs ${variable} ${CMAKE_CURRENT_SOURCE_DIR}/${file})
        list(APPEND files ${CMAKE_CURRENT_SOURCE_DIR}/${file})
    endwhile()
    list(JOIN pairs "|" pairs)
    set(output ${CMAKE_CURRENT_BINARY_DIR}/${source})
    add_custom_command(OUTPUT ${output}
        COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} -DNAMESPACE=${namespace} "-DPAIRS=${pairs}"
            -P ${LODSMITH_EMBED_SCRIPT}
        DEPENDS ${files} ${LODSMITH_EMBED_SCRIPT}
        VERBATIM)
    target_sources(${target} PRIVATE ${output})
endfunction()
