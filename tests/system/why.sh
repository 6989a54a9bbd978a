#!/usr/bin/env bash
# why.sh PROGRAM: F3 in a real window, on a screen of its own: the panel that says why the hand feels its force is there, goes to the
# other side when the hand comes to where it stands, and is gone when F3 is pressed again; of two hands it is the second one's before that.
# Looked for on the screen itself.
set -euo pipefail
program=$1
# shellcheck source=tests/system/screen.sh
source "$(dirname -- "$0")/screen.sh"
need xdotool

# begin HANDS: a rope for so many hands, in a window.
begin() {
    mkdir -p "$folder/x"
    printf '%s\n' "local L = lesson { id = \"x\", title = \"X\", level = \"A1\", minutes = 1, hands = $1 }" 'function L:start(world)' \
        "for i = 1, $1 do world:hand { centre = { 0, 0.3, 0 } } end" \
        'world:spring { name = "rope", at = { 0, 0.3, 0 }, stiffness = 60 }' 'end' 'return L' \
        >"$folder/x/lesson.lua"
    : >"$folder/said"
    "$program" run "$folder/x" --mute --voice none --seconds 120 >"$folder/said" 2>&1 &
    child=$!
    until xdotool search --onlyvisible --name Fulcrum windowfocus >/dev/null 2>&1; do
        kill -0 "$child" || { cat "$folder/said"; exit 1; }
        sleep 0.1
    done
}
# leave: by Escape.
leave() {
    xdotool key Escape sleep 0.2 key Escape
    wait "$child" || { echo "exit code $?"; cat "$folder/said"; exit 1; }
    child=
}

# How many pixels of the bars' blue the left and the right third have, below the top row: "LEFT RIGHT".
bars() {
    rows 160 560 | awk 'function count(part) { return gsub(/ff0072b2/, "", part) }
        { l += count(substr($0, 1, 9 * 427)); r += count(substr($0, 9 * 854 + 1)) } END { print l + 0, r + 0 }'
}
# await WHAT LEFT RIGHT: until there are bars on that side, or none: 1 or 0 each.
await() {
    local deadline=$((SECONDS + 30)) seen left right
    until seen=$(bars) && read -r left right <<<"$seen" && (((left > 500) == $2 && (right > 500) == $3)); do
        ((SECONDS < deadline)) || { echo "$1: $seen pixels of bars, left and right"; cat "$folder/said"; exit 1; }
        kill -0 "$child" || { echo "$1: it ended"; cat "$folder/said"; exit 1; }
    done
}

begin 1
await "before F3" 0 0
# The hand in the middle feels nothing, so the force may begin; then up, where the rope pulls it down.
xdotool mousemove 640 360 sleep 0.3 key F3 sleep 0.3 mousemove 640 200
await "F3" 1 0
xdotool mousemove 200 300
await "the hand comes to the panel" 0 1
xdotool mousemove 640 200
await "the hand goes away, the panel stays" 0 1
xdotool key F3
await "F3 again" 0 0
[[ ${FULCRUM_KEEP_SCREEN:-} ]] && xdotool key F3 sleep 1 && cp "$screen_file" "$FULCRUM_KEEP_SCREEN"
leave

# Two hands: the mouse's, the other one's, which rests at the rope's end and feels nothing, none; and the mouse's again.
begin 2
xdotool mousemove 640 360 sleep 0.3 mousemove 640 200
await "two hands, before F3" 0 0
xdotool key F3
await "two hands, F3" 1 0
xdotool key F3
await "two hands, the second one's" 0 0
xdotool key F3 sleep 0.5
await "two hands, nobody's" 0 0
xdotool key F3
await "two hands, the first one's again" 1 0
leave
