#!/bin/sh
# A scene file is changed in ew-demo's window by the mouse and by keys, and saved, under Xvfb: sources, opaque shapes and media are selected by
# a click on them, their points, arrows, radii and corners and their sliders are dragged, and undone. The file then holds what was done,
# and else what it held before. What another program saves meanwhile is not overwritten.
# Usage: edit.sh EW_DEMO EW_RENDER SCENES VERSION
ew_demo=$1
. "$(dirname "$0")/../checks.sh"
enters edit
. "$(dirname "$0")/display.sh"
needs compare identify

# At a depth of 10, the picture of 300 rows is 10 units high: 30 pixels a unit. The origin is at pixel (200, 150).
cat > original.json << 'TEXT'
{ "comment": "kept as it is",
  "camera": { "eye": [0, 0, 10], "target": [0, 0, 0], "fov_y_degrees": 53.13010235415598 },
  "points": [{ "name": "orb", "position": [-3, 2, 0], "core": 0.2, "reach": 1.00, "brightness": 2 }],
  "paths": [{ "name": "b\u0065am", "points": [[-3,-1.50,0], [2, -1.5, 0]], "core": 0.1, "reach": 1, "brightness": 2 }] }
TEXT

# The window takes events in their order, however slow it is.
# drags X Y X Y: presses the mouse at the first pixel and lets it go at the second, some frames later if the machine is fast.
drags() {
    xdotool mousemove --window "$id" "$1" "$2" mousedown 1 sleep 0.05 mousemove --window "$id" "$3" "$4" sleep 0.05 mouseup 1
}

clicks() {
    xdotool mousemove --window "$id" "$1" "$2" click 1
}

holds() {
    cmp -s scene.json "$1"
}

press() {
    for key; do
        xdotool key "$key"
    done
}

# saves EXPECTED: saves, and waits until the file is this one.
saves() {
    press ctrl+s
    waits "the file is $1" holds "$1" || diff scene.json "$1"
}

shows() {
    import -window "$id" "$1"
}

has_colors() {
    shows "$1" && [ "$(identify -format '%k' "$1")" -gt 50 ]
}

has_changed() {
    shows now.png && [ "$(compare -metric AE now.png "$1" null: 2>&1)" -gt 100 ]
}

starts_display 400x300
cp original.json scene.json
opens "$ew_demo" --size 400x300 --samples 1 scene.json
waits 'the scene is shown' has_colors opened.png

# A click beside the beam's axis, on its glow, selects it, and changes nothing.
clicks 170 202
waits 'the selected source is marked' has_changed opened.png
saves original.json

# The beam's right end, at pixel (260, 195), is dragged by (-60, +30) pixels, which is (-2, -1) units. It was taken beside its middle.
drags 262 196 202 226
sed 's/\[2, -1.5, 0\]/[0, -2.5, 0]/' original.json > moved.json
saves moved.json

# The slider of its reach runs from 0.01 at column 220 to 100 at column 384.
drags 302 76 314 76
sed 's/"reach": 1,/"reach": 1.96,/' moved.json > wider.json
saves wider.json
shows wider.png
press ctrl+z ctrl+z
saves original.json
press ctrl+y
saves moved.json
press ctrl+shift+z
saves wider.json
press ctrl+z ctrl+z

# The bar that the mouse has moved is the one that the keys move.
press Right
sed 's/"reach": 1,/"reach": 1.1,/' original.json > key.json
saves key.json
press ctrl+z

# The core may not be wider than the reach: the slider ends before it.
drags 302 46 390 46
sed 's/"core": 0.1/"core": 0.95/' original.json > core.json
saves core.json
press ctrl+z

# changes FROM TO: the script of sed that makes the file that is expected next, out of the last one.
changes() {
    sed "s/$1/$2/" expected.json > next.json
    cmp -s next.json expected.json && complain "$1 is not in the file"
    mv next.json expected.json
}

# Keys do the same. N goes from part to part: to the orb, whose core is the first bar of 4 powers of ten; to the beam; to none; and back.
# An arrow moves a bar by a hundredth of its length, and with Shift by a thousandth.
clicks 20 280
cp original.json expected.json
press n Right
changes '"core": 0.2' '"core": 0.219'
saves expected.json
press Down shift+Left
changes '"reach": 1.00' '"reach": 0.991'
saves expected.json
press n Down Right Right
changes '"brightness": 2 }] }' '"brightness": 2.16 }] }'
saves expected.json
press n Left shift+n Up shift+Right
changes '"reach": 1,' '"reach": 1.01,'
saves expected.json
press p n Right p
saves expected.json

# However long a key is down, that is one step.
xdotool keydown Right sleep 1.5 keyup Right
press ctrl+s
waits 'a key that is held goes on' sh -c 'grep -q "reach\": \(1\.[2-9]\|[2-9]\|[1-9][0-9]\)" scene.json'
press ctrl+z
saves expected.json
press ctrl+z ctrl+z ctrl+z ctrl+z ctrl+z
saves original.json
press shift+n

# A click beside all light selects nothing: what was a point's handle then turns the camera.
clicks 20 280
drags 260 195 200 225
saves original.json
press c

# What another program saves is not overwritten: it is read, as a step that can be undone. A fault that it saves stays as well.
clicks 110 90
drags 110 90 140 90
sed 's/\[-3, 2, 0\]/[-2, 2, 0]/' original.json > orb.json
sed 's/kept as it is/of another program/' original.json > other.json
cp other.json next.json
mv next.json scene.json
press ctrl+s
sleep 0.5
holds other.json || complain 'what another program saved is overwritten'
press ctrl+z
saves orb.json
echo '{ "camera": 3 }' > fault.json
cp fault.json scene.json
press ctrl+s
sleep 0.5
holds fault.json || complain 'a fault that another program saved is overwritten'
rm scene.json
saves orb.json

# Links stay, as do permissions.
mv scene.json kept.json
chmod 640 kept.json
ln -s kept.json scene.json
sleep 0.5
press ctrl+z
saves original.json
[ -L scene.json ] || complain 'a link is replaced'
[ "$(stat -c %a kept.json)" = 640 ] || complain "the permissions become $(stat -c %a kept.json)"

# What is not saved is not dropped without a warning.
press ctrl+y
focuses
press Escape
sleep 0.5
has_ended && complain 'the window closes over changes that are not saved'
shows warning.png
closes
holds original.json || complain 'closing saves'
[ "$(find . -name '*.tmp')" = '' ] || complain "it leaves $(find . -name '*.tmp')"

# Directions are dragged by the ends of arrows, which are 37.5 pixels long: from there to (22.5, 30) or (30, 22.5) they turn by 3 : 4 : 5.
# Radii are dragged by their ends, and boxes by their middles and corners. At the corner's depth of 9.5, a pixel is 0.0317 units.
cat > expected.json << 'TEXT'
{ "camera": { "eye": [0, 0, 10], "target": [0, 0, 0], "fov_y_degrees": 53.13010235415598 },
  "lines": [{ "position": [-5, -4, 0], "direction": [7, 0, 0], "core": 0.05, "reach": 0.3, "brightness": 2 }],
  "tori": [{ "center": [-4, 2, 0], "axis": [0, 2, 0], "radius": 1, "core": 0.05, "reach": 0.3, "brightness": 2 }],
  "opaque": [{ "shape": "box", "min": [-5, -2, -0.5], "max": [-4, -1, 0.5] },
    { "shape": "sphere", "center": [1, -2.5, 0], "radius": 1 },
    { "shape": "plane", "point": [6, -5, -10], "normal": [0, 1, 0.0] }] }
TEXT
cp expected.json shapes.json
rm scene.json kept.json
cp expected.json scene.json
opens "$ew_demo" --size 400x300 --samples 1 scene.json
waits 'the shapes are shown' has_colors opened.png

clicks 110 91
drags 110 90 125 90
changes '"radius": 1, "core"' '"radius": 1.5, "core"'
saves expected.json
drags 80 53 110 68
changes '\[0, 2, 0\]' '[0.8, 0.6, 0]'
saves expected.json

clicks 65 195
drags 65 195 95 165
changes '\[-5, -2, -0.5\], "max": \[-4, -1, 0.5\]' '[-4, -1, -0.5], "max": [-3, 0, 0.5]'
saves expected.json
shows box.png
drags 105 150 124 131
changes '\[-3, 0, 0.5\]' '[-2.4, 0.6, 0.5]'
saves expected.json

clicks 235 230
drags 260 225 275 225
changes '"radius": 1 }' '"radius": 1.5 }'
saves expected.json
drags 230 225 200 225
changes '\[1, -2.5, 0\]' '[0, -2.5, 0]'
saves expected.json

clicks 150 272
drags 88 270 73 240
changes '\[7, 0, 0\]' '[0.6, 0.8, 0]'
saves expected.json

clicks 330 280
drags 290 188 320 203
changes '\[0, 1, 0.0\]' '[0.8, 0.6, 0]'
saves expected.json
drags 290 225 305 225
changes '\[6, -5, -10\]' '[7, -5, -10]'
saves expected.json

# Shapes have no bars, but N comes to them, behind the sources: from the plane on to none, the line and the ring.
press Right n n n Right
changes '1.5, "core": 0.05' '1.5, "core": 0.0548'
saves expected.json
press ctrl+z ctrl+z ctrl+z ctrl+z ctrl+z ctrl+z ctrl+z ctrl+z ctrl+z ctrl+z ctrl+z ctrl+z
saves shapes.json
press h
shows keys.png
closes

# Media are clicked on, too. They are dragged as opaque shapes are, an ellipsoid by each of its radii; extinction and albedo have bars.
cat > expected.json << 'TEXT'
{ "camera": { "eye": [0, 0, 10], "target": [0, 0, 0], "fov_y_degrees": 53.13010235415598 },
  "media": [{ "shape": "sphere", "center": [-4, 2, 0], "radius": 1, "extinction": 1, "albedo": 0.5 },
    { "shape": "ellipsoid", "center": [1, -2, 0], "radii": [2, 1, 1.0], "extinction": 2 }] }
TEXT
cp expected.json media.json
cp expected.json scene.json
opens "$ew_demo" --size 400x300 --samples 1 scene.json
waits 'the media are shown' has_colors opened.png
clicks 80 85
drags 110 90 125 90
changes '"radius": 1,' '"radius": 1.5,'
saves expected.json
drags 80 90 110 120
changes '\[-4, 2, 0\]' '[-3, 1, 0]'
saves expected.json
drags 302 46 314 46
changes '"extinction": 1,' '"extinction": 1.96,'
saves expected.json
drags 302 76 343 76
changes '"albedo": 0.5' '"albedo": 0.75'
saves expected.json
clicks 230 215
drags 290 210 320 210
changes '\[2, 1, 1.0\]' '[3, 1, 1]'
saves expected.json
drags 230 180 230 165
changes '\[3, 1, 1\]' '[3, 1.5, 1]'
saves expected.json
shows media.png
press ctrl+z ctrl+z ctrl+z ctrl+z ctrl+z ctrl+z
saves media.json
closes
concludes
