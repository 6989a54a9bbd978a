#!/usr/bin/env bash
# own_arm.sh FULCRUM DHD HD HAPLY: an arm at this computer that a run starts: its process is killed, stands still, and ends with the run, however that
# ends; what cannot be served is refused in its own words. DHD and HD stand in for makers' libraries, HAPLY for a service.
set -euo pipefail
# shellcheck source=tests/system/home.sh
source "$(dirname -- "$0")/home.sh" "$1"
# arm_of PROCESS: the arm that it has started.
arm_of() { pgrep -P "$1" -f 'arm --attached' || true; }
# await_another PROCESS ARM: until it has an arm that is not this one, and that has begun.
await_another() {
    for _ in $(seq 200); do
        found=$(arm_of "$1")
        [[ -n $found && $found != "$2" ]] && sleep 1 && return
        sleep 0.1
    done
    fail "the arm's process was not started again"
}
# ends PROCESS: within five seconds.
ends() {
    for _ in $(seq 50); do
        kill -0 "$1" 2>/dev/null || return 0
        sleep 0.1
    done
    fail "the arm's process outlives its run"
}
play() { exec "$fulcrum" run gravity --headless --first-use never --hand simulated --seconds 60 >"$home/$1.log" 2>&1; }

play first &
player=$!
started+=("$player")
await_another "$player" none
arm=$found
kill -KILL "$arm"
await_another "$player" "$arm"
arm=$found
kill -STOP "$arm"
await_another "$player" "$arm"
arm=$found
kill -TERM "$player"
wait "$player" || true
ends "$arm"
expect "$home/first.log" "The simulated arm has gone: its program is started again." "its end is not told"
expect "$home/first.log" "The simulated arm does not answer: its program is started again." "its silence is not told"
expect "$home/first.log" "The simulated arm is back." "its return is not told"

play second &
player=$!
started+=("$player")
await_another "$player" none
kill -KILL "$player"
wait "$player" 2>/dev/null || true
ends "$found"
# The key cannot be read.
mkdir "$home/no.key"
"$fulcrum" run gravity --headless --hand simulated --key "$home/no.key" >"$home/refused.log" 2>&1 && fail "an arm without a key is played with"
expect "$home/refused.log" "The simulated arm: " "why there is no arm is not told"
# By a maker's library or service, and without.
by() { "$fulcrum" run gravity --headless --first-use never --seconds 2 --hand "$@" >"$home/maker.log" 2>&1; }
by_arm() {
    by "$@" || { cat "$home/maker.log"; fail "the lesson was not played with --hand $1"; }
    expect "$home/maker.log" "The arm's link: round trip [0-9.]+ ms" "$1: it was not played over the link"
}
by_arm fd --library "$2"
by_arm touch --library "$3"
coproc service { exec "$4"; }
started+=("$service_PID")
read -r -t 20 -u "${service[0]}" port
by_arm haply --service-port "$port"
by fd --library "$home/none.so" && fail "a library that is not there is played with"
expect "$home/maker.log" "Force Dimension's arm: " "why there is no arm is not told"
by touch --library "$home/none.so" && fail "a library that is not there is played with"
expect "$home/maker.log" "The Touch: " "why there is no arm is not told"
