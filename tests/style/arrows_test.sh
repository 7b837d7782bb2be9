#!/bin/sh
# arrows.sh can fail: it finds each arrow that must not run when it is drawn, and nothing in a tree that has none.
#
#     arrows_test.sh ARROWS.SH
set -eu
arrows=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

put()
{
    mkdir -p "$(dirname "$1")"
    printf '%b' "$2" >"$1"
}

# A small house in which all is well: comments, strings, own functions of the same name and public functions are no arrows.
put glsl/sum.glsl 'float sum(float x)\n{\n    return x;\n}\n'
put src/energywave.h 'EW_API int ew_draw(int x);\n'
put src/effect.c '#include "energywave.h"\n#include "host/gl.h"\n\nint ew_draw(int x)\n{\n    return ew_gl_load(x);\n}\n'
put src/base/error.h 'int ew_fail(int code);\n'
put src/model/kinds.h 'int ew_pack_point(int x);\nint ew_pack_torus(int x);\n'
put src/model/point.c '#include "model/kinds.h"\n\nint ew_pack_point(int x)\n{\n    return x;\n}\n'
put src/model/torus.c '#include "model/kinds.h"\n\nint ew_pack_torus(int x)\n{\n    return x;\n}\n'
put src/plan/glsl_text.h 'extern const char ew_glsl_sum_glsl[];\nint ew_glsl_size(int x);\n'
put src/plan/plan.c '/* Not ew_gl_load(x),\n * nor ew_gl_load(y). */\nstatic const char text[] = "ew_gl_load(x)"; // ew_gl_load(x)\n'
put src/host/gl.h '#include <GL/glcorearb.h>\nint ew_gl_load(int x);\n'
put src/host/gl.c '#include "host/gl.h"\n\nint ew_gl_load(int x)\n{\n    return x;\n}\n'
put src/host/state_guard.h 'int ew_guard_save(int x);\n'
put src/host/program.c '#include "plan/glsl_text.h"\n'
put demo/message.h 'int message_write(int x);\n'
put demo/support/scene.h 'int scene_count(int x);\n'
put demo/support/scene_file.h '#include "scene.h"\n#include <jansson.h>\nint scene_load(int x);\n'
put demo/main.c '#include "energywave.h"\n\nstatic int random_bits(int x)\n{\n    return ew_draw(random_bits(x));\n}\n'
put web/main.c '#include "energywave.h"\n'
put tests/support/random_numbers.h 'int random_bits(int x);\n'
put tests/support/kinds/point.c '\n'
put tests/support/kinds/torus.c '\n'
put tests/bench/peers.c '#include "random_numbers.h"\n'
sh "$arrows" . || { echo "arrows.sh finds an arrow where there is none"; exit 1; }

# must_find FILE LINE: the arrow that LINE is in FILE is found.
must_find()
{
    cp "$1" kept
    printf '%b\n' "$2" >>"$1"
    if sh "$arrows" . >found; then
        echo "arrows.sh overlooks in $1: $2"
        exit 1
    fi
    grep -q "^$1 " found || { echo "arrows.sh does not name $1:"; cat found; exit 1; }
    mv kept "$1"
}

must_find glsl/sum.glsl '#include "other.glsl"'
must_find src/base/error.h '#include "model/kinds.h"'
must_find src/base/error.h '    return ew_pack_torus(1);'
must_find src/model/point.c '#include "host/gl.h"'
must_find src/model/point.c '#include <GL/glcorearb.h>'
must_find src/model/point.c '    return ew_gl_load(1);'
must_find src/model/point.c '#include "torus.c"'
must_find src/model/torus.c '    return ew_pack_point(1);'
must_find src/plan/plan.c '    return (ew_gl_load (1));'
must_find src/host/program.c '#include "state_guard.h"'
must_find src/host/program.c '    return ew_guard_save(1);'
must_find src/effect.c '#include "message.h"'
must_find src/effect.c '    return message_write(1);'
must_find src/effect.c '    return random_bits(1);'
must_find demo/support/scene.h '#include "scene_file.h"'
must_find demo/support/scene.h '#include <jansson.h>'
must_find demo/support/scene.h '    return scene_load(1);'
must_find demo/main.c '#include "../src/host/gl.h"'
must_find demo/main.c '    return ew_gl_load(1);'
must_find demo/main.c '#include "random_numbers.h"'
must_find web/main.c '#include "base/error.h"'
must_find web/main.c '    return ew_fail(1);'
must_find tests/bench/peers.c '#include "plan/glsl_text.h"'
must_find tests/bench/peers.c '    return ew_glsl_size(1);'
