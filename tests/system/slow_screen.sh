#!/usr/bin/env bash
# slow_screen.sh PROGRAM SHIM: on a screen that takes 200 ms a picture the lesson goes on at its own rate.
set -euo pipefail
program=$1
shim=$(realpath "$2")
# shellcheck source=tests/system/screen.sh
source "$(dirname -- "$0")/screen.sh"

mkdir "$folder/x"
cat >"$folder/x/lesson.lua" <<'END'
local L = lesson { id = "x", title = "X", level = "A1", minutes = 1 }
local frames = 0
function L:update(world, dt)
  frames = frames + 1
  if frames % 10 == 0 then print("frames " .. frames) end
end
return L
END
preload=$shim${LD_PRELOAD:+:$LD_PRELOAD}
LD_PRELOAD=$preload "$program" run "$folder/x" --mute --seconds 5 >"$folder/said" 2>&1 || { cat "$folder/said"; exit 1; }
frames=$(sed -n 's/^frames //p' "$folder/said" | tail -n 1)
pictures=$(sed -n 's/.* \([0-9]*\) pictures, .*/\1/p' "$folder/said" | tail -n 1)
echo "${frames:-no} frames of the lesson, ${pictures:-no} pictures"
# It can have had 25 pictures and 300 frames; a frame that waited for each picture would have as many as these.
((pictures >= 2 && pictures <= 25 && frames >= 3 * pictures)) || { cat "$folder/said"; exit 1; }
