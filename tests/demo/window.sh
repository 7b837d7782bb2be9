#!/bin/sh
# ew-demo in a real window, under Xvfb: keys are sent, and what the window shows is the offscreen frame of the same time; a scene
# file is read again when it is saved, and a bad one leaves the last good picture; resizing, minimising and closing work.
# Usage: window.sh EW_DEMO EW_RENDER SCENES VERSION
ew_demo=$1
for tool in Xvfb xdotool import compare; do
    command -v $tool > /dev/null || { echo "SKIPPED: $tool is not installed"; exit 77; }
done
failures=0
rm -rf window && mkdir window && cd window || exit 1
unset WAYLAND_DISPLAY

complain() {
    failures=$((failures + 1))
    printf 'FAILED: %s\n' "$*"
}

# The X server chooses a display that is free and writes its number.
mkfifo display
Xvfb -displayfd 3 -screen 0 400x300x24 3> display 2> /dev/null &
server=$!
demo=
trap 'kill $demo $server 2> /dev/null' EXIT
read -r number < display
export DISPLAY=:"$number"

focus() {
    timeout 5 xdotool windowfocus --sync "$id" || complain 'the window takes no focus'
}

# open ARGUMENT...: starts the demo and waits for its window.
open() {
    "$ew_demo" --size 192x108 "$@" > stdout 2> stderr < /dev/null &
    demo=$!
    id=$(timeout 20 xdotool search --sync --onlyvisible --name '^EnergyWave$' | head -n 1)
    [ -n "$id" ] || { complain "no window opens: $(cat stderr)"; exit 1; }
    focus
}

# waits WHAT COMMAND...: until the command succeeds, for 10 seconds at most.
waits() {
    what=$1
    shift
    for _ in $(seq 50); do
        "$@" && return 0
        sleep 0.2
    done
    complain "it never comes about that $what"
    return 1
}

press() {
    for key; do
        xdotool key "$key"
    done
}

# closes: by its key, and expects a clean end.
closes() {
    press Escape
    waits 'the window closes' sh -c "! kill -0 $demo 2> /dev/null" || kill -9 $demo
    wait $demo || complain "the demo exits with $?: $(cat stderr)"
    [ ! -s stderr ] || complain "the demo says: $(cat stderr)"
    demo=
}

# shows FILE FUZZ: whether the window shows this picture, but for differences of FUZZ.
shows() {
    import -window "$id" shown.png 2> /dev/null || return 1
    [ "$(compare -metric AE -fuzz "$2" shown.png "$1" null: 2>&1)" = 0 ]
}

offscreen() {
    "$ew_demo" --offscreen --size 192x108 "$@" > stdout 2> stderr || complain "ew-demo --offscreen $* exits with $?"
}

# Paused, from the beginning, three frames on, without the display of text.
offscreen --frames 3 -o 3.png
offscreen --frames 3 --integrator simpson:64 --split adaptive:1e-4 -o split.png
offscreen --frames 2 --show evaluations -o evaluations.png
open
press space r p period period period
waits 'the window shows frame 3' shows 3.png 0
press F12
waits 'a screenshot is written' test -s ew-demo-001.png
cmp -s ew-demo-001.png 3.png || complain 'the screenshot is not the offscreen frame'
press 4 shift+3
# The line between the halves is the window's own, and not in the screenshot.
press F12
waits 'a second screenshot is written' test -s ew-demo-002.png
cmp -s ew-demo-002.png split.png || complain 'the split picture is not the offscreen one'
press Tab 2 comma m
waits 'the window shows the evaluations a step back' shows evaluations.png 0
press m m c

# Another size; minimised and back.
xdotool windowsize "$id" 96 60
waits 'the window has the new size' sh -c "xdotool getwindowgeometry $id | grep -q 96x60"
"$ew_demo" --offscreen --size 96x60 --frames 2 -o small.png
waits 'the picture has the new size' shows small.png 0
xdotool windowunmap "$id"
sleep 0.5
xdotool windowmap "$id"
waits 'the picture is back' shows small.png 0
focus
press F11
waits 'it fills the screen' sh -c "xdotool getwindowgeometry $id | grep -q 400x300"
press F11
waits 'it goes back' sh -c "xdotool getwindowgeometry $id | grep -q 96x60"
focus
closes

# A scene file: shown, changed for a bad one, changed for another one.
scene() {
    printf '{ "camera": { "eye": [0,0,8], "target": [0,0,0] }, "points": [{ "position": [%s,0,0] }] }' "$1" > next.json
    mv next.json scene.json
}
scene 1
offscreen scene.json --frames 0 -o right.png
scene -1
offscreen scene.json --frames 0 -o left.png
open scene.json
press p
waits 'the window shows the scene' shows left.png 0
echo '{ "camera": 3 }' > scene.json
sleep 1
import -window "$id" error.png
# The message lies over the lower left corner of the last good picture.
convert error.png -crop 192x60+0+0 +repage error-top.png && convert left.png -crop 192x60+0+0 +repage left-top.png
[ "$(compare -metric AE error-top.png left-top.png null: 2>&1)" = 0 ] || complain 'a bad file spoils the last good picture'
shows left.png 0 && complain 'nothing is said about a bad file'
scene 1
sleep 5
waits 'the window shows the new scene' shows right.png 0
closes

# No display, and a display whose OpenGL is too old.
DISPLAY='' "$ew_demo" > stdout 2> stderr && complain 'no display is no error'
grep -q '^ew-demo: no display (.*--offscreen' stderr || complain "without a display it says: $(cat stderr)"
[ "$(wc -l < stderr)" -eq 1 ] || complain 'without a display it says more than a line'
MESA_GL_VERSION_OVERRIDE=2.1 "$ew_demo" > stdout 2> stderr && complain 'an old OpenGL is no error'
grep -q '^ew-demo: no OpenGL 3.3 core context (.*libgl1-mesa-dri' stderr || complain "with an old OpenGL it says: $(cat stderr)"

printf '%d failures\n' $failures
[ $failures -eq 0 ]
