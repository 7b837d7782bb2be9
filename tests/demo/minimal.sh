#!/bin/sh
# demo/minimal.c in a window under Xvfb: what it shows glows and moves, the window may be resized, and Escape ends it cleanly.
# Usage: minimal.sh MINIMAL
minimal=$1
for tool in Xvfb xdotool import identify; do
    command -v $tool > /dev/null || { echo "SKIPPED: $tool is not installed"; exit 77; }
done
rm -rf minimal && mkdir minimal && cd minimal || exit 1
unset WAYLAND_DISPLAY

# The X server chooses a display that is free and writes its number.
mkfifo display
Xvfb -displayfd 3 -screen 0 960x540x24 3> display 2> /dev/null &
server=$!
host=
trap 'kill $host $server 2> /dev/null' EXIT
read -r number < display
export DISPLAY=:"$number"

fail() {
    printf 'FAILED: %s\n' "$*"
    cat stderr
    exit 1
}

# waits WHAT COMMAND...: until the command succeeds, for 20 seconds at most.
waits() {
    what=$1
    shift
    for _ in $(seq 100); do
        "$@" && return 0
        sleep 0.2
    done
    fail "it never comes about that $what"
}

# glows FILE: whether the window, saved to the file, has the many colours of light; the pillars alone have four.
glows() {
    import -window "$id" "$1" && [ "$(identify -format '%k' "$1")" -gt 500 ]
}

moves() {
    glows later.png && ! cmp -s glow.png later.png
}

"$minimal" 2> stderr &
host=$!
id=$(timeout 20 xdotool search --sync --onlyvisible --name '^EnergyWave$' | head -n 1)
[ -n "$id" ] || fail 'no window opens'
xdotool windowsize --sync "$id" 320 180
waits 'it glows' glows glow.png
waits 'it moves' moves
timeout 5 xdotool windowfocus --sync "$id"
xdotool keydown Escape
waits 'the window closes' sh -c "! kill -0 $host 2> /dev/null"
wait $host || fail "it ends with $?"
[ ! -s stderr ] || fail 'it complains'
