#!/usr/bin/env bash
# launcher.sh: plays ./fulcrum in a scratch checkout, in a folder with a blank and Korean letters, where the tools it calls (dpkg-query,
# apt-get, sudo, cmake, ninja, ctest) are short scripts that write down what they were asked.
set -euo pipefail
launcher=$(cd -- "$(dirname -- "$0")/../.." && pwd)/fulcrum
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
tree="$scratch/새 교실 checkout"
calls=$scratch/calls
installed=$scratch/installed
failed=0

# tool NAME: its body comes on standard input; $calls and $installed are known to it.
tool() {
    { printf '#!/bin/bash\ncalls=%q installed=%q scratch=%q\n' "$calls" "$installed" "$scratch" && cat; } >"$scratch/bin/$1"
    chmod +x "$scratch/bin/$1"
}

mkdir -p "$scratch/bin" "$tree"/{cmake,haptics,dialogue,runtime,assets,packaging,tests}
cp "$launcher" "$tree/fulcrum"
printf 'alpha   # the first reason\nbeta    # the second reason\nbet     # its name begins another\n' >"$tree/packages.txt"
printf 'gamma # for tests\n' >"$tree/packages-test.txt"
touch "$tree"/{CMakeLists.txt,CMakePresets.json,runtime/app.cpp}
tool dpkg-query <<'EOT'
shift 3
for name; do grep -qxF "$name" "$installed" && printf '%s:installed ' "$name"; done
EOT
tool apt-get <<'EOT'
echo "apt-get $*" >>"$calls"
[[ ! -e $scratch/no_network ]] || { echo "E: Temporary failure resolving 'a.mirror'" >&2; exit 100; }
[[ ! -e $scratch/no_package ]] || { echo "E: Unable to locate package" >&2; exit 100; }
if [[ " $* " == *" install "* ]]; then
    for name; do printf '%s\n' "$name" >>"$installed"; done
fi
EOT
tool sudo <<'EOT'
echo "sudo $*" >>"$calls"
[[ ! -e $scratch/no_sudo ]] || exit 1
while [[ $1 == -* ]]; do shift; done
"$@"
EOT
tool cmake <<'EOT'
[[ $1 != --version ]] || { echo "cmake version 3.18.4"; exit; }
echo "cmake $*" >>"$calls"
if [[ -e $scratch/cmake_says ]]; then
    cat "$scratch/cmake_says"
    exit 1
fi
mkdir -p "build/$2" && echo "rules" >"build/$2/build.ninja" && echo "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" >"build/$2/CMakeCache.txt"
EOT
tool ninja <<'EOT'
if [[ $3 == -t ]]; then
    printf 'app.o: #deps 2, deps mtime 1 (VALID)\n    %s\n    ../../runtime/app.cpp\n' "$scratch/a system header.h"
    exit
fi
echo "ninja $*" >>"$calls"
[[ ! -e $scratch/busy ]] || { echo "two builds at once" >>"$calls"; }
touch "$scratch/busy"; sleep 0.2; rm "$scratch/busy"
echo "[1/2] Building CXX object app.o"
if [[ -e $scratch/slow && $* == *" all" ]]; then
    touch "$scratch/tests_begun"
    while [[ -e $scratch/slow ]]; do sleep 0.02; done
fi
if [[ -e $scratch/endless ]]; then
    touch "$scratch/begun"
    exec sleep 60
fi
if [[ -e $scratch/ninja_says ]]; then
    cat "$scratch/ninja_says"
    exit 1
fi
if [[ -e $2/damaged ]]; then
    echo 'ld: app.o: file not recognized: file truncated'
    exit 1
fi
if [[ -e $scratch/broken ]]; then
    printf 'FAILED: app.o\ng++ -Werror app.cpp\napp.cpp:3:1: error: the first mistake\napp.cpp:9:1: error: the second\n'
    exit 1
fi
printf '#!/bin/bash\nprintf "<%%s>" program "$@"\nexit 7\n' >"$2/fulcrum" && chmod +x "$2/fulcrum"
printf '#!/bin/bash\nprintf "<%%s>" benchmarks "$@"\nexit 6\n' >"$2/fulcrum-bench" && chmod +x "$2/fulcrum-bench"
EOT
tool ctest <<'EOT'
printf '<%s>' ctest "$@"
exit 8
EOT
export PATH=$scratch/bin:$PATH

# start ARG…: runs the launcher; leaves status, out, err, and what was called meanwhile.
start() {
    : >"$calls"
    status=0
    out=$("${at:-$tree/fulcrum}" "$@" 2>"$scratch/err" </dev/null) || status=$?
    err=$(<"$scratch/err")
    called=$(<"$calls")
}

# expect WHAT CONDITION…: the condition is a test of its own words.
expect() {
    local claim=$1
    shift
    # shellcheck disable=SC2053 # the second is a pattern
    if ! [[ $1 == $2 ]]; then
        printf '%s\n  got      %s\n  expected %s\n  said %s\n  called %s\n' "$claim" "$1" "$2" "$err" "$called"
        failed=1
    fi
}

# Nothing can be installed: one sentence, with what to type; nothing is built.
: >"$installed"
touch "$scratch/no_package" "$scratch/no_sudo"
touch "$scratch/a system header.h"
start run gravity
expect "without packages: status" "$status" 2
expect "without packages: the command to type" "$err" "*type: apt-get update && apt-get install -y --no-install-recommends alpha beta bet"
expect "without packages: nothing is built" "$called" '!(*ninja*)'
rm "$scratch/no_package" "$scratch/no_sudo"
touch "$scratch/no_network"
start run gravity
expect "without a network: status" "$status" 2
expect "without a network: one sentence behind what is needed" "${err##*$'\n'}" "fulcrum: there is no network, so packages are missing; connect it and start again: alpha beta bet"
expect "without a network: nothing is built" "$called" '!(*ninja*)'
rm "$scratch/no_network"

# Only what is missing is installed, after its reason was said.
echo beta >"$installed"
start run gravity "two words"
expect "missing packages: reasons" "$err" '*alpha   # the first reason*bet     # its name*'
expect "missing packages: those that are there are left" "$err" '!(*second reason*)'
expect "missing packages: installed" "$called" '*install --no-install-recommends alpha bet*'
expect "the first start: configured" "$called" '*cmake --preset dev*'
expect "the first start: builds the program and what it reads" "$called" '*ninja * fulcrum_program'
expect "the program gets its arguments, and standard output is its own" "$out" '<program><run><gravity><two words>'
expect "the program's status is the launcher's" "$status" 7

# A second start asks nobody, through a link and from another folder.
ln -s "$tree/fulcrum" "$scratch/link"
cd "$scratch"
at=$scratch/link start
expect "the second start: calls nothing" "$called" ''
expect "the second start: says nothing" "$err" ''
expect "the second start: runs" "$out" '<program>'

# What changed decides what is done.
sleep 0.02
touch -d '2001-01-01' "$tree/runtime/app.cpp"
start
expect "a changed source, though dated long ago: built" "$called" 'ninja*'
touch "$tree/CMakePresets.json"
start
expect "changed presets: configured" "$called" 'cmake*ninja*'
echo 'delta # new' >>"$tree/packages.txt"
start
expect "a new package: installed" "$called" '*install*delta*'
touch "$tree/haptics/new.cpp" && touch "$scratch/broken"
start run gravity
expect "a broken build: status" "$status" 2
expect "a broken build: the first error, then one sentence" "$err" '*the first mistake*fulcrum: the build failed;*'
expect "a broken build: the compiler's command is not shown" "$err" '!(*g++ -Werror*)'
expect "a broken build: nothing runs" "$out" ''
rm "$scratch/broken"
start
expect "a mended build: built again" "$called" 'ninja*'

# What goes wrong in a build is one sentence, and nothing is lost.
# says WHAT PATTERN: of the last start, whose build failed: that it said so in one sentence, that nothing ran, and that what was
# there is there.
says() {
    expect "$1: status" "$status" 2
    expect "$1: one sentence" "$(grep -vE '…$|^  step' <<<"$err")" "fulcrum: $2"
    expect "$1: nothing runs" "$out" ''
    expect "$1: the program is still there" "$(compgen -G "$tree/build/dev/fulcrum")" '*fulcrum'
}
touch "$tree/haptics/newer.cpp"
echo 'as: app.o: No space left on device' >"$scratch/ninja_says"
start
says "a full disk" 'the disk is full at */build; make room there*start again*'
echo 'g++: fatal error: Killed signal terminated program cc1plus' >"$scratch/ninja_says"
start
says "a full memory" 'the memory is full; *FULCRUM_JOBS=1*'
rm "$scratch/ninja_says"
echo 'No CMAKE_CXX_COMPILER could be found.' >"$scratch/cmake_says"
touch "$tree/CMakePresets.json"
start
says "no compiler" 'there is no C++ compiler that works; install g++*'
echo 'cmake_minimum_required(VERSION 3.25)' >"$tree/CMakeLists.txt"
echo 'CMake 3.25 or higher is required.  You are running version 3.18.4' >"$scratch/cmake_says"
start
says "an old CMake" 'cmake version 3.18.4 is too old; *3.25 or newer*'
rm "$scratch/cmake_says"
start
expect "mended: configured, built and run" "$called$out" 'cmake*ninja*<program>'

# Where nothing can be written, what is up to date runs, and what is not is one sentence.
as_nobody=()
[[ $EUID -ne 0 ]] || as_nobody=(setpriv --reuid 65534 --regid 65534 --clear-groups)
chmod a+rwx "$scratch" && chmod a+w "$calls" && chmod a-w "$tree" "$tree"/build "$tree/build/dev"
start_as_nobody() {
    : >"$calls"
    status=0
    out=$("${as_nobody[@]}" "$tree/fulcrum" 2>"$scratch/err" </dev/null) || status=$?
    err=$(<"$scratch/err")
    called=$(<"$calls")
}
start_as_nobody
expect "a read-only checkout that is up to date: runs" "$out" '<program>'
expect "a read-only checkout that is up to date: says nothing" "$err" ''
sleep 0.02 && touch "$tree/haptics/newer.cpp"
start_as_nobody
says "a read-only checkout" '*/build cannot be written to (Permission denied); copy the whole folder*'
chmod u+w "$tree" "$tree"/build "$tree/build/dev"

# A build that was cut off: by Ctrl-C, by a power failure, in the middle of configuring.
touch "$scratch/endless" "$tree/haptics/newer.cpp"
set -m # a group of its own, as at a terminal
"$tree/fulcrum" >/dev/null 2>"$scratch/err" &
waiting=$!
set +m
until [[ -e $scratch/begun ]]; do sleep 0.01; done
kill -INT -- "-$waiting"
status=0
wait "$waiting" || status=$?
err=$(<"$scratch/err")
expect "Ctrl-C: status" "$status" 130
expect "Ctrl-C: one sentence" "$(grep -vE '…$|^  step' <<<"$err")" 'Stopped; what is built stays, and the next start goes on from there.'
rm "$scratch/endless"
start
expect "Ctrl-C: the next start builds on" "$called" 'ninja*'
expect "Ctrl-C: the next start does not begin anew" "$called" '!(*cmake*)'
touch "$tree/haptics/newer.cpp"
touch "$tree/build/dev/damaged"
start
expect "damaged files: built anew" "$called" 'ninja*cmake*ninja*'
expect "damaged files: runs" "$out" '<program>'
rm "$tree/build/dev/build.ninja"
touch "$tree/haptics/newer.cpp"
start
expect "configured by half: configured" "$called" 'cmake*ninja*'
rm "$tree/build/dev/fulcrum"
start
expect "a program that is not there: built" "$called$out" 'ninja*<program>'

# Packages that come and go are asked after, and build nothing of what does not read them.
sleep 0.02
sed "s|^installed_packages=.*|installed_packages=$scratch/status|" "$launcher" >"$tree/fulcrum"
touch "$scratch/status"
start
expect "another package: nothing is built" "$called" ''
expect "another package: runs" "$out" '<program>'
start bench
sleep 0.02 && touch "$scratch/status"
start bench
expect "another package: benchmarks look for libraries again" "$called" 'cmake --preset release*ninja*fulcrum_bench'
sleep 0.02 && touch "$scratch/a system header.h" && touch "$scratch/status"
start
expect "another version of what was read: built" "$called" 'cmake*ninja*'

# Two at once.
touch "$tree/haptics/newest.cpp"
: >"$calls"
"$tree/fulcrum" >/dev/null 2>&1 &
first=$!
"$tree/fulcrum" >/dev/null 2>&1 || true
wait "$first" || true
called=$(<"$calls")
expect "two starts at once: one build" "$called" 'ninja*([!
])'

# The checkout was moved.
mv "$tree" "$scratch/moved here" && tree="$scratch/moved here"
start
expect "a moved checkout: configured and built" "$called" 'cmake*ninja*'

# The emergency stop waits for nothing, whatever has changed or is missing.
touch "$tree/haptics/very_newest.cpp"
echo 'zeta # not there' >>"$tree/packages.txt"
start stop
expect "stop: no package is asked for, nothing is built" "$called" ''
expect "stop: the program stops" "$out" '<program><stop>'
expect "stop: the program's status" "$status" 7
# Without a program that can be run too; here under another name, or what else runs would be stopped.
sed 's/fulcrum-hand/fulcrum-tried/' "$tree/fulcrum" >"$tree/stopper" && chmod +x "$tree/stopper"
rm "$tree/build/dev/fulcrum"
mkdir "$scratch/ours" "$scratch/theirs"
cp "$BASH" "$scratch/ours/fulcrum"
cp "$BASH" "$scratch/theirs/other"
# hand PROGRAM AT_SIGNAL: starts one under the name of a hand, and waits for that name.
hand() {
    "$1" -c "trap '$2' USR1; printf fulcrum-tried >/proc/\$\$/comm; until ((SECONDS > 60)); do sleep 0.05; done" 2>/dev/null &
    until [[ $(<"/proc/$!/comm") == fulcrum-tried ]]; do sleep 0.01; done
}
hand "$scratch/ours/fulcrum" 'printf fulcrum-tried!1 >/proc/$$/comm; sleep 1; exit 9'
good=$!
hand "$scratch/ours/fulcrum" 'exit 9'
ended=$!
hand "$scratch/ours/fulcrum" ':'
silent=$!
hand "$scratch/theirs/other" 'exit 9'
other=$!
at=$tree/stopper start stop
expect "stop without a program: who gave its word or ended" "$out" 'Stopped: 2.'
expect "stop without a program: who gave none" "$err" "*processes $silent were told*switch the arm off."
expect "stop without a program: no success" "$status" 1
expect "stop without a program: nothing is built" "$called" ''
kill -0 "$other" || expect "stop without a program: a stranger" gone here
{ kill -KILL "$silent" "$other" && wait "$silent" "$other"; } 2>/dev/null || true
for process in "$good" "$ended"; do
    code=0
    wait "$process" 2>/dev/null || code=$?
    expect "stop without a program: the signal" "$code" 9
done
wait 2>/dev/null || true

# Where nobody can see what runs.
sed "s|^processes=.*|processes=$scratch/nothing|" "$tree/stopper" >"$tree/blind" && chmod +x "$tree/blind"
at=$tree/blind start stop
expect "stop that sees nothing: no success" "$status" 1
expect "stop that sees nothing: what to do" "$err" '*switch the arm off.'
expect "stop that sees nothing: nothing is said to be stopped" "$out" ''

# Tests.
start test -L unit
expect "test: all targets" "$called" '*ninja * all'
expect "test: installs what tests need" "$called" '*install*gamma*'
expect "test: to ctest" "$out" '<ctest><--test-dir><*/moved here/build/dev><-j><[0-9]*><*<-L><unit>'
expect "test: ctest's status" "$status" 8
start test gravity
expect "test LESSON: to the program" "$out" '<program><test><gravity>'

# Whose own program is up to date waits for nobody, nor for what another start builds beside it.
touch "$tree/haptics/newest.cpp" "$scratch/slow"
"$tree/fulcrum" test >/dev/null 2>&1 &
tests=$!
until [[ -e $scratch/tests_begun ]]; do sleep 0.01; done
start
expect "tests are built: a start waits for nothing" "$err" ''
expect "tests are built: a start runs" "$out" '<program>'
touch "$tree/runtime/app.cpp"
(sleep 1.5 && rm "$scratch/slow") &
start
expect "tests are built and the program is old: waits, then builds" "$err" '*waiting for it*Built in*'
wait "$tests" || true

# Benchmarks.
printf 'epsilon # a peer\n' >"$tree/packages-peers.txt"
start bench wall --quick
expect "bench: without asserts" "$called" 'cmake --preset release*ninja -C */build/release * fulcrum_bench'
expect "bench: peers are not installed unasked" "$called" '!(*epsilon*)'
expect "bench: its arguments" "$out" '<benchmarks><wall><--quick>'
expect "bench: its status" "$status" 6
FULCRUM_PACKAGES=packages-peers.txt start bench
expect "bench: peers on request" "$called" '*install*epsilon*'

# The package.
printf 'eta # packs\n' >"$tree/packages-package.txt"
printf '#!/bin/bash\nprintf "<%%s>" packed "$@"\nexit 5\n' >"$tree/packaging/package.sh" && chmod +x "$tree/packaging/package.sh"
start package --try
expect "package: installs what packing needs" "$called" '*install*eta*'
expect "package: of the build that is tested" "$called" '*ninja -C */build/dev * fulcrum_package'
expect "package: packed, with its arguments" "$out" '<packed><*/build/dev><--try>'
expect "package: its status" "$status" 5

FULCRUM_PRESET=asan start run
expect "another preset: configured" "$called" 'cmake --preset asan*ninja -C */build/asan *'
exit "$failed"
