#!/bin/sh
# ew-render writes what it was asked for, and nothing else. Each format holds the same picture the right way up, the luminance
# is B, and every scene file that comes with it renders.
# Usage: output.sh EW_RENDER EW_PROBE_IMAGE SCENES VERSION
ew_render=$1
probe=$2
scenes=$3
version=$4
. "$(dirname "$0")/../checks.sh"
enters output
mkdir out

# is WHAT EXPECTED FOUND: expects two texts to be equal.
is() {
    [ "$2" = "$3" ] || complain "$1 is \"$3\" instead of \"$2\""
}

# renders ARGUMENT...: expects success, nothing on standard error, and one line on standard output.
renders() {
    "$ew_render" "$@" > stdout 2> stderr < /dev/null
    is "exit status of ew-render $*" 0 $?
    is "standard error of ew-render $*" '' "$(cat stderr)"
    is "number of lines ew-render $* prints" 1 "$(wc -l < stdout)"
}

# A box fills the upper left quarter. The background's numbers have exact RGBE and sRGB values.
cat > box.json << 'JSON'
{ "version": 1, "comment": "a box in the upper left quarter",
  "camera": { "projection": "orthographic", "height": 2, "eye": [0, 0, 8], "target": [0, 0, 0] },
  "background": [0.5, 0.25, 2],
  "opaque": [{ "shape": "box", "min": [-9, 0, -1], "max": [0, 9, 1], "color": [0.1, 0.8, 0.1] }] }
JSON
for format in png hdr pfm; do
    picture=out/box.$format
    renders box.json -o $picture --size 40x20
    is "the size of $picture" '40 20 3' "$("$probe" size $picture)"
    case $format in
    png) background='188 137 255' ;;
    *) background='0.5 0.25 2' ;;
    esac
    for at in '30 5' '10 15' '30 15' '20 9' '19 10'; do
        # shellcheck disable=SC2086 # a column and a row
        is "$picture at $at" "$background" "$("$probe" pixel $picture $at)"
    done
done
# PNG and RGBE may differ from the floats only by rounding.
for at in '10 5' '19 9' '0 0'; do
    # shellcheck disable=SC2086
    { "$probe" pixel out/box.pfm $at && "$probe" pixel out/box.hdr $at && "$probe" pixel out/box.png $at; } | awk '
        { for (i = 1; i <= 3; i++) value[NR, i] = $i }
        END {
            for (i = 1; i <= 3; i++) {
                x = value[1, i]
                srgb = 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ^ (1 / 2.4) - 0.055)
                if (!(x > 0) || x == 0.5 || x == 0.25 || x == 2) exit 1
                if (x - value[2, i] > 0.01 * value[1, 2] || value[2, i] > x) exit 1
                if (value[3, i] - srgb > 0.51 || srgb - value[3, i] > 0.51) exit 1
            }
        }' || complain "the box's colour at $at differs between the formats"
done
is 'the PFM header' "PF 40 20 -1.0" "$(head -n 3 out/box.pfm | tr '\n' ' ' | sed 's/ $//')"

# The luminance of a point is largest at the point, the same to its left and right, and independent of other outputs.
cat > point.json << 'JSON'
{ "camera": { "eye": [0, 0, 8], "target": [0, 0, 0] }, "interval": { "start": 0.1, "end": 100 },
  "points": [{ "position": [0, 0, 0] }] }
JSON
renders point.json --luminance out/point.pfm --size 41x21
is 'the size of a luminance' '41 21 1' "$("$probe" size out/point.pfm)"
is 'a luminance beside a point' "$("$probe" pixel out/point.pfm 19 10)" "$("$probe" pixel out/point.pfm 21 10)"
{ "$probe" pixel out/point.pfm 19 10 && "$probe" pixel out/point.pfm 20 10; } | awk '{ b[NR] = $1 } END { exit !(0 < b[1] && b[1] < b[2]) }' ||
    complain 'the luminance is not largest at the point'
renders point.json -o out/point.png --luminance out/again.pfm --size 41x21
cmp -s out/point.pfm out/again.pfm || complain 'the luminance depends on what else is written'
# A wall hides half of the glow.
sed 's/ }\]/ }], "opaque": [{ "shape": "plane", "point": [0, 0, 0], "normal": [0, 0, 1] }]/' point.json > wall.json
renders wall.json --luminance out/wall.pfm --size 41x21
{ "$probe" pixel out/point.pfm 25 10 && "$probe" pixel out/wall.pfm 25 10; } |
    awk '{ b[NR] = $1 } END { exit !(0 < b[2] && b[2] < 0.9 * b[1]) }' || complain 'light shines through a wall'
renders box.json --luminance out/dark.pfm --size 41x21
is 'the luminance of nothing' 0 "$("$probe" pixel out/dark.pfm 20 10)"

# A picture may go to standard output. The same scene, saved with a byte order mark, is the same picture.
renders box.json -o out/box.png --size 40x20
"$ew_render" box.json -o - --size 40x20 > out/printed.png 2> stderr < /dev/null || complain 'no picture goes to standard output'
cmp -s out/box.png out/printed.png || complain 'the picture on standard output is another one'
is 'the number of lines on standard error beside a picture' 1 "$(wc -l < stderr)"
{ printf '\357\273\277' && cat box.json; } > marked.json
renders marked.json -o out/printed.png --size 40x20
cmp -s out/box.png out/printed.png || complain 'a byte order mark changes the picture'
rm out/printed.png
if [ -c /dev/full ]; then
    "$ew_render" box.json -o - --size 40x20 > /dev/full 2> stderr < /dev/null
    is 'the exit status on a full disk' 2 $?
    tail -n 1 stderr | grep -q '^ew-render: -: ' || complain "on a full disk it says: $(cat stderr)"
fi

# Each composite draws, and light that is exposed more is brighter.
cat > world.json << 'JSON'
{ "camera": { "eye": [0, 0, 8], "target": [0, 0, 0] }, "background": [0.1, 0.1, 0.1], "composite": "soft", "exposure": 1,
  "core_pixels": 0,
  "points": [{ "position": [0, 0, 0], "core": 0.1, "reach": 2, "brightness": 0.5, "color": [1, 1, 1] }],
  "paths": [{ "points": [[-3, 1, 0], [3, 1, 0]], "core": 0.05, "reach": 1, "brightness": 0.5, "sharpness": 2 }] }
JSON
renders world.json -o out/soft.pfm --size 41x21
sed 's/"exposure": 1/"exposure": 2/' world.json > bright.json
renders bright.json -o out/bright.pfm --size 41x21
for composite in lerp add; do
    sed "s/soft/$composite/" world.json > $composite.json
    renders $composite.json -o out/$composite.pfm --size 41x21
done
# Through the middle of the orb B is its brightness, and the light is white.
for picture in soft bright lerp add; do
    "$probe" pixel out/$picture.pfm 20 10
done | awk '{ c[NR] = $1 } END {
    b = c[4] - 0.1
    if (b < 0.4995 || b > 0.5005) exit 1
    if (c[1] < 0.999 * (1 - 0.9 * exp(-b)) || c[1] > 1.001 * (1 - 0.9 * exp(-b))) exit 1
    if (c[2] < 0.999 * (1 - 0.9 * exp(-2 * b)) || c[2] > 1.001 * (1 - 0.9 * exp(-2 * b))) exit 1
    if (c[3] < 0.999 * ((1 - b) * 0.1 + b) || c[3] > 1.001 * ((1 - b) * 0.1 + b)) exit 1
}' || complain 'the composites are not what the scene format says'
rm out/soft.pfm out/bright.pfm out/lerp.pfm out/add.pfm

# The scene that the reference of the format shows is one.
awk '/^```json$/ { inside = 1; next } /^```$/ { inside = 0 } inside' "$scenes/../../docs/scene-format.md" > shown.json
renders shown.json -o out/shown.png --size 41x21
rm out/shown.png

# An existing output is replaced, and gets the permissions of a new file.
umask 022
printf 'old' > out/box.png
renders box.json -o out/box.png --size 40x20
is 'the size of a replaced picture' '40 20 3' "$("$probe" size out/box.png)"
is 'the permissions of a picture' '-rw-r--r--' "$(ls -l out/box.png | cut -c 1-10)"
is 'the files left' 'again.pfm box.hdr box.pfm box.png dark.pfm point.pfm point.png wall.pfm' "$(ls -A out | tr '\n' ' ' | sed 's/ $//')"

for integrator in adaptive adaptive:1e-2 adaptive:1e-3 adaptive:1e-4 simpson:2 simpson:200; do
    renders point.json -o out/point.png --size 16x9 --integrator $integrator
done
renders point.json -o out/default.png
is 'the default size' '640 360 3' "$("$probe" size out/default.png)"
for scene in "$scenes"/*.json; do
    [ -e "$scene" ] && renders "$scene" -o out/scene.png --size 64x36
done

is 'the version' "ew-render $version" "$("$ew_render" --version)"
"$ew_render" --help | grep -q '^Usage: ew-render' || complain '--help shows no usage'

concludes
