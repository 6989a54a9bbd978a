#!/usr/bin/env bash
# faults.sh FULCRUM: what surrounds a run goes wrong, and the forces are as they were: a lesson that makes much garbage, a full disk under the
# record and under what is kept of a learner, a disk that is slow; what is kept is taken away while somebody plays.
set -euo pipefail
# shellcheck source=tests/system/home.sh
source "$(dirname -- "$0")/home.sh" "$1"

# A spring that follows, and in every frame three thousand tables that nobody keeps, or none: every round of the record is the same to the bit.
mkdir "$home/tidy" "$home/litter"
lesson() {
    cat <<LUA
local L = lesson { id = "litter", title = "Litter", level = "A1", minutes = 1 }
local now_s = 0
function L:start(world)
  world:spring { at = { 0.02, 0, 0 }, stiffness = 100, damping = 1 }
end
function L:update(world, dt)
  now_s = now_s + dt
  local last
  for i = 1, $1 do last = { i, tostring(i), { last } } if i % 50 == 0 then last = nil end end
end
L:test {}
return L
LUA
}
lesson 0 >"$home/tidy/lesson.lua"
lesson 3000 >"$home/litter/lesson.lua"
for kind in tidy litter; do
    "$fulcrum" run "$home/$kind" --headless --seconds 10 --record "$home/$kind.rec" >"$home/$kind.log" 2>&1 || fail "the lesson $kind was not played"
done
for kind in tidy litter; do
    "$fulcrum" export "$home/$kind.rec" --out "$home/$kind.csv" >"$home/$kind.log" 2>&1 || fail "the record of $kind cannot be told"
done
[[ $(wc -l <"$home/tidy.csv") -gt 9000 ]] || fail "the record tells too few rounds"
cmp "$home/tidy.csv" "$home/litter.csv" || fail "what a lesson leaves to its garbage collector is felt"

# The record's disk is full after 500 kB: the lesson is played to its end, and one sentence says so.
code=0
(
    ulimit -f 500
    trap '' XFSZ
    exec "$fulcrum" run gravity --headless --record "$home/full.rec"
) >"$home/full.log" 2>&1 || code=$?
[[ $code -eq 2 ]] || fail "a record that is cut off ends with code $code, not 2"
[[ $(grep -c 'the record cannot be written' "$home/full.log") -eq 1 ]] || fail "a full disk is not told once"

# What is kept of a learner: played once, then on a disk that takes no more. What was kept stays.
"$fulcrum" run gravity --headless --errors 0 --learner Mina >"$home/kept.log" 2>&1 || fail "the lesson was not played"
"$fulcrum" report --format csv >"$home/before.csv" 2>"$home/report.log" || fail "there is no report"
grep -q Mina "$home/before.csv" || fail "nothing was kept of Mina"
(
    ulimit -f 40
    trap '' XFSZ
    exec "$fulcrum" run gravity --headless --errors 0 --learner Mina
) >"$home/unkept.log" 2>&1 && code=0 || code=$?
[[ $code -eq 4 ]] || fail "a lesson whose end was not kept ends with code $code, not 4"
expect "$home/unkept.log" '^gravity: finished' "a full disk keeps the lesson from its end"
[[ $(grep -c 'the disk refused to read or write' "$home/unkept.log") -eq 1 ]] || fail "nobody says once that nothing is kept"
"$fulcrum" report --format csv >"$home/after.csv" 2>"$home/report.log" || fail "after a full disk there is no report"
# No attempt, answer or star fewer than before: the report's lines only grow.
[[ $(wc -l <"$home/after.csv") -ge $(wc -l <"$home/before.csv") ]] && grep -q Mina "$home/after.csv" || fail "what was kept before the disk was full is lost"

# What is kept is taken away, or another file put in its place, while somebody plays: told once, and what was kept before is whole where it is.
kept=$XDG_DATA_HOME/fulcrum/progress.db
for how in gone replaced; do
    "$fulcrum" run gravity --headless --real-time --errors 0 --learner Mina --seconds 4 --record "$home/$how.rec" >"$home/$how.log" 2>&1 &
    player=$!
    # Some rounds long: the lesson has begun.
    until [[ $(stat -c %s "$home/$how.rec" 2>/dev/null || echo 0) -gt 50000 ]]; do kill -0 "$player" || fail "the lesson was not played"; sleep 0.05; done
    mv "$kept" "$home/away.db"
    [[ $how == gone ]] || echo "another file" >"$kept"
    code=0
    wait "$player" || code=$?
    [[ $code -eq 4 ]] || fail "a lesson whose database is $how ends with code $code, not 4"
    [[ $(grep -c 'the database was removed or replaced' "$home/$how.log") -eq 1 ]] || fail "a database that is $how is not told once"
    mv "$home/away.db" "$kept"
    "$fulcrum" report --format csv 2>"$home/report.log" | grep -q Mina || fail "what was kept is lost with a database that is $how"
done

# A disk that takes nothing for two seconds: a pipe whose reader waits. Under a virtual clock it is played all the same, and the record is whole.
mkfifo "$home/slow"
{ exec 3<"$home/slow"; sleep 2; cat <&3 >"$home/slow.rec"; } &
reader=$!
"$fulcrum" run "$home/tidy" --headless --seconds 10 --record "$home/slow" >"$home/slow.log" 2>&1 || fail "a slow disk ends the lesson"
wait "$reader"
cmp "$home/tidy.rec" "$home/slow.rec" || fail "a slow disk changes the record"
echo "faults.sh: passed"
