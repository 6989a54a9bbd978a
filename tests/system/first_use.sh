#!/usr/bin/env bash
# first_use.sh FULCRUM: a learner's first use of an arm in a window: each push is asked about, by keys, and the lesson begins; the
# second time it begins at once. A learner who says all of left and right the other way round gets no force, and one sentence why.
set -euo pipefail
fulcrum=$1
# shellcheck source=tests/system/screen.sh
source "$(dirname -- "$0")/screen.sh"
need xdotool
unset XDG_CONFIG_HOME

arm=
end_arm() {
    [[ -z $arm ]] || kill "$arm" 2>/dev/null || true
    finish
}
trap end_arm EXIT
fail() {
    echo "first_use.sh: $1" >&2
    for log in "$folder"/*.log; do echo "== $log"; tail -n 15 "$log"; done >&2
    exit 1
}
# shellcheck source=tests/system/arm_port.sh
source "$(dirname -- "$0")/arm_port.sh"
mkfifo "$folder/keys"
: >"$folder/arm.log"
"$fulcrum" arm --arm desktop --port 0 <>"$folder/keys" >"$folder/arm.log" 2>&1 &
arm=$!
await_arm "$folder/arm.log"

# begin NAME LEARNER SECONDS: in the background, in $child; what it says in $said.
begin() {
    said=$folder/$1.log
    : >"$said"
    "$fulcrum" run gravity --mute --voice none --hand "udp:127.0.0.1:$port" --learner "$2" --seconds "$3" >"$said" 2>&1 &
    child=$!
}
# answer N WORDS: once so many questions have been asked.
answer() {
    local deadline=$((SECONDS + 30))
    until (($(grep -c '?$' "$said") >= $1)); do
        ((SECONDS < deadline)) || fail "question $1 was not asked"
        kill -0 "$child" 2>/dev/null || fail "it ended before question $1"
        sleep 0.05
    done
    sleep 0.2
    xdotool type --delay 40 "$2"
    xdotool key Return
}
has_focus() { xdotool search --onlyvisible --name Fulcrum windowfocus >/dev/null 2>&1; }
# A window that has lost the keys has stopped the arm: return lifts that.
await_window() {
    for _ in $(seq 100); do
        if has_focus; then
            sleep 0.5
            xdotool key Return
            return
        fi
        sleep 0.1
    done
    fail "there is no window"
}
# The arm's largest force so far, as it says it each second.
most() { sed -n 's/.*most \([0-9.]*\).*/\1/p' "$folder/arm.log" | tail -n 1; }

# Mina says what is so.
begin good Mina 60
await_window
n=0
for way in right up left away down near first second; do
    n=$((n + 1))
    answer $n "$way"
done
sleep 3
[[ $(most) == 0.8* ]] || fail "she was pushed with $(most) N, not with 0.8 N"
grep -q 'no force in this lesson' "$said" && fail "a good arm was found bad"
xdotool key Escape sleep 0.5 key Escape
wait "$child" || fail "it did not end well"
# The second time she is not asked.
begin again Mina 4
wait "$child" || fail "it did not end well the second time"
grep -q '?$' "$said" && fail "she was asked again"
grep -q 'Haptic loop:' "$said" || fail "the lesson did not begin"
# Jun says left for right and right for left, each time he is asked.
begin turned Jun 60
await_window
n=0
for way in left left up right right away down near; do
    n=$((n + 1))
    answer $n "$way"
done
for _ in $(seq 50); do
    grep -q 'no force in this lesson: .*--axes -x,y,z[.]' "$said" && break
    xdotool key Return
    sleep 0.2
done
grep -q 'no force in this lesson: .*--axes -x,y,z[.]' "$said" || fail "nothing says how the arm stands"
xdotool key Escape sleep 0.5 key Escape
wait "$child" || true
child=
echo "first_use.sh: passed"
