#!/bin/sh
# The README's C code is the consumer's, word for word, and so is known to compile and to draw.
# Usage: readme.sh README GLOW_C
sed -n '/^```c$/,/^```$/p' "$1" | sed '/^```/d' > readme.c
diff readme.c "$2"
