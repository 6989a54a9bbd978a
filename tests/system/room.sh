#!/usr/bin/env bash
# room.sh PROGRAM ROOT: lessons are entered from a room in a real window, by mouse and by keys, and whoever leaves one is in the room again; its
# door leads to the list of all. What the room knows is the learner's, and nothing of it is kept. fulcrum menu has the list at once.
set -euo pipefail
program=$1
root=$2
# shellcheck source=tests/system/screen.sh
source "$(dirname -- "$0")/screen.sh"
need xdotool

fail() { echo "room: $*"; cat "$folder/said"; exit 1; }
# says TEXT: waits until the program has.
says() {
    local deadline=$((SECONDS + 30))
    until grep -qF -- "$1" "$folder/said"; do
        ((SECONDS <= deadline)) || fail "never said: $1"
        sleep 0.1
    done
    : >"$folder/said"
}
window() {
    local deadline=$((SECONDS + 30))
    until xdotool search --name '^Fulcrum$' >/dev/null; do
        ((SECONDS <= deadline)) || fail "no window"
        sleep 0.1
    done
}

mkdir -p "$folder/assets" "$folder/scripts" "$folder"/scenarios/{one,two,room}
cp "$program" "$folder/fulcrum"
cp -r "$root/assets/words" "$folder/assets/words"
cp -r "$root/scripts/lib" "$folder/scripts/lib"
for name in one two; do
    printf '%s\n' "local L = lesson { id = \"$name\", title = \"Lesson $name\", level = \"A1\", minutes = 1 }" \
        "function L:start(world) print(\"playing $name\") end" \
        "function L:key(name) if name == \"space\" then here:finish { stars = 2 } end end" \
        "function L:update(world) here = world end" 'return L' >"$folder/scenarios/$name/lesson.lua"
done
cat >"$folder/scenarios/room/lesson.lua" <<'LUA'
local L = lesson { id = "room", title = "Room" }
local here, was
function L:start(world)
  world:room()
  world:hand { centre = { 0, 0.3, 0 } }
end
function L:update(world)
  if not here then
    here = world
    local text = "in the room:"
    for _, known in ipairs(world.lessons) do text = text .. (" %s %s %d"):format(known.name, known.title, known.stars) end
    print(text)
  end
  if world:tool().pressed and not was then world:enter "one" end
  was = world:tool().pressed
end
function L:key(name)
  if name == "return" then here:enter "two" elseif name == "space" then here:enter "" end
end
return L
LUA
: >"$folder/said"

"$folder/fulcrum" --learner Mina --mute --db "$folder/kept.db" >>"$folder/said" 2>&1 &
child=$!
window
says 'in the room: one Lesson one -1 two Lesson two -1'
# By mouse, however quick the click. At the end the next lesson that was not played can be chosen by keys.
xdotool mousemove 640 400 sleep 0.3 click 1
says 'playing one'
xdotool key space sleep 1 key Down sleep 0.3 key Return
says 'playing two'
xdotool key Escape sleep 0.5 key Escape
says 'in the room: one Lesson one 2 two Lesson two -1'
# And by a click: the second of three choices, below the first. Where all were played there are two, of which the second leads back.
xdotool mousemove 640 400 sleep 0.3 click 1
says 'playing one'
xdotool key space
wait_for_pixel 300 676 ffffff # of its paper
xdotool mousemove 450 676 sleep 0.3 click 1
says 'playing two'
xdotool key space sleep 1 key Down sleep 0.3 key Return
says 'in the room: one Lesson one 2 two Lesson two 2'
# By keys.
xdotool key Return
says 'playing two'
xdotool key Escape sleep 0.5 key Escape
says 'in the room: one Lesson one 2 two Lesson two 2'
# Behind the door is the list; Escape there leads back, and so does a lesson that was chosen there.
xdotool key space sleep 1 key Escape
says 'in the room:'
xdotool mousemove 2 2 key space sleep 1 key Return
says 'playing one'
xdotool key Escape sleep 0.5 key Escape
says 'in the room:'
# Who leaves the room leaves.
xdotool key Escape sleep 0.5 key Escape
wait "$child" || fail "ended with $?"
child=

# The plays are kept, none of the room.
kept=$("$folder/fulcrum" report --db "$folder/kept.db" --format csv)
grep -q one <<<"$kept" || fail "the lesson is not kept: $kept"
! grep -q room <<<"$kept" || fail "the room is kept: $kept"

# The list at once.
"$folder/fulcrum" menu --learner Mina --mute --db "$folder/kept.db" >>"$folder/said" 2>&1 &
child=$!
window
sleep 1
! grep -q 'in the room' "$folder/said" || fail "a room, not the list"
xdotool key Return
says 'playing one'
xdotool key Escape sleep 0.5 key Escape sleep 1 key Escape
wait "$child" || fail "ended with $?"
child=
echo "entered by mouse, keys and door, and left again"
