#!/bin/sh
# The README's code is the consumer's, word for word, in C and in C++, and so is known to compile and to draw.
# Usage: readme.sh README CONSUMER_SOURCES
set -e
# code FENCE...: the blocks of C or C++ with these numbers.
code() {
    awk -v numbers=" $* " '
        /^```c(pp)?$/ { inside = index(numbers, " " ++count " "); if (inside && printed++) print ""; next }
        /^```/ { inside = 0 }
        inside' "$readme"
}
readme=$1 consumer=$2
code 1 3 > readme.c
diff readme.c "$consumer"/glow.c
code 2 3 > readme.cpp
diff readme.cpp "$consumer"/glow.cpp
