#!/bin/sh
# On bad input ew-demo says on one line which option to mend and how, exits with status 2, and writes nothing.
# Usage: bad_input.sh EW_DEMO EW_RENDER SCENES VERSION
ew_demo=$1
. "$(dirname "$0")/../checks.sh"
enters bad_input
unset DISPLAY WAYLAND_DISPLAY

# refuses TEXT ARGUMENT...: expects ew-demo to refuse these arguments with a line that contains TEXT.
refuses() {
    text=$1
    shift
    "$ew_demo" "$@" > ../bad_input.stdout 2> ../bad_input.stderr < /dev/null
    status=$?
    [ $status -eq 2 ] || complain "ew-demo $* exits with $status"
    [ ! -s ../bad_input.stdout ] || complain "ew-demo $* prints on standard output"
    [ "$(wc -l < ../bad_input.stderr)" -eq 1 ] || complain "ew-demo $* prints $(wc -l < ../bad_input.stderr) lines"
    grep -qF -e "$text" ../bad_input.stderr || complain "ew-demo $* says: $(cat ../bad_input.stderr)"
    [ -z "$(ls -A)" ] || complain "ew-demo $* leaves $(ls -A)"
}

refuses '--size: must be WIDTHxHEIGHT' --size 640
refuses '--samples: must be a number from 1 to 4' --samples 5
refuses '--frames: must be two frame numbers' --offscreen --frames 5-3 -o %d.png
refuses '--frames: must be two frame numbers' --offscreen --frames -3 -o %d.png
refuses '--fps: must be a number from 1 to 240' --offscreen --fps 0 -o %d.png
refuses '--offscreen: no output is requested' --offscreen
refuses 'add --offscreen' -o frame%d.png
refuses 'add --offscreen' --video demo.mp4
refuses '--frames: is only for pictures; add --offscreen' --frames 3
refuses '--frames: is only for pictures; add --offscreen' --frames 0-299
refuses '--backend: is only for pictures; add --offscreen' --backend osmesa
refuses 'let it end in .png' --offscreen -o frame%d.jpg
refuses 'needs one place for the frame' --offscreen -o frame.png
refuses 'needs one place for the frame' --offscreen -o frame%s.png
refuses 'needs one place for the frame' --offscreen -o %d%d.png
refuses 'needs one place for the frame' --offscreen --frames 3 -o %s.png
refuses '--fast: is not an option' --fast
refuses '--help=please: is not an option' --help=please
refuses '-z: is not an option' -z
refuses '-o: needs a value' --offscreen -o
refuses 'is one scene too many' a.json b.json
refuses 'missing.json: cannot be opened' missing.json --offscreen --frames 0 -o %d.png
refuses 'cannot be written' --offscreen --frames 0 --size 8x8 -o missing/%d.png

concludes
