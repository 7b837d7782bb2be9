#!/bin/sh
# On bad input, ew-render exits with status 2 and prints one line to standard error, which names the file (or option), the place
# and a remedy. It leaves no output, neither whole nor in part.
# Usage: bad_input.sh EW_RENDER EW_PROBE_IMAGE SCENES
ew_render=$1
. "$(dirname "$0")/../checks.sh"
cases=0
enters bad_input
mkdir out

# world_scene MEMBERS: writes scene.json, a valid scene of the world integral to which MEMBERS are added.
world_scene() {
    printf '{ "camera": { "eye": [0, 0, 8], "target": [0, 0, 0] }, %s }\n' "$1" > scene.json
}

# scene MEMBERS: writes scene.json, a valid scene of the papers' integral to which MEMBERS are added.
scene() {
    case $1 in
    *'"interval"'*) world_scene "$1" ;;
    *) world_scene "\"interval\": { \"start\": 3, \"end\": 15 }, $1" ;;
    esac
}

# refuses PLACE ARGUMENT...: expects ew-render to refuse these arguments and to name PLACE, a basic regular expression.
refuses() {
    place=$1
    shift
    cases=$((cases + 1))
    "$ew_render" "$@" > stdout 2> stderr < /dev/null
    status=$?
    if [ $status -ne 2 ]; then complain "$place: exit status $status instead of 2: $(cat stderr)"; return; fi
    if [ "$(wc -l < stderr)" -ne 1 ]; then complain "$place: not one line: $(cat stderr)"; return; fi
    if ! grep -q "^ew-render: $place: ." stderr; then complain "$place is not named: $(cat stderr)"; return; fi
    if [ -n "$(ls -A out)" ]; then complain "$place: left $(ls -A out)"; rm -rf out/*; fi
}

# refuses_scene PLACE MEMBERS: expects a scene with these members to be refused.
refuses_scene() {
    scene "$2"
    refuses "scene.json: $1" scene.json -o out/picture.png
}

# refuses_world PLACE MEMBERS: the same for a scene of the world integral.
refuses_world() {
    world_scene "$2"
    refuses "scene.json: $1" scene.json -o out/picture.png
}

# refuses_text PLACE TEXT: expects a scene file of this text to be refused.
refuses_text() {
    printf '%s' "$2" > scene.json
    refuses "scene.json: $1" scene.json -o out/picture.png
}

# ---- Files that are not scenes
refuses 'missing\.json' missing.json -o out/picture.png
mkdir folder.json
refuses 'folder\.json' folder.json -o out/picture.png
refuses 'two?lines' 'two
lines' -o out/picture.png
refuses_text 'line 1, column [0-9]*' ''
refuses_text 'line 2, column [0-9]*' '{ "camera":
{ "eye" [0, 0, 8] } }'
refuses_text 'line 1, column [0-9]*' '{} {}'
refuses_text 'line 1, column [0-9]*' '{ "epsilon": NaN }'
refuses_text 'line 1, column [0-9]*' '{ "epsilon": Infinity }'
refuses_text 'line 1, column [0-9]*' '{ "epsilon": 1e999 }'
refuses_text 'line 1, column [0-9]*' '{ "epsilon": 1, "epsilon": 2 }'
# shellcheck disable=SC2059 # a byte order mark, and zeros
printf '\377\376{\0}\0' > scene.json
refuses 'scene\.json' scene.json -o out/picture.png
grep -q UTF-16 stderr || complain "UTF-16 is not named: $(cat stderr)"
printf '[1, 2]' > scene.json
refuses 'scene\.json' scene.json -o out/picture.png

# ---- Keys and types
refuses_text 'camera' '{}'
refuses_text 'camera\.eye' '{ "camera": { "target": [0, 0, 0] } }'
refuses_text 'camera\.eyes' '{ "camera": { "eyes": [0, 0, 8], "target": [0, 0, 0] } }'
refuses_text 'camera\.height' '{ "camera": { "eye": [0, 0, 8], "target": [0, 0, 0], "height": 2 } }'
refuses_text 'camera\.fov_y_degrees' \
    '{ "camera": { "eye": [0, 0, 8], "target": [0, 0, 0], "projection": "orthographic", "fov_y_degrees": 45 } }'
refuses_scene 'colour' '"colour": [1, 1, 1]'
refuses_scene 'points\[1\]\.radius' '"points": [{ "position": [0, 0, 0] }, { "position": [0, 0, 0], "radius": 1 }]'
refuses_scene 'opaque\[0\]\.normal' '"opaque": [{ "shape": "sphere", "center": [0, 0, 0], "radius": 1, "normal": [0, 1, 0] }]'
refuses_scene 'opaque\[0\]\.shape' '"opaque": [{ "shape": "cone" }]'
refuses_scene 'opaque\[0\]\.shape' '"opaque": [{ "min": [0, 0, 0] }]'
refuses_scene 'opaque\[0\]\.max' '"opaque": [{ "shape": "box", "min": [0, 0, 0], "max": [1, 1, 0] }]'
refuses_scene 'epsilon' '"epsilon": "small"'
refuses_scene 'epsilon' '"epsilon": null'
refuses_scene 'color' '"color": [1, 1]'
refuses_scene 'color\[2\]' '"color": [1, 1, true]'
refuses_scene 'color\[0\]' '"color": [-0.1, 1, 1]'
refuses_scene 'composite' '"composite": "multiply"'
refuses_scene 'version' '"version": 2'
refuses_scene 'comment' '"comment": 1'
refuses_scene 'points' '"points": { "position": [0, 0, 0] }'
refuses_scene 'points\[0\]' '"points": [[0, 0, 0]]'
refuses_scene 'points\[0\]\.position' '"points": [{}]'
refuses_scene 'points\[0\]\.position' '"points": [{ "position": [0, 0, 0, 1] }]'
refuses_scene 'points\[0\]\.position\[1\]' '"points": [{ "position": [0, 1e30, 0] }]'
refuses_scene 'points\[0\]\.coefficient' '"points": [{ "position": [0, 0, 0], "coefficient": -1 }]'
refuses_scene 'curves\[0\]' '"curves": [{ "coefficient": 1 }]'
refuses_scene 'curves\[0\]\.control_points' '"curves": [{ "control_points": [[0, 0, 0], [1, 0, 0]] }]'
refuses_scene 'curves\[0\]\.control_points\[2\]' '"curves": [{ "control_points": [[0, 0, 0], [1, 0, 0], [1]] }]'
refuses_scene 'curves\[0\]' \
    '"curves": [{ "control_points": [[0, 0, 0], [1, 0, 0], [2, 0, 0]], "polynomial": [[0, 0, 0], [1, 0, 0], [2, 0, 0]] }]'

# ---- Ranges
arc='"control_points": [[0, 0, 0], [1, 1, 0], [2, 0, 0]]'
refuses_scene 'epsilon' '"epsilon": 0'
refuses_scene 'epsilon' '"epsilon": -0.001'
refuses_scene 'lines\[0\]\.direction' '"lines": [{ "position": [0, 0, 0], "direction": [0, 0, 0] }]'
refuses_scene 'tori\[0\]\.axis' '"tori": [{ "center": [0, 0, 0], "axis": [0, 0, 0], "radius": 1 }]'
refuses_scene 'tori\[0\]\.radius' '"tori": [{ "center": [0, 0, 0], "axis": [0, 1, 0], "radius": -1 }]'
refuses_scene 'opaque\[0\]\.normal' '"opaque": [{ "shape": "plane", "point": [0, 0, 0], "normal": [0, 0, 0] }]'
refuses_scene 'opaque\[0\]\.radius' '"opaque": [{ "shape": "sphere", "center": [0, 0, 0], "radius": -1 }]'
refuses_scene 'curves\[0\]\.domain' "\"curves\": [{ $arc, \"domain\": [1, 1] }]"
refuses_scene 'curves\[0\]\.domain' "\"curves\": [{ $arc, \"domain\": [1, -1] }]"
refuses_scene 'curves\[0\]\.domain' "\"curves\": [{ $arc, \"domain\": [0, 1, 2] }]"
refuses_scene 'curves\[0\]\.weights' "\"curves\": [{ $arc, \"weights\": [] }]"
refuses_scene 'curves\[1\]\.weights\[3\]' "\"curves\": [{ $arc }, { $arc, \"weights\": [1, 0, 1, -1] }]"
refuses_scene 'interval\.end' '"interval": { "start": 5, "end": 5 }'
refuses_scene 'interval\.end' '"interval": { "start": 3, "end": 101 }'
refuses_scene 'interval\.start' '"interval": { "start": 0, "end": 5 }'
refuses_scene 'decay\.beta' '"decay": { "beta": 0 }'
refuses_scene 'decay\.beta' '"decay": { "beta": -1 }'
refuses_scene 'decay\.alpha' '"decay": { "alpha": -1 }'
refuses_text 'camera\.target' '{ "camera": { "eye": [0, 0, 8], "target": [0, 0, 8] } }'
refuses_text 'camera\.up' '{ "camera": { "eye": [0, 0, 8], "target": [0, 0, 0], "up": [0, 0, 2] } }'
refuses_text 'camera\.up' '{ "camera": { "eye": [0, 0, 8], "target": [0, 0, 0], "up": [0, 0, 0] } }'
refuses_text 'camera\.near' '{ "camera": { "eye": [0, 0, 8], "target": [0, 0, 0], "near": 0 } }'
refuses_text 'camera\.far' '{ "camera": { "eye": [0, 0, 8], "target": [0, 0, 0], "near": 2, "far": 2 } }'
refuses_text 'camera\.fov_y_degrees' '{ "camera": { "eye": [0, 0, 8], "target": [0, 0, 0], "fov_y_degrees": 180 } }'
too_many=$(yes '{ "position": [0, 0, 0] },' | head -n 32768)
refuses_scene 'points' "\"points\": [$too_many { \"position\": [0, 0, 0] }]"

# ---- The world integral, and light with a reach
point='"position": [0, 0, 0]'
refuses_world 'decay' '"decay": { "alpha": 1 }'
refuses_world 'core_pixels' '"core_pixels": 65'
refuses_world 'exposure' '"exposure": -1'
refuses_world 'light\.reach' '"light": { "gain": 1 }'
refuses_world 'light\.reach' '"light": { "reach": 0 }'
refuses_world 'light\.gain' '"light": { "gain": -1, "reach": 1 }'
refuses_world 'light\.shadow_thickness' '"light": { "reach": 1, "shadow_thickness": -1 }'
refuses_world 'light\.shadows' '"light": { "reach": 1, "shadows": true }'
refuses_world 'fog\.extinction' '"fog": { "extinction": -1 }'
refuses_world 'fog\.extinction' '"fog": { "height": { "scale": 1 } }'
refuses_world 'fog\.height\.scale' '"fog": { "extinction": 1, "height": { "base": 0 } }'
refuses_world 'fog\.height\.up' '"fog": { "extinction": 1, "height": { "scale": 1, "up": [0, 0, 0] } }'
ball='"shape": "sphere", "center": [0, 0, 0], "radius": 1'
refuses_world 'media\[0\]\.extinction' "\"media\": [{ $ball, \"extinction\": -1 }]"
refuses_world 'media\[0\]\.extinction' "\"media\": [{ $ball }]"
refuses_world 'media\[0\]\.albedo' "\"media\": [{ $ball, \"extinction\": 1, \"albedo\": 2 }]"
refuses_world 'media\[0\]\.shape' '"media": [{ "shape": "cone", "extinction": 1 }]'
refuses_world 'media\[0\]\.max' '"media": [{ "shape": "box", "min": [0, 0, 0], "max": [1, 1, 0], "extinction": 1 }]'
refuses_world 'points\[0\]\.reach' "\"points\": [{ $point }]"
refuses_world 'points\[1\]\.reach' "\"points\": [{ $point, \"reach\": 1 }, { $point, \"brightness\": 1 }]"
refuses_world 'points\[0\]\.reach' "\"points\": [{ $point, \"core\": 2, \"reach\": 2 }]"
refuses_world 'points\[0\]\.reach' "\"epsilon\": 2, \"points\": [{ $point, \"reach\": 1 }]"
refuses_world 'points\[0\]\.brightness' "\"points\": [{ $point, \"reach\": 1, \"brightness\": 1, \"coefficient\": 1 }]"
refuses_world 'points\[0\]\.sharpness' "\"points\": [{ $point, \"reach\": 1, \"sharpness\": 0.5 }]"
refuses_scene 'points\[0\]\.brightness' "\"points\": [{ $point, \"brightness\": 1 }]"
refuses_scene 'points\[0\]\.sharpness' "\"points\": [{ $point, \"sharpness\": 2 }]"

# ---- Paths
refuses_world 'paths\[0\]\.points' '"paths": [{ "reach": 1 }]'
refuses_world 'paths\[0\]\.points' '"paths": [{ "points": [[0, 0, 0]], "reach": 1 }]'
refuses_world 'paths\[0\]\.points\[1\]' '"paths": [{ "points": [[0, 0, 0], [1, 0]], "reach": 1 }]'
refuses_world 'paths\[0\]\.points' '"paths": [{ "kind": "bspline", "points": [[0, 0, 0], [1, 0, 0]], "reach": 1 }]'
refuses_world 'paths\[0\]\.points' '"paths": [{ "kind": "bezier", "points": [[0, 0, 0], [1, 0, 0]], "reach": 1 }]'
refuses_world 'paths\[0\]\.points' '"paths": [{ "closed": true, "points": [[0, 0, 0], [1, 0, 0]], "reach": 1 }]'
refuses_world 'paths\[0\]\.closed' \
    '"paths": [{ "kind": "bezier", "closed": true, "points": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [2, 1, 0]], "reach": 1 }]'
refuses_world 'paths\[0\]\.closed' '"paths": [{ "closed": 1, "points": [[0, 0, 0], [1, 0, 0]], "reach": 1 }]'
refuses_world 'paths\[0\]\.kind' '"paths": [{ "kind": "spiral", "points": [[0, 0, 0], [1, 0, 0]], "reach": 1 }]'
refuses_world 'paths\[0\]\.weights' '"paths": [{ "points": [[0, 0, 0], [1, 0, 0]], "weights": [], "reach": 1 }]'

# ---- Options
scene '"points": [{ "position": [0, 0, 0] }]'
for size in 0x10 10x0 0x0 10 10x 10x10x10 -5x5 5x-5 100000x100000 9999999999x1 axb ''; do
    refuses '--size' scene.json -o out/picture.png --size "$size"
done
for integrator in simpson simpson: simpson:0 simpson:3 simpson:-2 simpson:5000 simpson:8x adaptive:1e-9 newton; do
    refuses '--integrator' scene.json -o out/picture.png --integrator "$integrator"
done
refuses '--backend' scene.json -o out/picture.png --backend glide
refuses '--nonsense' scene.json -o out/picture.png --nonsense
refuses '-z' scene.json -o out/picture.png -z
refuses '--help=please' --help=please
refuses '--size' scene.json -o out/picture.png --size
refuses '-o' scene.json -o
refuses 'SCENE\.json' -o out/picture.png
refuses 'other\.json' scene.json other.json -o out/picture.png
refuses 'scene\.json' scene.json

# ---- Outputs
refuses 'out/picture\.jpg' scene.json -o out/picture.jpg
refuses 'out/picture' scene.json -o out/picture
refuses 'out/light\.png' scene.json --luminance out/light.png
refuses '-' scene.json --luminance -
refuses 'out/light\.pfm' scene.json -o out/light.pfm --luminance out/light.pfm
refuses 'nowhere/picture\.png' scene.json -o nowhere/picture.png --size 16x9
refuses 'nowhere/light\.pfm' scene.json --luminance nowhere/light.pfm --size 16x9
mkdir folder.png
refuses 'folder\.png' scene.json -o folder.png --size 16x9
# A limit on the size of files stands for a full disk.
# shellcheck disable=SC3045 # dash has it
limit=$(ulimit -S -f)
trap '' XFSZ
# shellcheck disable=SC3045 # dash has it
ulimit -S -f 1
for picture in out/picture.png out/picture.hdr out/picture.pfm; do
    refuses "$picture" scene.json -o $picture --size 160x90
done
# shellcheck disable=SC3045 # dash has it
ulimit -S -f "$limit"
trap - XFSZ

# ---- No GL: an EGL implementation that finds no driver (only Mesa's can be told to), and a loader that finds no implementation
if "$ew_render" scene.json -o picture.png --backend egl --size 16x9 2> stderr | grep -q Mesa; then
    export LIBGL_DRIVERS_PATH=/nonexistent
    refuses '--backend egl' scene.json -o out/picture.png --backend egl --size 16x9
fi
export __EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent
refuses '--backend egl' scene.json -o out/picture.png --backend egl --size 16x9

printf '%d cases, ' $cases
concludes
