#!/bin/sh
# Runs a command that runs programs for Windows, with a display, a Windows folder and a wine server of its own, which end with
# it.
# Usage: with_wine.sh FOLDER DLL_FOLDERS COMMAND...; FOLDER is for wine's files, DLL_FOLDERS are separated by colons
set -eu
folder=$1 dll_folders=$2
shift 2
mkdir -p "$folder"
WINEPREFIX=$(cd "$folder" && pwd)
WINEPATH=$(echo "$dll_folders" | sed 's/:/;Z:/g; s/^/Z:/; s/\//\\/g')
WINEDEBUG=-all
WINEDLLOVERRIDES='mscoree=;mshtml=' # else a new folder asks for .NET and a browser
export WINEPREFIX WINEPATH WINEDEBUG WINEDLLOVERRIDES
unset WAYLAND_DISPLAY

rm -f "$folder/display"
mkfifo "$folder/display"
Xvfb -displayfd 3 -screen 0 1024x768x24 3> "$folder/display" 2> /dev/null &
server=$!
trap 'wineserver -k || true; kill $server' EXIT
trap 'exit 1' INT TERM
read -r number < "$folder/display"
export DISPLAY=:"$number"
wineserver -p # so that not every program has to start it
wineboot --init 2> /dev/null
"$@"
