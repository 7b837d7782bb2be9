# The C++ compilers that are there, and the standards that hosts use. CXX_COMPILERS may name others. Source this.
# shellcheck shell=sh

# for_each_cxx COMMAND ARGUMENT...: runs COMMAND COMPILER STANDARD ARGUMENT... for each pair, until one fails.
for_each_cxx() {
    command=$1
    shift
    for cxx in ${CXX_COMPILERS-g++ clang++}; do
        command -v "$cxx" > /dev/null || continue
        for standard in c++11 c++14 c++17 c++20; do
            "$command" "$cxx" $standard "$@" || return
        done
    done
}
