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
# count PATTERN: how many lines of what it says.
count() { grep -c -- "$1" "$said" || true; }
# await WHAT COMMAND…: until it is so, while the program runs; 60 s at most.
await() {
    local what=$1 deadline=$((SECONDS + 60))
    shift
    until "$@"; do
        ((SECONDS < deadline)) || fail "$what: never"
        kill -0 "$child" 2>/dev/null || fail "$what: it ended before"
        sleep 0.05
    done
}
has_focus() { xdotool search --onlyvisible --name Fulcrum windowfocus >/dev/null 2>&1; }
is_asked() { (($(count '?$') >= $1)); }
is_answered() { (($(count '^  ') >= $1)); }
# A window that has lost the keys has stopped the arm: return lifts that, and does nothing else while nothing is asked.
lift() { has_focus && xdotool key Return && sleep 0.2 && is_asked 1; }
# answer N KEYS…: once so many questions have been asked; again where a stop took the keys.
answer() {
    local n=$1
    shift
    await "question $n" is_asked "$n"
    give() {
        xdotool key --delay 30 "$@" Return
        local i
        for i in $(seq 40); do
            is_answered "$n" && return
            sleep 0.05
        done
        xdotool key --delay 10 BackSpace BackSpace BackSpace BackSpace BackSpace BackSpace
        return 1
    }
    await "an answer to question $n" give "$@"
}
# The arm's largest force so far, as it says it each second.
most() { sed -n 's/.*most \([0-9.]*\).*/\1/p' "$folder/arm.log" | tail -n 1; }

# Mina says what is so: typed, and the last one chosen.
begin good Mina 200
await "a first question" lift
n=0
for way in "r i g h t" "u p" "l e f t" "a w a y" "d o w n" "n e a r" "f i r s t"; do
    n=$((n + 1))
    # shellcheck disable=SC2086
    answer $n $way
done
answer 8 Down Down
grep -q '^  the second$' "$said" || fail "a choice is not one in words"
begun() { grep -q 'Haptic loop:' "$said" || [[ $(xdotool search --onlyvisible --name Fulcrum) ]]; }
await "the lesson" begun
[[ $(most) == 0.8* ]] || fail "she was pushed with $(most) N, not with 0.8 N"
grep -q 'no force in this lesson' "$said" && fail "a good arm was found bad"
kill -INT "$child"
code=0
wait "$child" || code=$?
[[ $code -eq 130 ]] || fail "it ended with code $code, not 130"
# The second time she is not asked.
begin again Mina 1
wait "$child" || fail "it did not end well the second time"
grep -q '?$' "$said" && fail "she was asked again"
grep -q 'Haptic loop:' "$said" || fail "the lesson did not begin"
# Jun feels nothing, and says so once more: there is no force then, and the window says why until he has read it.
begin unfelt Jun 200
await "a first question" lift
answer 1 Up
answer 2 Up
[[ $(count '^  I feel nothing$') == 2 ]] || fail "the last choice is not that nothing is felt"
is_told() { xdotool key Return && sleep 0.2 && grep -q 'no force in this lesson: its pushes were not felt' "$said"; }
await "a sentence on what was not felt" is_told
kill -INT "$child"
wait "$child" || true
child=
echo "first_use.sh: passed"
