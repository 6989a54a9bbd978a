#!/usr/bin/env bash
# window.sh PROGRAM: plays in a real window on a screen of its own. A lesson that is broken, then hangs, then is mended:
# the window stays up, each failure is one sentence, and the mended lesson runs again. Says how soon.
set -euo pipefail
program=$1
# shellcheck source=tests/system/screen.sh
source "$(dirname -- "$0")/screen.sh"

lesson() { printf '%s\n' 'local L = lesson { id = "x", title = "X", level = "A1", minutes = 1 }' "$@" 'return L' >"$folder/x/new" &&
    mv "$folder/x/new" "$folder/x/lesson.lua"; }

mkdir "$folder/x"
: >"$folder/said"
lesson 'function L:start(world' 'end'
"$program" run "$folder/x" --mute --seconds 12 --screenshot "$folder/picture.png" >"$folder/said" 2>&1 &
child=$!
wait_for "lesson.lua:3:" 30

sleep 1.1 # a file's time of change has a resolution
lesson 'function L:update(world, dt)' '  while true do end' 'end'

wait_for "lesson.lua:3: this ran for too long" 10
kill -0 "$child"

sleep 1.1
mended=$(date +%s%N)
lesson 'function L:start(world) print("mended") end'
wait_for "mended" 10
echo "ran again $((($(date +%s%N) - mended) / 1000000)) ms after it was mended"

wait "$child" || { echo "exit code $?"; cat "$folder/said"; exit 1; }
child=
grep -q "Haptic loop:" "$folder/said"
[[ $(head -c 4 "$folder/picture.png" | tail -c 3) == PNG ]]

# A lesson that is left has not failed: its record tells the one fault and not the other. Nor has one whose process was kept from running
# for a while.
lesson 'function L:update(world, dt) print("plays") end'
"$program" run "$folder/x" --mute --seconds 5 --record "$folder/left.rec" >>"$folder/said" 2>&1 &
child=$!
wait_for plays
lesson_process=$(pgrep -P "$child" | head -n 1)
kill -STOP "$lesson_process"
sleep 2
: >"$folder/said"
kill -CONT "$lesson_process"
wait_for plays 3
wait "$child" || { echo "a lesson that was halted for a while ended with $?"; cat "$folder/said"; exit 1; }
child=
grep -aq "run ended" "$folder/left.rec" || { echo "a lesson that was left has no end in its record"; exit 1; }
! grep -aq "lesson failed" "$folder/left.rec" || { echo "a lesson that was left counts as failed"; exit 1; }

# One that nobody mends has its time too.
lesson 'function L:start(world' 'end'
timeout 60 "$program" run "$folder/x" --mute --seconds 1 >"$folder/said" 2>&1 || code=$?
[[ ${code:-0} != 124 ]] || { echo "a lesson that cannot begin never ends"; exit 1; }
grep -q "lesson.lua:3:" "$folder/said"

# A screen that goes while somebody plays: the force is let go as by a stop, of which the process gives its word, and one sentence says why
# it ends.
lesson 'function L:update(world, dt) print("plays") end'
: >"$folder/said"
"$program" run "$folder/x" --mute --seconds 30 >>"$folder/said" 2>&1 &
child=$!
wait_for plays
kill "$server"
word=
while name=$(cat "/proc/$child/comm" 2>/dev/null) && [[ -n $name ]]; do
    [[ $name != *'!1' ]] || word=given
    sleep 0.01
done
code=0
wait "$child" || code=$?
child=
[[ $code -eq 1 && $(grep -vc '^plays$' "$folder/said") -eq 1 ]] && grep -q '^The screen is gone' "$folder/said" ||
    { echo "without a screen it ended with $code"; grep -v '^plays$' "$folder/said"; exit 1; }
[[ $word == given ]] || { echo "without a screen the force was not let go"; exit 1; }
