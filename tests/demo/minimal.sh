#!/bin/sh
# demo/minimal.c shows light that moves in a window under Xvfb. The window can be resized, and Escape ends the program cleanly.
# Usage: minimal.sh MINIMAL
minimal=$1
. "$(dirname "$0")/../checks.sh"
enters minimal
. "$(dirname "$0")/display.sh"
needs identify

# glows FILE: saves the window to the file, and checks for the many colours of light; the pillars alone have four.
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
