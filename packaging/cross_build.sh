#!/usr/bin/env bash
# cross_build.sh arm64: builds the program for arm64 (a Raspberry Pi 5) on a PC, and runs it there by qemu's user emulation: the unit tests
# of haptics/math and dialogue, and the lesson gravity without a window. It needs root; a Debian 12 of its own in build/cross has
# compiler, libraries and emulator, and nothing else of this machine changes but build/. What is there already is not made again.
# Ends with 0 where all went well, with 1 where something did not, with 77 where it could not be: "not run: reason".
set -euo pipefail
root=$(cd -- "$(dirname -- "$(readlink -f -- "$0")")/.." && pwd)
# shellcheck source=packaging/bare_debian.sh
. "$root/packaging/bare_debian.sh"
[[ $* == arm64 ]] || { echo "fulcrum: cross_build.sh builds for arm64 alone; start it as $0 arm64, not with '$*'" >&2; exit 2; }
[[ $(uname -m) == x86_64 ]] || not_run "it compiles on a PC (amd64) for another machine; on this one, $(uname -m), start ./fulcrum"
need_bare_debian

kept=$root/build/cross bare=$root/build/cross/debian log=$root/build/cross/cross.log
build=build/arm64 # in the source's folder, which is seen as /fulcrum
mkdir -p "$kept" "$root/$build"
exec {lock}>"$kept/lock"
flock -n "$lock" || not_run "another start of it is at work"
: >"$log"
shown=("$root" /fulcrum)

# step WORDS COMMAND…: says how long it took; what the command says is in the log.
step() {
    local words=$1 begun=$SECONDS status=0
    shift
    "$@" >>"$log" 2>&1 || status=$?
    echo "  $words: $( ((status == 0)) || echo "FAILED after ")$((SECONDS - begun)) s"
    return "$status"
}
fail() {
    tail -n 15 "$log" >&2
    echo "fulcrum: $*; the whole of what was said is in $log" >&2
    exit 1
}
# here COMMAND…: in this checkout, as it is seen inside.
here() { inside env -C /fulcrum HOME=/root CCACHE_DIR=/fulcrum/build/cross/ccache "$@"; }

# ---- the Debian ------------------------------------------------------------------------------------------------------

if [[ ! -f $kept/unpacked ]]; then
    rm -rf --one-file-system -- "$bare"
    mkdir "$bare"
    unpack_bare_debian
    # Another architecture's packages beside its own; and a power failure costs no more than another start.
    inside dpkg --add-architecture arm64
    echo force-unsafe-io >"$bare/etc/dpkg/dpkg.cfg.d/unsafe-io"
    touch "$kept/unpacked"
fi

# named_in LIST: its packages.
named_in() { sed -n 's/^\([^# ][^ ]*\) .*/\1/p' "$@"; }
# wanted: those of packages.txt, libraries for arm64; tools are this machine's, and what is the same for all is there once.
wanted() {
    local same name names
    mapfile -t names < <(named_in "$root/packages.txt")
    same=" $(inside apt-cache show --no-all-versions "${names[@]}" |
        awk '$1 == "Package:" { name = $2 } $1 == "Architecture:" && $2 == "all" { printf "%s ", name }') cmake ninja-build ccache pkg-config "
    sed '1,/^# In that Debian/d' "$root/packages-cross.txt" | named_in
    for name in "${names[@]}"; do
        [[ $name != g++ ]] || continue # it compiles for this machine
        [[ $same == *" $name "* ]] && echo "$name" || echo "$name:arm64"
    done
}
lists() { cat "$root/packages.txt" "$root/packages-cross.txt"; }
if ! cmp -s <(lists) "$kept/packages"; then
    # shellcheck disable=SC2086 # several words
    step "the lists of packages" inside $apt update --error-on=any || not_run "the lists of packages could not be fetched: $(grep -m 1 -E '^[EW]:' "$log")"
    mapfile -t packages < <(wanted)
    inside dpkg --configure -a >>"$log" 2>&1 # where an earlier start was cut off
    # shellcheck disable=SC2086
    step "compiler, emulator and libraries" inside $apt install --no-install-recommends "${packages[@]}" ||
        not_run "packages could not be installed: $(grep -m 1 '^E:' "$log")"
    lists >"$kept/packages"
fi

# ---- the build -------------------------------------------------------------------------------------------------------

step "configured" here cmake --preset arm64 || fail "CMake could not configure the build"
step "built" here cmake --build "$build" -j "${FULCRUM_JOBS:-$(nproc)}" --target fulcrum_program tests_haptics_math tests_dialogue ||
    fail "the build for arm64 failed"

# ---- the trial -------------------------------------------------------------------------------------------------------

# show PATTERN: those parts of what the last one said.
show() { grep -aoE "$1" "$kept/said.log" | sed 's/^/    /' || true; }
# tests_of ROOM
tests_of() {
    claim "the unit tests of $1, on emulated arm64" here ctest --test-dir "$build" -L "^$1(/|\$)" -j "$(nproc)" --output-on-failure --no-tests=error
    show '^[0-9]+% tests passed.*|^Total Test time.*|[0-9]+ - .*\((Skipped|Not Run|Disabled)\)'
}
tests_of haptics/math
tests_of dialogue

# What the emulator lacks is in emulated.c, which nothing but this loads.
emulated=/fulcrum/build/cross/emulated.so
step "the library for the emulator" here aarch64-linux-gnu-gcc -O2 -Wall -Wextra -Werror -shared -fPIC packaging/emulated.c -o "$emulated" ||
    fail "emulated.c could not be compiled"
# program ARGUMENT…: what it says goes through a pipe, for the lesson's process may write to no file.
program() { here qemu-aarch64-static -E "LD_PRELOAD=$emulated" "$build/fulcrum" "$@" 2>&1 | cat; }
claim "gravity's own test is passed" program test gravity
show 'gravity: passed .*'

# The filter of system calls lets through what sandbox.cpp names, where nothing is sanitized; behind it the lesson asked for these.
allowed() {
    sed -n '/^void allow_plain_mmap/,/^\/\/ ---- the other walls/p' "$root/runtime/lua/sandbox/sandbox.cpp" |
        sed '/if (kSanitized)/,/^    }/d' | grep -oE 'SYS_[a-z_]+' | sed 's/^SYS_//' | LC_ALL=C sort -u
}
asked() {
    awk '/^[0-9]+ seccomp\(/ { behind[$1] = 1; next } behind[$1] { sub(/\(.*/, "", $2); print $2 }' "$kept/said.log" | LC_ALL=C sort -u
}
asked >"$kept/asked"
allowed >"$kept/allowed"
lesson_keeps_to_the_filter() {
    grep -qx read "$kept/asked" && grep -qx sendto "$kept/asked" && ! LC_ALL=C comm -23 "$kept/asked" "$kept/allowed" | grep .
}
claim "the lesson's process asked for no system call that its filter forbids: $(paste -sd ' ' "$kept/asked")" lesson_keeps_to_the_filter
leave_out "the filter itself and the limit of a lesson's memory" "the emulator has neither; the calls were compared by name, not by arguments"

# What this machine's own program recorded is repeated.
on_this_machine() { HOME=$kept "$root/build/dev/fulcrum" "$@"; }
repeat() {
    on_this_machine run "$1" --headless --seconds 12 --record "$kept/$1.rec" &&
        program run "$1" --headless --hand "replay:build/cross/$1.rec" | tee "$kept/repeated" &&
        grep -aq 'bit for bit, in 12000 rounds[.]$' "$kept/repeated"
}
if listed=$(on_this_machine list 2>>"$log"); then
    mapfile -t lessons < <(awk '{ print $1 }' <<<"$listed")
    for lesson in "${lessons[@]}"; do
        claim "$lesson: 12 s of it on this machine are repeated, each force the same to the bit" repeat "$lesson"
        show 'All forces .*'
    done
else
    leave_out "whether forces are those of x86-64" "this machine's own program is not built; start ./fulcrum list"
fi

((failed == 0)) || { echo "fulcrum: the program for arm64 failed on emulated arm64; all that was said is in $log" >&2; exit 1; }
echo "passed but for $left_out not run: $root/$build/fulcrum is for arm64; $(du -sh --apparent-size "$bare" | cut -f 1) of Debian are kept in $kept."
