#!/usr/bin/env bash
# pause.sh FULCRUM: a lesson played by mouse in a window stands still, with all that falls in it, from a click on the pause's button until
# the next, and goes on from where it was; P does the same, and so does looking elsewhere.
set -euo pipefail
fulcrum=$1
# shellcheck source=tests/system/screen.sh
source "$(dirname -- "$0")/screen.sh"
need xdotool

mkdir "$folder/x"
cat >"$folder/x/lesson.lua" <<'END'
local L = lesson { id = "x", title = "X", level = "A1", minutes = 5 }
local ball, t = nil, 0
function L:start(world)
  world:gravity(0.02)
  ball = world:body { name = "ball", model = "sphere", noun = "ball", mass = 0.1, movable = true, at = { 0, 2, 0 }, radius = 0.05 }
end

function L:update(world, dt)
  if t == 0 then ball:drop { at = { 0, 2, 0 } } end
  t = t + dt
  print(string.format("frame %.4f %.4f %.6f", t, dt, ball.y))
end
return L
END
said=$folder/said
: >"$said"
"$fulcrum" run "$folder/x" --mute --seconds 60 >"$said" 2>&1 &
child=$!
wait_for frame 30
wait_for_pixel 1100 46 00427a   # of the button's sign: what is not seen yet is not clicked
focus() { xdotool search --onlyvisible --name Fulcrum windowfocus; }
until focus >/dev/null 2>&1; do sleep 0.1; done
frames() { grep -c '^frame' "$said" || true; }
# The button is the last but the score in the upper right corner (at 1280 x 720).
click() { xdotool mousemove 1106 46 sleep 0.1 mousedown 1 sleep 0.1 mouseup 1; }
p() { focus && xdotool key p; }
away() { xdotool windowunmap --sync "$(xdotool search --onlyvisible --name Fulcrum)"; }
back() { xdotool windowmap --sync "$(xdotool search --name Fulcrum | tail -n 1)" && focus && sleep 0.3 && xdotool key Return; }

# stands_still HOW GOES_ON: no frame comes for a second and a half behind HOW; frames come again behind GOES_ON.
stands_still() {
    local before between
    xdotool mousemove 640 400 sleep 0.2 mousemove 641 401
    "$1"
    sleep 0.7
    before=$(frames)
    sleep 1.5
    between=$(($(frames) - before))
    ((between <= 1)) || { echo "pause by $1: $between frames came"; exit 1; }
    "$2"
    sleep 1
    (($(frames) - before - between >= 5)) || { echo "pause by $1: it never went on by $2"; tail -n 3 "$said"; exit 1; }
}
stands_still click click
stands_still p p
stands_still click p
stands_still away back
kill "$child"
wait "$child" || true
child=

# No frame was longer than one that is late, and the ball fell on from where it was: as it would in the time that the lesson had.
awk '/^frame/ && $2 > 0.5 {
    if ($3 > 0.4) { print "a frame of " $3 " s"; bad = 1 }
    if (n++ && before - $4 > 0.02) { print "the ball leapt from " before " to " $4; bad = 1 }
    before = $4
}
END { if (before > 1.9 || before < 0.05) { print "the ball ended at " before; bad = 1 } if (n < 40) { print "only " n " frames"; bad = 1 } exit bad }' "$said"
