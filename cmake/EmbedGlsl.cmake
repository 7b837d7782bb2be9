# ew_embed_glsl(NAME PREFIX FILE...): adds rules that make NAME.c and NAME.h in the current binary folder, with the texts of the
# files; see embed_glsl.cmake.
function(ew_embed_glsl name prefix)
    set(output ${CMAKE_CURRENT_BINARY_DIR}/${name}.c)
    set(header ${CMAKE_CURRENT_BINARY_DIR}/${name}.h)
    add_custom_command(OUTPUT ${output} ${header}
        COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} -DHEADER=${header} -DPREFIX=${prefix} "-DFILES=${ARGN}"
            -P ${PROJECT_SOURCE_DIR}/cmake/embed_glsl.cmake
        DEPENDS ${ARGN} ${PROJECT_SOURCE_DIR}/cmake/embed_glsl.cmake
        COMMENT "Embedding ${name}" VERBATIM)
endfunction()
