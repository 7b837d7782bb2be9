#!/bin/sh
# EGL and OSMesa draw the same picture, and `auto` is one of them. Skipped, with the reason, if one of the two does not work.
# Usage: backends.sh EW_RENDER EW_PROBE_IMAGE SCENES
ew_render=$1
probe=$2
scenes=$3
. "$(dirname "$0")/../checks.sh"
enters backends

cat > mix.json << 'JSON'
{ "camera": { "eye": [0, 2, 8], "target": [0, 0.6, 0] }, "interval": { "start": 3, "end": 15 },
  "points": [{ "position": [0, 1.2, 0], "coefficient": 0.5, "color": [1, 0.6, 0.2] }],
  "lines": [{ "position": [-2, 0, -1], "direction": [0.2, 1, 0.1], "coefficient": 0.2 }],
  "tori": [{ "center": [0, 1, 0], "axis": [0, 1, 0.3], "radius": 1.6, "coefficient": 0.5 }],
  "curves": [{ "control_points": [[-4, 0.3, -1], [0, 5, 0], [4, 0.3, 1]], "coefficient": 0.5, "weights": [1, 0.2, 0.6, 1] }],
  "opaque": [{ "shape": "plane", "point": [0, 0, 0], "normal": [0, 1, 0] },
             { "shape": "sphere", "center": [1.5, 0.7, 1], "radius": 0.7, "color": [0.7, 0.3, 0.25] },
             { "shape": "box", "min": [-2.2, 0, -0.5], "max": [-1.6, 3, 0.1] }] }
JSON

for backend in egl osmesa; do
    if ! "$ew_render" mix.json -o mix.png --size 16x9 --backend $backend > stdout 2> stderr; then
        printf 'SKIPPED: %s\n' "$(cat stderr)"
        exit 77
    fi
    cat stdout
done

for scene in mix.json "$scenes"/*.json; do
    [ -e "$scene" ] || continue
    name=$(basename "$scene" .json)
    for backend in egl osmesa auto; do
        "$ew_render" "$scene" -o "$name.$backend.png" --size 320x180 --backend $backend > /dev/null ||
            complain "$name is not drawn by $backend"
    done
    alike "$probe" "$name.egl.png" "$name.osmesa.png"
    if ! cmp -s "$name.auto.png" "$name.egl.png" && ! cmp -s "$name.auto.png" "$name.osmesa.png"; then
        complain "$name: auto is neither EGL nor OSMesa"
    fi
done

concludes
