# Writes a C file that holds GLSL files as strings: cmake -DOUTPUT=x.c -DFILES="a.glsl;b.glsl" -P embed_glsl.cmake
# The bytes of each become an array, since compilers need not take string literals as long as a shader.
set(text "/* Made by cmake/embed_glsl.cmake from the files of glsl/. */\n#include \"glsl_text.h\"\n")
foreach(file IN LISTS FILES)
    get_filename_component(name "${file}" NAME)
    string(REPLACE "." "_" symbol "${name}")
    file(READ "${file}" bytes HEX)
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
    string(REGEX REPLACE "(................................................................................)" "\\1\n" bytes "${bytes}")
    string(APPEND text "\nconst char ew_glsl_${symbol}[] = {\n${bytes}0};\n")
endforeach()
file(WRITE "${OUTPUT}" "${text}")
