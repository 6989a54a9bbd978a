# shellcheck shell=bash
# arm_home.sh FULCRUM, read by the tests that start the arm's side: $fulcrum, a $home of its own that goes at the end with all that $arms
# names, `fail`, which ends the test with a sentence and the last lines of its logs, and await_arm of arm_port.sh.
fulcrum=$1
home=$(mktemp -d)
export HOME=$home XDG_CONFIG_HOME=$home/config
unset DISPLAY
arms=()
cleanup() {
    for arm in "${arms[@]}"; do kill "$arm" 2>/dev/null || true; done
    wait 2>/dev/null || true
    rm -rf "$home"
}
trap cleanup EXIT

fail() {
    echo "$(basename -- "$0"): $1" >&2
    for log in "$home"/*.log; do echo "== $log"; tail -n 12 "$log"; done >&2
    exit 1
}
# shellcheck source=tests/system/arm_port.sh
source "$(dirname -- "$0")/arm_port.sh"
