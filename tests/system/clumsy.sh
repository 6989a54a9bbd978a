#!/usr/bin/env bash
# clumsy.sh FULCRUM [all]: a mouse in a young hand, late, trembling, straying and slipping, plays in a real window, each event by way of the
# screen: from the room into the first lesson and to a felt weight in at most a minute, reading nothing. With all, every lesson is
# played so to its end (half an hour).
set -euo pipefail
fulcrum=$1
# shellcheck source=tests/system/screen.sh
source "$(dirname -- "$0")/screen.sh"
need xdotool
said=$folder/said
mkfifo "$folder/deeds"

# play LESSON SECONDS OPTIONS…: by a clumsy mouse, until it is left.
play() {
    local lesson=$1 seconds=$2
    shift 2
    xdotool - <"$folder/deeds" >"$folder/xdotool.log" 2>&1 &
    local player=$!
    "$fulcrum" run "$lesson" --mute --by clumsy --seed 1 --deeds "$folder/deeds" --seconds "$seconds" --db "$folder/kept.db" "$@" >"$said" 2>&1 ||
        { echo "$lesson ends with code $?"; cat "$said" "$folder/xdotool.log"; exit 1; }
    wait "$player" 2>/dev/null || true
}

# What this child wants: the apple on its stand, and then to be under whatever falls.
cat >"$folder/child.lua" <<'LUA'
local motion = require "motion"

local function find(world, is_it)
  for _, body in ipairs(world:bodies()) do
    if is_it(body) then return body end
  end
end

return motion.play(function(world)
  local apple = find(world, function(body) return body.name == "apple_here" end)
  if apple then
    motion.move_to({ apple.x, apple.y + 0.06, apple.z }, 1)
    while true do
      motion.press(1)
      motion.wait(0.5)
      motion.press(0)
      motion.wait(1)
    end
  end
  while true do
    local falling
    motion.wait_until(function()
      falling = find(world, function(body) return body.where == "falling" end)
      return falling
    end)
    motion.follow(falling, { seconds = 5, y = 0.3, z = 0, until_ = function() return falling.where ~= "falling" end })
  end
end)
LUA
# The lesson's record is the last. What the room took is what is left of the whole time.
begun=${EPOCHREALTIME/[.,]/}
play science-room 30 --hand "$folder/child.lua" --record "$folder/run.rec"
room=$((${EPOCHREALTIME/[.,]/} - begun - 30000000))
"$fulcrum" export "$folder/run.rec" --out "$folder/run.csv" >/dev/null
awk -F, -v room="$room" 'NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; if (!("weight_force_y_N" in at)) { print "no lesson with weights was entered"; exit 1 }; next }
    $at["applied_force_y_N"] < -0.3 && $at["weight_force_y_N"] < -0.3 { felt = $at["time_s"]; exit }
    END { printf "%.1f s for program and room, and %.1f s in the lesson until a weight is felt\n", room / 1e6, felt; exit !(felt && felt + room / 1e6 < 60) }' \
    "$folder/run.csv" || { cat "$said"; exit 1; }

[[ ${2:-} == all ]] || exit 0
for lesson in gravity textures solar-system kite lever stacks maze-park; do
    begun=$SECONDS
    play "$lesson" 900 --learner Kim
    "$fulcrum" report --db "$folder/kept.db" --format csv |
        awk -F, -v lesson="$lesson" 'NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i } $at["lesson"] == lesson && $at["finished"] > 0 { ended = 1 } END { exit !ended }' ||
        { echo "$lesson did not come to its end"; cat "$said"; exit 1; }
    echo "$lesson: to its end in $((SECONDS - begun)) s; $(tail -n 1 "$said")"
done
