#!/bin/sh
# Which part of the repository must not know which other part:
#
#     arrows.sh REPOSITORY
#
# A file knows another one if it includes it, or if it calls one of its functions, included or not; functions count that a header
# declares, but for those of energywave.h. Each line of the table has the files that must not know, those that they must not know,
# and why. Both are extended regular expressions of paths in the repository; a header from elsewhere stands as <jansson.h>. KIND
# stands for each kind of source, OTHER for each other one. The files of tests/support/kinds say which kinds there are.
#
# Exit status: 0; 1 for an arrow that must not run.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
cd "$1"
table='
^glsl/                             .                                      GLSL includes nothing: the library orders its files
^src/(base|model|plan)/            ^src/host/|^<(GL|GLES2|GLES3|EGL)/     what packs and plans needs no GL
^src/base/                         ^src/(model|plan)/                     the lower layer does not know the upper one
^src/model/                        ^src/plan/                             the scene does not know how it is drawn
^src/model/KIND[.]                 ^src/model/OTHER[.]                    a kind of source stands alone
^src/host/program                  ^src/host/state_guard                  what makes programs leaves the saving of state to others
^src/                              ^(demo|tests|web)/                     the library does not know its users
^demo/                             ^src/.*/|^src/effect                   the demo is a host like any other
^demo/                             ^(tests|web)/                          the demo does not need the tests
^demo/support/                     ^demo/ew_                              what programs share knows none of them
^demo/ew_render/                   ^demo/ew_demo/                         programs do not know each other
^demo/ew_demo/                     ^demo/ew_render/                       the same
^demo/examples/                    ^demo/(support|ew_)                    an example is a whole program
^demo/(.*/)?scene[.][ch]$          scene_file|^<jansson                   a scene is no file
^web/                              ^src/.*/|^src/effect                   the page is a host like any other
^tests/bench/                      ^src/plan/glsl_text                    the library assembles what the bench measures
'
kinds=$(cd tests/support/kinds && ls ./*.c | sed 's|[./]*||; s|[.]c$||' | tr '\n' ' ')
rooms=
for room in glsl src demo web tests; do
    if [ -d $room ]; then rooms="$rooms $room"; fi
done
# shellcheck disable=SC2086 # the rooms are several words
find $rooms -type f \( -name '*.[ch]' -o -name '*.cpp' -o -name '*.glsl' -o -name '*.frag' -o -name '*.vert' \) -print | sort |
    awk -v table="$table" -v kinds="$kinds" -f "$here/arrows.awk"
