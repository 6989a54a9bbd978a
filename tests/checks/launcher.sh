#!/usr/bin/env bash
# launcher.sh: plays ./fulcrum in a scratch checkout, in a folder with a space, where the tools it calls (dpkg-query,
# apt-get, sudo, cmake, ninja, ctest) are short scripts that write down what they were asked.
set -euo pipefail
launcher=$(cd -- "$(dirname -- "$0")/../.." && pwd)/fulcrum
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
tree="$scratch/a checkout"
calls=$scratch/calls
installed=$scratch/installed
failed=0

# tool NAME: its body comes on standard input; $calls and $installed are known to it.
tool() {
    { printf '#!/bin/bash\ncalls=%q installed=%q scratch=%q\n' "$calls" "$installed" "$scratch" && cat; } >"$scratch/bin/$1"
    chmod +x "$scratch/bin/$1"
}

mkdir -p "$scratch/bin" "$tree"/{cmake,haptics,dialogue,runtime,assets,tests}
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
[[ ! -e $scratch/no_network ]] || { echo "E: no network" >&2; exit 100; }
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
echo "cmake $*" >>"$calls"
mkdir -p "build/$2" && echo "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" >"build/$2/CMakeCache.txt"
EOT
tool ninja <<'EOT'
echo "ninja $*" >>"$calls"
[[ ! -e $scratch/busy ]] || { echo "two builds at once" >>"$calls"; }
touch "$scratch/busy"; sleep 0.2; rm "$scratch/busy"
echo "[1/2] Building CXX object app.o"
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
touch "$scratch/no_network" "$scratch/no_sudo"
start run gravity
expect "without packages: status" "$status" 2
expect "without packages: the command to type" "$err" "*type: apt-get update && apt-get install -y --no-install-recommends alpha beta bet"
expect "without packages: nothing is built" "$called" '!(*ninja*)'
rm "$scratch/no_network" "$scratch/no_sudo"

# Only what is missing is installed, after its reason was said.
echo beta >"$installed"
start run gravity "two words"
expect "missing packages: reasons" "$err" '*alpha   # the first reason*bet     # its name*'
expect "missing packages: those that are there are left" "$err" '!(*second reason*)'
expect "missing packages: installed" "$called" '*install --no-install-recommends alpha bet*'
expect "the first start: configured" "$called" '*cmake --preset dev*'
expect "the first start: builds the program and what it reads" "$called" '*ninja * fulcrum fulcrum_assets*'
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

# Two at once.
touch "$tree/haptics/newer.cpp"
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
touch "$tree/haptics/newest.cpp"
echo 'zeta # not there' >>"$tree/packages.txt"
start stop
expect "stop: no package is asked for, nothing is built" "$called" ''
expect "stop: the program stops" "$out" '<program><stop>'
expect "stop: the program's status" "$status" 7
# Without a program that can be run too; here under another name, or what else runs would be stopped.
sed 's/fulcrum-hand/fulcrum-tried/' "$tree/fulcrum" >"$tree/stopper" && chmod +x "$tree/stopper"
rm "$tree/build/dev/fulcrum"
cp "$(command -v sleep)" "$scratch/fulcrum-tried"
"$scratch/fulcrum-tried" 60 &
hand=$!
until [[ $(<"/proc/$hand/comm") == fulcrum-tried ]]; do sleep 0.01; done
at=$tree/stopper start stop
expect "stop without a program: who was told" "$out" 'Stopped: 1.'
expect "stop without a program: nothing is built" "$called" ''
code=0
wait "$hand" 2>/dev/null || code=$?
expect "stop without a program: the signal" "$code" $((128 + $(kill -l USR1)))

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

# Benchmarks.
printf 'epsilon # a peer\n' >"$tree/packages-peers.txt"
start bench wall --quick
expect "bench: without asserts" "$called" 'cmake --preset release*ninja -C */build/release * fulcrum_bench'
expect "bench: peers are not installed unasked" "$called" '!(*epsilon*)'
expect "bench: its arguments" "$out" '<benchmarks><wall><--quick>'
expect "bench: its status" "$status" 6
FULCRUM_PACKAGES=packages-peers.txt start bench
expect "bench: peers on request" "$called" '*install*epsilon*'

FULCRUM_PRESET=asan start run
expect "another preset: configured" "$called" 'cmake --preset asan*ninja -C */build/asan *'
exit "$failed"
