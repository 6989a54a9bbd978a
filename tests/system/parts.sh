#!/usr/bin/env bash
# parts.sh ROOT [BUILD [PART…]]: a build can go without each part of cmake/dependencies.cmake. Where a part's vendors are not installed, it is
# set up without the part and cannot be with it; and nothing that it would compile or link is the vendors'. With BUILD, a folder that is
# made, each part (or those named) is left out there in turn, the program is built, and plays; so do its tests.
set -euo pipefail
root=$(realpath "$1") build=${2:-} only=("${@:3}")
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
fail() {
    echo "parts.sh: $*" >&2
    exit 1
}

# A part's vendors, as pkg-config and CMake look for them, and what build.ninja has of them.
declare -A modules=([SOUND]=openal [HID]=hidapi-hidraw [SPEECH]=pocketsphinx)
declare -A packages=()
declare -A traces=([SOUND]='libopenal|/audio/openal/' [HID]='libhidapi|/hid/hidapi/' [SPEECH]='pocketsphinx|sphinxbase|speech/sphinx/[^p]')
parts=$(sed -nE 's/^fulcrum_part\(FULCRUM_([A-Z]+) .*/\1/p' "$root/cmake/dependencies.cmake")
for part in $parts; do
    [[ -n ${traces[$part]:-} ]] || fail "it does not know what $part leaves out"
done

# A pkg-config of a system without these modules.
without() {
    printf '#!/bin/sh\nfor word; do case $word in %s*) exit 1;; esac; done\nexec %s "$@"\n' \
        "$(sed 's/ /*|/g' <<<"${modules[$1]:-none}")" "$(command -v pkg-config)" >"$folder/pkg-config"
    chmod +x "$folder/pkg-config"
}

set_up() { # PART ON|OFF
    local options=() package
    without "$1"
    for package in ${packages[$1]:-}; do
        options+=("-DCMAKE_DISABLE_FIND_PACKAGE_$package=ON")
    done
    rm -rf "$folder/build"
    cmake -S "$root" -B "$folder/build" -G Ninja -DPKG_CONFIG_EXECUTABLE="$folder/pkg-config" "-DFULCRUM_$1=$2" -DFULCRUM_JOIN=OFF \
        -DFULCRUM_TESTS=OFF "${options[@]}" >"$folder/log" 2>&1
}

for part in $parts; do
    if set_up "$part" ON; then
        fail "it is set up with $part where its vendors are not installed"
    fi
    set_up "$part" OFF || { cat "$folder/log" >&2 && fail "without $part it cannot be set up"; }
    if trace=$(grep -m 1 -oE "[^ ]*(${traces[$part]})[^ ]*" "$folder/build/build.ninja"); then
        fail "without $part this is compiled or linked all the same: $trace"
    fi
done
[[ -n $build ]] || exit 0

((${#only[@]} > 0)) || mapfile -t only <<<"$parts"
for part in "${only[@]}"; do
    options=()
    for other in $parts; do
        options+=("-DFULCRUM_$other=$([[ $other == "$part" ]] && echo OFF || echo ON)")
    done
    cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo "${options[@]}" >"$folder/log" 2>&1 ||
        { cat "$folder/log" >&2 && fail "without $part it cannot be set up"; }
    ninja -C "$build" >"$folder/log" 2>&1 || { tail -n 20 "$folder/log" >&2 && fail "without $part it cannot be built"; }
    (cd "$build" && ctest -L 'unit|lessons|system' -E 'is set up without each part' --output-on-failure) || fail "without $part tests fail"
    echo "without $part: built, and all of its tests pass"
done
