# What tests that are shell scripts share; they source it. A test complains of what is wrong, goes on, and concludes.
# shellcheck shell=sh
failures=0

# needs TOOL...: skips the test where one of them is not installed.
needs() {
    for tool; do
        command -v "$tool" > /dev/null || { echo "SKIPPED: $tool is not installed"; exit 77; }
    done
}

# enters FOLDER: a new one of that name, for what the test writes.
enters() {
    rm -rf "$1" && mkdir "$1" && cd "$1" || exit 1
}

complain() {
    failures=$((failures + 1))
    printf 'FAILED: %s\n' "$*"
}

# alike EW_PROBE_IMAGE A B: 8-bit pictures that may be by different rasterisers, at most 2/255 apart anywhere, and more than 1/255
# apart in 0.1 % of the pixels at most.
alike() {
    largest=256
    above=100
    "$1" difference "$2" "$3" > difference && read -r largest above < difference
    awk "BEGIN { exit !($largest <= 2 && $above <= 0.1) }" ||
        complain "$2 and $3: largest difference $largest, above 1: $above %"
}

# concludes: the last command of a test.
concludes() {
    printf '%d failures\n' $failures
    [ $failures -eq 0 ]
}
