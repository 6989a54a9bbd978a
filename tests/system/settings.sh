#!/usr/bin/env bash
# settings.sh PROGRAM ROOT: the settings in a real window. They are opened by the gear, from the list and from a lesson, and by F4, and closed
# again; a lesson stands still meanwhile and goes on afterwards; what was chosen is kept with a learner over a restart, and with no guest.
set -euo pipefail
program=$1
root=$2
# shellcheck source=tests/system/screen.sh
source "$(dirname -- "$0")/screen.sh"
need xdotool sqlite3

fail() { echo "settings: $*"; cat "$folder/said"; exit 1; }
# kept: what the database has of settings, one a line.
kept() { sqlite3 "$folder/kept.db" 'SELECT name || "=" || value FROM hand_setting ORDER BY row'; }
# keeps TEXT: waits until that is all.
keeps() {
    local deadline=$((SECONDS + 30))
    until [[ $(kept 2>/dev/null) == "$1" ]]; do
        ((SECONDS <= deadline)) || fail "kept is not \"$1\" but \"$(kept)\""
        sleep 0.2
    done
}
export LC_ALL=C # no language is the usual one but English
start() {
    : >"$folder/said"
    "$folder/fulcrum" "$@" --db "$folder/kept.db" >>"$folder/said" 2>&1 &
    child=$!
    local deadline=$((SECONDS + 30))
    until xdotool search --name '^Fulcrum$' >/dev/null; do
        ((SECONDS <= deadline)) || fail "no window"
        sleep 0.1
    done
    sleep 1
}
ends() {
    wait "$child" || fail "ended with $?"
    child=
}
mkdir -p "$folder/assets" "$folder/scripts" "$folder/scenarios/one"
cp "$program" "$folder/fulcrum"
cp -r "$root/assets/words" "$folder/assets/words"
cp -r "$root/scripts/lib" "$folder/scripts/lib"
cat >"$folder/scenarios/one/lesson.lua" <<'LUA'
local L = lesson { id = "one", title = "Lesson one", level = "A1", minutes = 1 }
local passed
function L:start(world)
  world:hand { centre = { 0, 0.3, 0 } }
end
function L:update(world, dt)
  if not passed then passed = 0; print "playing" end
  passed = passed + dt
end
function L:key(name) print(("key %s at %.0f"):format(name, passed)) end
return L
LUA
: >"$folder/said"

# From the list, by the gear; the third card is the words' size. Escape leads back to the list, where return starts the lesson.
start menu --learner Mina
xdotool mousemove 1234 46 sleep 0.3 click 1 sleep 0.8
xdotool mousemove 2 2 sleep 0.2 key Right Right sleep 0.3 key Return sleep 0.3 key Escape
keeps text=large
# From the lesson by F4: it stands still. The fourth card is the contrast, the sixth the hand, the seventh the language; F4 leads back.
xdotool sleep 0.5 key Return
wait_for playing
xdotool sleep 1 key q sleep 0.5 key F4 sleep 0.8
xdotool key q sleep 4 key Right Right Right sleep 0.3 key Return sleep 0.3 key Right Right sleep 0.3 key Return sleep 0.3 key Right sleep 0.3 key Return sleep 0.3 key F4 sleep 0.8 key q
keeps $'text=large\ncontrast=high\nhanded=left\nlanguage=es'
wait_for 'key q at'
sleep 0.5
mapfile -t at < <(sed -n 's/^key q at //p' "$folder/said")
[[ ${#at[@]} == 2 ]] || fail "q was heard ${#at[@]} times, not before and after the settings alone"
((at[1] - at[0] <= 3)) || fail "the lesson went on while the settings were open: ${at[*]}"
xdotool key Escape sleep 0.5 key Escape sleep 1 key Escape
ends

# Kept over a restart: what comes after high contrast is the usual one.
start run one --learner Mina
wait_for playing
xdotool sleep 1 key F4 sleep 1 key Right Right Right sleep 0.3 key Return sleep 0.5 key F4 sleep 0.5 key Escape sleep 0.5 key Escape
ends
all=$'text=large\ncontrast=high\nhanded=left\nlanguage=es\ncontrast=usual'
keeps "$all"
# The command line goes before it, and its card is not there: the last card is the way back.
start run one --learner Mina --handed right --mute --language en
wait_for playing
xdotool sleep 1 key F4 sleep 1 key Right Right Right sleep 0.3 key Return sleep 1 key q
wait_for 'key q at'
all+=$'\nhanded=right'
keeps "$all"
xdotool key Escape sleep 0.5 key Escape
ends
# A guest's are kept nowhere; here the gear of the lesson opens them.
start run one
wait_for playing
xdotool sleep 1 mousemove 1048 46 sleep 0.3 click 1 sleep 1 key q sleep 0.3 mousemove 640 2 key Right Right Right sleep 0.3 key Return sleep 0.5 key F4 sleep 0.8 key q
wait_for 'key q at'
[[ $(grep -c 'key q at' "$folder/said") == 1 ]] || fail "the gear did not open the settings"
xdotool sleep 0.5 key Escape sleep 0.5 key Escape
ends
keeps "$all"
echo "opened by gear and F4, kept with a learner, with no guest"
