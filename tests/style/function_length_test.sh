#!/bin/sh
# function_length.sh can fail: it finds a function of 61 lines, in C and in GLSL, and leaves one of 60 alone.
#
#     function_length_test.sh FUNCTION_LENGTH.SH
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# write_function FILE SIGNATURE LINES: the signature and the braces are three of the lines.
write_function()
{
    printf '// A comment\nconst int table[] = {\n    1,\n};\n\n%s\n{\n' "$2" >"$1"
    i=3
    while [ $i -lt "$3" ]; do
        echo '    value = value + 1;' >>"$1"
        i=$((i + 1))
    done
    printf '}\n\nint after(void)\n{\n    return 0;\n}\n' >>"$1"
}

fail()
{
    echo "function_length.sh $1"
    exit 1
}

for extension in c h glsl frag; do
    write_function "$folder/some.$extension" 'static int long_one(int value)' 60
    sh "$1" "$folder" || fail "takes 60 lines of .$extension for more"
    write_function "$folder/some.$extension" 'static int long_one(int value)' 61
    if found=$(sh "$1" "$folder"); then fail "overlooks 61 lines of .$extension"; fi
    [ "$found" = "$folder/some.$extension:6: long_one: 61 lines, at most 60" ] || fail "says: $found"
    rm "$folder/some.$extension"
done
printf 'static int long_one(int first,\n                    int value)\n{\n' >"$folder/some.c"
i=0
while [ $i -lt 58 ]; do
    echo '    value++;' >>"$folder/some.c"
    i=$((i + 1))
done
echo '}' >>"$folder/some.c"
if sh "$1" "$folder" >"$folder/found"; then fail "overlooks a signature of two lines"; fi
if sh "$1" "$folder/nothing" >"$folder/found" 2>&1; then fail "is content without files"; fi
