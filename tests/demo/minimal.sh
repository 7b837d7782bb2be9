#!/bin/sh
# demo/minimal.c in a window under Xvfb: what it shows glows and moves, the window may be resized, and Escape ends it cleanly.
# Usage: minimal.sh MINIMAL
minimal=$1
. "$(dirname "$0")/../checks.sh"
enters minimal
. "$(dirname "$0")/display.sh"
needs identify

# glows FILE: whether the window, saved to the file, has the many colours of light; the pillars alone have four.
glows() {
    import -window "$id" "$1" && [ "$(identify -format '%k' "$1")" -gt 500 ]
}

moves() {
    glows later.png && ! cmp -s glow.png later.png
}

starts_display 960x540
opens "$minimal"
xdotool windowsize --sync "$id" 320 180
waits 'it glows' glows glow.png
waits 'it moves' moves
closes
concludes
