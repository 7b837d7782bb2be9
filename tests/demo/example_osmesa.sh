#!/bin/sh
# The example without a window writes a picture of light, and nothing where it has no light.
# Usage: example_osmesa.sh EXAMPLE
example=$1
. "$(dirname "$0")/../checks.sh"
enters example_osmesa
needs identify convert

"$example" picture.ppm || complain "it exits with $?"
[ "$(identify -format '%wx%h' picture.ppm)" = 640x360 ] || complain 'the picture has another size'
[ "$(identify -format '%k' picture.ppm)" -gt 500 ] || complain 'there is no light'
[ "$(convert picture.ppm -crop 1x1+0+359 -depth 8 txt:- | tail -n 1 | awk '{ print $3 }')" = '#000000' ] ||
    complain 'there is light in a corner'
"$example" > stdout 2> stderr && complain 'no name is no error'
concludes
