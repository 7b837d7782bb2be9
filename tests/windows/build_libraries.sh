#!/bin/sh
# Builds for Windows, from Debian's sources, the libraries that Debian has only for itself: cmocka, Jansson and GLFW. stb
# needs no building. Does nothing if they are there. Nothing is left in apt's own lists of packages.
# Usage: build_libraries.sh FOLDER
set -eu
toolchain=$(cd "$(dirname "$0")/../../cmake" && pwd)/mingw-w64.cmake
mkdir -p "$1"
cd "$1"
[ ! -e complete ] || exit 0
prefix=$PWD

# apt with a list of its own, of sources.
own_apt_get() {
    apt-get -q -o Dir::Etc::SourceList="$prefix/sources.list" -o Dir::Etc::SourceParts=/dev/null \
        -o Dir::State::Lists="$prefix/lists" -o Dir::Cache::pkgcache= -o Dir::Cache::srcpkgcache= "$@"
}

# builds PACKAGE CMAKE_OPTION...
builds() {
    package=$1
    shift
    rm -rf "$package" "$package-build"
    mkdir "$package" &&
        tar -xf "$(find . -name "${package}_*.orig.tar.?z")" -C "$package" --strip-components 1 &&
        cmake -S "$package" -B "$package-build" -DCMAKE_TOOLCHAIN_FILE="$toolchain" -DCMAKE_FIND_ROOT_PATH="$prefix" \
            -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$prefix" "$@" &&
        cmake --build "$package-build" --parallel "$(nproc)" &&
        cmake --install "$package-build"
}

. /etc/os-release
echo "deb-src http://deb.debian.org/debian $VERSION_CODENAME main" > sources.list
mkdir -p lists/partial
own_apt_get update
own_apt_get source --download-only cmocka jansson glfw3
{
    builds cmocka -DWITH_EXAMPLES=OFF &&
        builds jansson -DJANSSON_BUILD_DOCS=OFF -DJANSSON_WITHOUT_TESTS=ON -DJANSSON_EXAMPLES=OFF &&
        builds glfw3 -DGLFW_BUILD_EXAMPLES=OFF -DGLFW_BUILD_TESTS=OFF -DGLFW_BUILD_DOCS=OFF
} > log 2>&1 || { cat log; exit 1; }
cp -r /usr/include/stb include
touch complete
