#!/bin/sh
# Builds for another system, from Debian's sources, libraries that Debian has only for itself: cmocka, glfw3 and jansson. stb
# needs no building. Does nothing if they are there. Nothing is left in apt's own lists of packages.
# Usage: build_libraries.sh FOLDER TOOLCHAIN PACKAGE...; the toolchain is a file for CMake, by its full path
set -eu
folder=$1 toolchain=$2
shift 2
mkdir -p "$folder"
cd "$folder"
[ ! -e complete ] || exit 0
prefix=$PWD

# apt with a list of its own, of sources.
own_apt_get() {
    apt-get -q -o Dir::Etc::SourceList="$prefix/sources.list" -o Dir::Etc::SourceParts=/dev/null \
        -o Dir::State::Lists="$prefix/lists" -o Dir::Cache::pkgcache= -o Dir::Cache::srcpkgcache= "$@"
}

options_of() {
    case $1 in
    cmocka) echo -DWITH_EXAMPLES=OFF ;;
    glfw3) echo -DGLFW_BUILD_EXAMPLES=OFF -DGLFW_BUILD_TESTS=OFF -DGLFW_BUILD_DOCS=OFF ;;
    jansson) echo -DJANSSON_BUILD_DOCS=OFF -DJANSSON_WITHOUT_TESTS=ON -DJANSSON_EXAMPLES=OFF ;;
    esac
}

builds() {
    package=$1
    rm -rf "$package" "$package-build"
    # shellcheck disable=SC2046 # the options are several words
    mkdir "$package" &&
        tar -xf "$(find . -name "${package}_*.orig.tar.?z")" -C "$package" --strip-components 1 &&
        cmake -S "$package" -B "$package-build" -DCMAKE_TOOLCHAIN_FILE="$toolchain" -DCMAKE_FIND_ROOT_PATH="$prefix" \
            -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$prefix" $(options_of "$package") &&
        cmake --build "$package-build" --parallel "$(nproc)" &&
        cmake --install "$package-build"
}

. /etc/os-release
echo "deb-src http://deb.debian.org/debian $VERSION_CODENAME main" > sources.list
mkdir -p lists/partial
own_apt_get update
own_apt_get source --download-only "$@"
for package; do
    builds "$package" > log 2>&1 || { cat log; exit 1; }
done
cp -r /usr/include/stb include
touch complete
