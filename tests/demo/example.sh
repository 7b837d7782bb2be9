#!/bin/sh
# An example of demo/examples shows light that moves, in a window under Xvfb. The window can be resized, and Escape ends the
# program cleanly.
# Usage: example.sh EXAMPLE
example=$1
. "$(dirname "$0")/../checks.sh"
enters "$(basename "$example")"
. "$(dirname "$0")/display.sh"
needs identify

# glows FILE: saves the window to the file, and checks for the many colours of light; what else is there has a few.
glows() {
    import -window "$id" "$1" && [ "$(identify -format '%k' "$1")" -gt 500 ]
}

moves() {
    glows later.png && ! cmp -s glow.png later.png
}

starts_display 960x540
opens "$example"
# shellcheck disable=SC2154 # display.sh gives id
xdotool windowsize --sync "$id" 320 180
waits 'it glows' glows glow.png
waits 'it moves' moves
closes
concludes
