# Functions for the tests that are shell scripts; they source this file. A test reports each fault with `complain`, goes on, and
# ends with `concludes`.
# shellcheck shell=sh
failures=0

# needs TOOL...: skips the test where one of them is not installed.
needs() {
    for tool; do
        command -v "$tool" > /dev/null || { echo "SKIPPED: $tool is not installed"; exit 77; }
    done
}

# enters FOLDER: makes a new, empty folder for what the test writes, and goes there.
enters() {
    rm -rf "$1" && mkdir "$1" && cd "$1" || exit 1
}

complain() {
    failures=$((failures + 1))
    printf 'FAILED: %s\n' "$*"
}

# alike EW_PROBE_IMAGE A B: compares two 8-bit pictures, which different rasterisers may have drawn. They may differ by 2/255 at
# most, and by more than 1/255 in at most 0.1 % of the pixels.
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
