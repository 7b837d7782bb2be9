# Starts a display for a test and opens a program's window on it. A test sources this after checks.sh and `enters`.
# shellcheck shell=sh
needs Xvfb xdotool import
unset WAYLAND_DISPLAY

# starts_display WIDTHxHEIGHT: starts an X server, which chooses a free display number and writes it to the pipe.
starts_display() {
    mkfifo display
    Xvfb -displayfd 3 -screen 0 "$1"x24 3> display 2> /dev/null &
    server=$!
    program=
    trap 'kill $program $server 2> /dev/null' EXIT
    read -r number < display
    export DISPLAY=:"$number"
}

# waits WHAT COMMAND...: waits until the command succeeds, for at most 20 seconds.
waits() {
    what=$1
    shift
    for _ in $(seq 100); do
        "$@" && return 0
        sleep 0.2
    done
    complain "it never comes about that $what"
    return 1
}

focuses() {
    timeout 5 xdotool windowfocus --sync "$id" || complain 'the window takes no focus'
}

# opens PROGRAM ARGUMENT...: starts the program and waits for its window, whose number is `id`.
opens() {
    "$@" > stdout 2> stderr < /dev/null &
    program=$!
    id=$(timeout 20 xdotool search --sync --onlyvisible --name '^EnergyWave$' | head -n 1)
    [ -n "$id" ] || { complain "no window opens: $(cat stderr)"; exit 1; }
    focuses
}

has_ended() {
    ! kill -0 "$program" 2> /dev/null
}

# closes: presses Escape, and expects the program to end without an error.
closes() {
    focuses
    xdotool keydown Escape
    waits 'the window closes' has_ended || kill -9 "$program"
    xdotool keyup Escape
    wait "$program" || complain "the program exits with $?: $(cat stderr)"
    [ ! -s stderr ] || complain "the program says: $(cat stderr)"
    program=
}
