#!/bin/sh
# No function is longer than a screen:
#
#     function_length.sh FOLDER...
#
# Prints the place, the name and the length of each C or GLSL function of more than 60 lines, from the first line of its
# signature to its closing brace. In this repository's style, both braces of a function are alone in column 0.
#
# Exit status: 0; 1 if there is such a function.
set -eu
find "$@" -type f \( -name '*.[ch]' -o -name '*.cpp' -o -name '*.glsl' -o -name '*.frag' -o -name '*.vert' \) -exec awk -v most=60 '
    FNR == 1 { signature = 0; body = 0 }
    body && /^}/ {
        length_found = FNR - signature + 1
        if (length_found > most) {
            printf "%s:%d: %s: %d lines, at most %d\n", FILENAME, signature, name, length_found, most
            found = 1
        }
        signature = body = 0
        next
    }
    body { next }
    /^[{]$/ && signature { body = 1; next }
    /^[A-Za-z_]/ && !signature { signature = FNR; name = "" }
    signature && name == "" && match($0, /[A-Za-z_0-9]+[(]/) { name = substr($0, RSTART, RLENGTH - 1) }
    /^$/ || /^#/ || /^\/[\/*]/ || /;$/ || /^}/ { signature = 0 }
    END { exit found }' {} +
