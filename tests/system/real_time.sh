#!/usr/bin/env bash
# real_time.sh FULCRUM: runs whose loops keep real time are recorded and repeated, every force the same to the bit: of a world, a kite, a lever,
# rigid bodies, and of an arm in another process. A record that does not tell what the loops were told says so.
set -euo pipefail
# shellcheck source=tests/system/home.sh
source "$(dirname -- "$0")/home.sh" "$1"
# repeat NAME LESSON: the record NAME.rec gives every force again.
repeat() {
    "$fulcrum" run "$2" --headless --hand "replay:$home/$1.rec" >"$home/$1.again.log" 2>&1 ||
        fail "the run of $1 is not repeated"
    grep -qE '^All forces are the record.s, bit for bit, in [0-9]{4} rounds[.] The run kept real time' "$home/$1.again.log" ||
        fail "the run of $1 is not repeated to the bit"
}

for lesson in gravity kite stacks textures; do
    "$fulcrum" run "$lesson" --headless --real-time --seconds 4 --record "$home/$lesson.rec" >"$home/$lesson.log" 2>&1 ||
        fail "$lesson was not played in real time"
    grep -q '[(]1 times real time[)]' "$home/$lesson.log" || fail "$lesson did not take its time"
    repeat "$lesson" "$lesson"
done

# A player at a desk has no real time to keep.
code=0
"$fulcrum" run gravity --headless --real-time --by mouse >"$home/desk.log" 2>&1 || code=$?
[[ $code -eq 2 ]] && grep -q -- '--real-time is not for a simulated player' "$home/desk.log" || fail "a player at a desk is let play in real time"

# A tool has so much time and no more: what it left out is not in a record, and is told for what it is.
"$fulcrum" run lever --headless --real-time --seconds 4 --record "$home/lever.rec" >"$home/lever.log" 2>&1 ||
    fail "lever was not played in real time"
code=0
"$fulcrum" run lever --headless --hand "replay:$home/lever.rec" >"$home/lever.again.log" 2>&1 || code=$?
if [[ $code -ne 0 ]]; then
    grep -qE 'The tool had [0-9.]+ us of each step then and ended its search by the clock' "$home/lever.again.log" ||
        fail "it is not said why the tool's forces are others"
fi

# Through a link, whose line loses packets.
start_arm arm --motion circle --loss 3 --burst 5 --jitter 1 --seed 7
"$fulcrum" run gravity --headless --first-use never --hand "udp:127.0.0.1:$port" --seconds 4 --record "$home/link.rec" \
    >"$home/link.log" 2>&1 || fail "the lesson was not played over the link"
repeat link gravity
