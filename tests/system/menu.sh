#!/usr/bin/env bash
# menu.sh PROGRAM ROOT: points at the list of lessons in a real window, on a screen of its own. A click between the cards
# does nothing; a click on a card plays its lesson, and no other; escape goes back to the list and then leaves. The last card is the next guest,
# who is another learner than the one before.
set -euo pipefail
program=$1
root=$2
# shellcheck source=tests/system/screen.sh
source "$(dirname -- "$0")/screen.sh"
need xdotool

# until_true SECONDS COMMAND…: waits until the command succeeds.
until_true() {
    local deadline=$((SECONDS + $1))
    until "${@:2}" >/dev/null; do
        if ((SECONDS > deadline)); then
            echo "never true: ${*:2}"
            cat "$folder/said"
            exit 1
        fi
        sleep 0.1
    done
}
said() { grep -qF -- "$1" "$folder/said"; }
ended() { ! kill -0 "$child" 2>/dev/null; }
# Cards are 360 wide and 20 apart, three and two in a row, in a window of 1280 x 720 with four lessons; the fifth is a guest's.
click_at() { xdotool mousemove "$1" "$2" sleep 0.2 click 1; }

# The first escape stops the arm, the second leaves.
leave_lesson() { xdotool key Escape Escape; }
leaves() { xdotool key Escape && sleep 0.3 && ended; }
# Leaving a lesson takes a moment, in which a click means nothing: the hand clicks again.
plays() { "${@:2}" && said "playing $1"; }

# From whatever card is chosen to the second one; another one that a late key started is left again.
start_second() {
    local n_played n_before
    n_before=$(grep -c '^playing' "$folder/said")
    xdotool key Left Left Left Left sleep 0.5 key Right sleep 0.5 key Return sleep 0.5
    n_played=$(grep -c '^playing' "$folder/said")
    if ((n_played > n_before)) && ! said "playing three"; then leave_lesson; fi
}

# A place of its own, with four lessons that say who they are.
mkdir -p "$folder/assets" "$folder/scripts"
cp "$program" "$folder/fulcrum"
cp -r "$root/assets/words" "$folder/assets/words"
cp -r "$root/scripts/lib" "$folder/scripts/lib"
for name in one three two zero; do
    mkdir -p "$folder/scenarios/$name"
    printf '%s\n' "local L = lesson { id = \"$name\", title = \"$name\", level = \"A1\", minutes = 1 }" \
        "function L:start(world) print(\"playing $name\") end" 'return L' >"$folder/scenarios/$name/lesson.lua"
done

"$folder/fulcrum" >"$folder/said" 2>&1 &
child=$!
until_true 30 xdotool search --name '^Fulcrum$'
sleep 1

click_at 450 200 # between the first card and the second
click_at 640 20  # the headline
sleep 1
! said playing || { echo "a click beside the cards started a lesson"; exit 1; }

until_true 20 plays two click_at 1020 200 # the third card
leave_lesson
until_true 20 plays one click_at 260 200 # the first card
leave_lesson
sleep 1
xdotool type Mina # in the list: who is playing
until_true 20 plays three start_second
! said "playing zero" || { echo "another lesson was started"; exit 1; }

leave_lesson
sleep 1
played_one() { (($(grep -c '^playing one' "$folder/said") == 2)); }
next_guest_plays() { click_at 830 440 && xdotool sleep 0.3 key Left Left Left Left sleep 0.3 key Return sleep 0.5 && played_one; }
until_true 20 next_guest_plays
leave_lesson
until_true 20 leaves
wait "$child" || { echo "exit code $?"; cat "$folder/said"; exit 1; }
child=
"$folder/fulcrum" report --lesson one | grep -qx 'Guests (2)' || { echo "one was not played by two guests"; exit 1; }
"$folder/fulcrum" report | grep -qx 'Guests (2)' || { echo "a guest of two lessons was not one learner"; exit 1; }
"$folder/fulcrum" report --lesson three | grep -qx Mina || { echo "three was not kept for Mina"; exit 1; }
