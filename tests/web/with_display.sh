#!/bin/sh
# Runs a command with a display of its own, which ends with it.
# Usage: with_display.sh COMMAND...
number=$(mktemp)
Xvfb -displayfd 3 -screen 0 1024x768x24 3> "$number" > /dev/null 2>&1 &
display=$!
trap 'kill $display; rm -f "$number"' EXIT
while [ ! -s "$number" ] && kill -0 $display 2> /dev/null; do
    sleep 0.1
done
DISPLAY=:$(cat "$number") "$@"
