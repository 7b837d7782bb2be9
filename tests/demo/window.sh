#!/bin/sh
# ew-demo works in a real window, under Xvfb. After each key, the window shows the offscreen frame of the same time. A scene
# file is reloaded when it is saved, and a bad one leaves the last good picture. The window can be resized, minimised and
# closed.
# Usage: window.sh EW_DEMO EW_RENDER SCENES VERSION
ew_demo=$1
. "$(dirname "$0")/../checks.sh"
enters window
. "$(dirname "$0")/display.sh"
needs compare convert

press() {
    for key; do
        xdotool key "$key"
    done
}

# count_differing FILE: counts the pixels in which the window and this picture differ.
count_differing() {
    import -window "$id" shown.png 2> /dev/null && compare -metric AE shown.png "$1" null: 2>&1
}

shows() {
    [ "$(count_differing "$1")" = 0 ]
}

differs() {
    [ "$(count_differing "$1")" -gt 0 ]
}

offscreen() {
    "$ew_demo" --offscreen --size 192x108 "$@" > stdout 2> stderr || complain "ew-demo --offscreen $* exits with $?"
}

starts_display 400x300

# Paused, restarted, stepped by three frames, with the text hidden.
offscreen --frames 3 -o 3.png
offscreen --frames 3 --integrator simpson:64 --split adaptive:1e-4 -o split.png
offscreen --frames 2 --show evaluations -o evaluations.png
opens "$ew_demo" --size 192x108
press space r p period period period
waits 'the window shows frame 3' shows 3.png
press F12
waits 'a screenshot is written' test -s ew-demo-001.png
cmp -s ew-demo-001.png 3.png || complain 'the screenshot is not the offscreen frame'
press 4 shift+3
# The window draws a line between the halves, but the screenshot does not have it.
press F12
waits 'a second screenshot is written' test -s ew-demo-002.png
cmp -s ew-demo-002.png split.png || complain 'the split picture is not the offscreen one'
press Tab 2 comma m
waits 'the window shows the evaluations a step back' shows evaluations.png
press m m c

# Resized, minimised and restored.
xdotool windowsize "$id" 96 60
waits 'the window has the new size' sh -c "xdotool getwindowgeometry $id | grep -q 96x60"
"$ew_demo" --offscreen --size 96x60 --frames 2 -o small.png
waits 'the picture has the new size' shows small.png
xdotool windowunmap --sync "$id"
sleep 0.5 # time for some frames that are not shown
xdotool windowmap "$id"
waits 'the picture is back' shows small.png
focuses
press F11
waits 'it fills the screen' sh -c "xdotool getwindowgeometry $id | grep -q 400x300"
press F11
waits 'it goes back' sh -c "xdotool getwindowgeometry $id | grep -q 96x60"
closes

# A scene file is shown, then replaced by a bad one, then by another good one.
scene() {
    printf '{ "camera": { "eye": [0,0,8], "target": [0,0,0] }, "interval": { "start": 0.1, "end": 100 },
        "points": [{ "position": [%s,0,0] }] }' "$1" > next.json
    mv next.json scene.json
}
scene 1
offscreen scene.json --frames 0 -o right.png
scene -1
offscreen scene.json --frames 0 -o left.png
opens "$ew_demo" --size 192x108 scene.json
press p
waits 'the window shows the scene' shows left.png
echo '{ "camera": 3 }' > scene.json
waits 'something is said about a bad file' differs left.png
import -window "$id" error.png
# The message lies over the lower left corner of the last good picture.
convert error.png -crop 192x60+0+0 +repage error-top.png && convert left.png -crop 192x60+0+0 +repage left-top.png
[ "$(compare -metric AE error-top.png left-top.png null: 2>&1)" = 0 ] || complain 'a bad file spoils the last good picture'
# A message that is wider than the window goes on in further lines, instead of being cut off at its edge.
printf '{ "%s": 3 }' "a_key_$(printf 'that_no_scene_has_and_%.0s' 1 2 3 4 5)" > scene.json
lines() {
    import -window "$id" error.png && convert error.png -crop 192x20+0+50 +repage error-middle.png &&
        convert left.png -crop 192x20+0+50 +repage left-middle.png &&
        [ "$(compare -metric AE error-middle.png left-middle.png null: 2>&1)" -gt 0 ]
}
waits 'a long message has several lines' lines
scene 1
# The notice of the reload lies over the picture for 4 seconds.
waits 'the window shows the new scene' shows right.png
closes

# There is no display, or its OpenGL is too old.
DISPLAY='' "$ew_demo" > stdout 2> stderr && complain 'no display is no error'
grep -q '^ew-demo: no display (.*--offscreen' stderr || complain "without a display it says: $(cat stderr)"
[ "$(wc -l < stderr)" -eq 1 ] || complain 'without a display it says more than a line'
MESA_GL_VERSION_OVERRIDE=2.1 "$ew_demo" > stdout 2> stderr && complain 'an old OpenGL is no error'
grep -q '^ew-demo: no OpenGL 3.3 core context (.*libgl1-mesa-dri' stderr || complain "with an old OpenGL it says: $(cat stderr)"

concludes
