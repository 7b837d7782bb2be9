#!/bin/sh
# The C code of the README is the consumer's, word for word: what the README shows has been compiled and drawn.
# Usage: readme.sh README GLOW_C
sed -n '/^```c$/,/^```$/p' "$1" | sed '/^```/d' > readme.c
diff readme.c "$2"
