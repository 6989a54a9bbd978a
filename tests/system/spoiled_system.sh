#!/usr/bin/env bash
# spoiled_system.sh FULCRUM MEMORY_GONE CLOCK_SET: the memory ends while a lesson loads, plays or ends, at whatever allocation; the clock on the wall is
# set while it plays. The last two are libraries that stand before the system's. Each end is a sentence, the forces are as they were, and what was
# kept of a learner stays.
set -euo pipefail
memory_gone=$2
clock_set=$3
# shellcheck source=tests/system/home.sh
source "$(dirname -- "$0")/home.sh" "$1"

"$fulcrum" run gravity --headless --errors 0 --learner Mina >"$home/kept.log" 2>&1 || fail "the lesson was not played"
"$fulcrum" report --format csv >"$home/before.csv" 2>"$home/report.log" || fail "there is no report"
grep -q Mina "$home/before.csv" || fail "nothing was kept of Mina"

# lose_memory MOST STEP ARGUMENTS…: played again and again, each time with the memory ending later; how often it ended the play.
lose_memory() {
    local most=$1 step=$2 n code n_ends=0
    shift 2
    for ((n = 1; n < most; n += step)); do
        code=0
        LD_PRELOAD=$memory_gone MEMORY_GONE_AFTER=$n timeout 60 "$fulcrum" "$@" >"$home/memory.log" 2>&1 || code=$?
        [[ $code -eq 0 || $code -eq 2 || $code -eq 4 ]] || fail "without memory after $n allocations \"$*\" ends with code $code"
        [[ $code -ne 2 ]] || grep -q 'no memory left' "$home/memory.log" || fail "without memory after $n allocations nobody says so"
        n_ends=$((n_ends + (code == 2)))
    done
    ((n_ends >= 10)) || fail "\"$*\" lacked memory $n_ends times only"
}
lose_memory "${MEMORY_MOST:-60000}" "${MEMORY_STEP:-2897}" run gravity --headless --seconds 8 --learner Mina --record "$home/a.rec"
lose_memory 30000 "${MEMORY_STEP:-1999}" test maze-park --by mouse
"$fulcrum" report --format csv >"$home/after.csv" 2>"$home/report.log" || fail "without memory what was kept is lost"
[[ $(wc -l <"$home/after.csv") -ge $(wc -l <"$home/before.csv") ]] || fail "without memory some of what was kept is lost"

# A day and forty years, forward and back: the same rounds to the bit, and what was kept can still be told.
"$fulcrum" run gravity --headless --seconds 8 --record "$home/plain.rec" >"$home/plain.log" 2>&1 || fail "the lesson was not played"
for by in 86400 -86400 1262304000 -1262304000; do
    LD_PRELOAD=$clock_set CLOCK_SET_BY=$by "$fulcrum" run gravity --headless --seconds 8 --record "$home/set.rec" >"$home/set.log" 2>&1 ||
        fail "a clock that is set by $by s ends the lesson"
    cmp "$home/plain.rec" "$home/set.rec" || fail "a clock that is set by $by s is felt"
    LD_PRELOAD=$clock_set CLOCK_SET_BY=$by "$fulcrum" run gravity --headless --errors 0 --learner Mina >"$home/set.log" 2>&1 ||
        fail "with a clock that is set by $by s nothing is kept"
    "$fulcrum" report >"$home/set.log" 2>&1 || fail "with a clock that was set by $by s there is no report"
    grep -q Mina "$home/set.log" || fail "a clock that was set by $by s loses Mina"
done
echo "spoiled_system.sh: passed"
