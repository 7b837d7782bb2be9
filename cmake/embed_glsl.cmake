# Writes a C file that holds GLSL files as strings, and the header that declares them:
# cmake -DOUTPUT=x.c -DHEADER=x.h -DPREFIX=ew_glsl_ -DFILES="a.glsl;b.glsl" -P embed_glsl.cmake
# The string of a.glsl is called ew_glsl_a_glsl. Compilers need not take string literals as long as a shader, so the bytes become
# an array.
get_filename_component(header_name "${HEADER}" NAME)
set(text "/* Made by cmake/embed_glsl.cmake. */\n#include \"${header_name}\"\n")
set(declarations "/* Made by cmake/embed_glsl.cmake: zero-terminated texts of GLSL files. */\n")
foreach(file IN LISTS FILES)
    get_filename_component(name "${file}" NAME)
    string(REPLACE "." "_" symbol "${name}")
    file(READ "${file}" bytes HEX)
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
    string(REGEX REPLACE "(................................................................................)" "\\1\n" bytes "${bytes}")
    string(APPEND text "\nconst char ${PREFIX}${symbol}[] = {\n${bytes}0};\n")
    string(APPEND declarations "extern const char ${PREFIX}${symbol}[];\n")
endforeach()
file(WRITE "${OUTPUT}" "${text}")
file(WRITE "${HEADER}" "${declarations}")
