# shellcheck shell=bash
# home.sh FULCRUM, read by tests of the program that have no window: $fulcrum, a $home of its own that goes at the end with all that
# $started names, `fail`, which ends the test with a sentence and the last lines of its logs, and arms to be played with.
fulcrum=$1
home=$(mktemp -d)
export HOME=$home XDG_CONFIG_HOME=$home/config XDG_DATA_HOME=$home/data XDG_CACHE_HOME=$home/cache
unset DISPLAY WAYLAND_DISPLAY
started=()
cleanup() {
    for process in "${started[@]}"; do kill "$process" 2>/dev/null || true; done
    wait 2>/dev/null || true
    rm -rf "$home"
}
trap cleanup EXIT

fail() {
    echo "$(basename -- "$0"): $1" >&2
    for log in "$home"/*.log; do echo "== $log"; tail -n 12 "$log"; done >&2
    exit 1
}
# expect FILE PATTERN WHY, and refuse: it stands there, or does not.
expect() { grep -qE "$2" "$1" || fail "$3"; }
refuse() { ! grep -qE "$2" "$1" || fail "$3"; }
# shellcheck source=tests/system/arm_port.sh
source "$(dirname -- "$0")/arm_port.sh"
# start_arm NAME OPTIONS…: in the background; its port in $port, its process in $arm.
start_arm() {
    local name=$1
    shift
    # Its keyboard is a pipe that stays open: an end of input would be heard. What it says is looked at before it has said anything.
    mkfifo "$home/$name.keys"
    : >"$home/$name.log"
    "$fulcrum" arm --port 0 "$@" <>"$home/$name.keys" >"$home/$name.log" 2>&1 &
    arm=$!
    started+=("$arm")
    await_arm "$home/$name.log"
}
