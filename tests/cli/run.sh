#!/bin/sh
# ./run says what a word is that is no command, and before it begins what it installs and about how long it takes.
# Usage: run.sh REPOSITORY
run=$1/run
. "$(dirname "$0")/../checks.sh"
enters run

# says TEXT: expects TEXT in what the last call printed.
says() {
    grep -qF -e "$1" said || complain "./run does not say \"$1\", but: $(cat said)"
}

sh "$run" demoo > said 2>&1
[ $? -eq 2 ] || complain './run demoo does not exit with 2'
says '"demoo"'
sh "$run" test fast > said 2>&1
[ $? -eq 2 ] || complain './run test fast does not exit with 2'
says '"test fast"'
sh "$run" help > said 2>&1 || complain './run help fails'
says 'minutes'

# A Debian on which nothing is installed, and somebody who is not root and has no sudo.
mkdir bin
for tool in dirname cat sed; do
    ln -s "$(command -v $tool)" bin/$tool
done
for tool in apt-get dpkg-query; do
    printf '#!/bin/sh\nexit 0\n' > bin/$tool
done
printf '#!/bin/sh\necho 1000\n' > bin/id
chmod +x bin/*
PATH=$PWD/bin "$(command -v sh)" "$run" test > said 2>&1
[ $? -eq 1 ] || complain 'without root ./run test does not exit with 1'
says 'minutes'
says 'apt-get update'
says 'libcmocka-dev'
[ "$(grep -n -m1 minutes said | cut -d: -f1)" -lt "$(grep -n -m1 libcmocka-dev said | cut -d: -f1)" ] ||
    complain 'the time is not said beforehand'

concludes
