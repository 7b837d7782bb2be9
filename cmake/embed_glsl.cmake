# Writes a C file that holds GLSL files as strings: cmake -DOUTPUT=x.c -DFILES="a.glsl;b.glsl" -P embed_glsl.cmake
# The string of a.glsl is called ew_glsl_a_glsl and is declared in plan/glsl_text.h; -DPREFIX= and -DHEADER= replace these two.
# Each file becomes an array of bytes, since compilers need not accept a string literal as long as a shader.
if(NOT DEFINED PREFIX)
    set(PREFIX ew_glsl_)
    set(HEADER plan/glsl_text.h)
endif()
set(text "/* Made by cmake/embed_glsl.cmake. */\n#include \"${HEADER}\"\n")
foreach(file IN LISTS FILES)
    get_filename_component(name "${file}" NAME)
    string(REPLACE "." "_" symbol "${name}")
    file(READ "${file}" bytes HEX)
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
    string(REGEX REPLACE "(................................................................................)" "\\1\n" bytes "${bytes}")
    string(APPEND text "\nconst char ${PREFIX}${symbol}[] = {\n${bytes}0};\n")
endforeach()
file(WRITE "${OUTPUT}" "${text}")
