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

# concludes: the last command of a test.
concludes() {
    printf '%d failures\n' $failures
    [ $failures -eq 0 ]
}
