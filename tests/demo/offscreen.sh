#!/bin/sh
# ew-demo writes frames without a window. A part of a run has the same frames as the whole run, in any order. The animation
# moves and loops without a jump. A scene file looks as ew-render draws it.
# Usage: offscreen.sh EW_DEMO EW_RENDER SCENES VERSION
ew_demo=$1
ew_render=$2
scenes=$3
version=$4
. "$(dirname "$0")/../checks.sh"
enters offscreen
unset DISPLAY WAYLAND_DISPLAY

# draws ARGUMENT...: expects ew-demo to write frames of 96x54 and to print nothing.
draws() {
    "$ew_demo" --offscreen --size 96x54 "$@" > output 2>&1 < /dev/null || complain "ew-demo --offscreen $* exits with $?"
    [ ! -s output ] || complain "ew-demo --offscreen $* says: $(cat output)"
}

# A few frames a second make the run short; the shot, at 5 seconds, lies between its frames 20 and 21.
mkdir whole split reverse
draws --fps 4 --frames 18-23 -o whole/%03d.png
for frames in 18-19 20 21-23; do
    draws --fps 4 --frames $frames -o split/%03d.png
done
for frame in 23 21 18; do
    draws --fps 4 --frames $frame -o reverse/%03d.png
done
[ "$(ls whole | tr '\n' ' ')" = '018.png 019.png 020.png 021.png 022.png 023.png ' ] || complain "a run of 18-23 has $(ls whole)"
for frame in 018 019 020 021 022 023; do
    cmp -s whole/$frame.png split/$frame.png || complain "frame $frame differs between a whole run and a part of it"
done
for frame in 018 021 023; do
    cmp -s whole/$frame.png reverse/$frame.png || complain "frame $frame depends on the frames before it"
done
[ "$(cksum whole/*.png | cut -d ' ' -f 1 | sort -u | wc -l)" -eq 6 ] || complain 'not every frame is a new one'

# Edges are smooth unless that is unwanted.
draws --fps 4 --frames 18 --samples 1 -o rough.png
draws --fps 4 --frames 18 --samples 2 -o smooth.png
cmp -s rough.png whole/018.png && complain 'the demo is not antialiased'
cmp -s smooth.png whole/018.png || complain 'the demo is antialiased otherwise than by --samples 2'

draws --fps 4 --frames 0 -o start.png
draws --fps 4 --frames 40 -o end.png
cmp -s start.png end.png || complain 'the animation jumps where it starts again'

# The picture of a scene file is ew-render's, except for rounding to 16-bit floats and to the display's encoding.
draws "$scenes/showpiece.json" --frames 0 --samples 1 -o scene.png
"$ew_render" "$scenes/showpiece.json" --size 96x54 -o expected.png > /dev/null || complain 'ew-render fails'
if command -v compare > /dev/null; then
    differing=$(compare -metric AE -fuzz 0.5% scene.png expected.png null: 2>&1)
    [ "$differing" = 0 ] || complain "$differing pixels of a scene file's picture differ from ew-render's"
fi

# A video has the frames that were asked for. If ffmpeg is missing or fails, ew-demo says so.
if command -v ffprobe > /dev/null; then
    draws --fps 4 --frames 3-7 --video video.mp4
    found=$(ffprobe -v error -count_frames -select_streams v -show_entries stream=width,height,nb_read_frames -of csv=p=0 video.mp4)
    [ "$found" = 96,54,5 ] || complain "a video of 5 frames is $found"
    "$ew_demo" --offscreen --size 8x8 --frames 0-3 --video video.nothing > output 2>&1 && complain 'a video of no format is no error'
    grep -q '^ew-demo: --video: ffmpeg could not write video.nothing' output || complain "ffmpeg's failure is: $(cat output)"
fi
mkdir nowhere
PATH=$PWD/nowhere "$ew_demo" --offscreen --size 8x8 --frames 0 --video none.mp4 > output 2>&1 && complain 'no ffmpeg is no error'
grep -q '^ew-demo: --video: ffmpeg is not installed' output || complain "without ffmpeg it says: $(cat output)"

[ "$("$ew_demo" --version)" = "ew-demo $version" ] || complain "the version is $("$ew_demo" --version)"
"$ew_demo" --help | grep -q '^Usage: ew-demo' || complain '--help shows no usage'

concludes
