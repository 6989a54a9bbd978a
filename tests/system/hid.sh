#!/usr/bin/env bash
# hid.sh cap|stick PROGRAM SHIM DEVICE: plays with a HID device in a real window on a screen of its own. It moves the hand, is pulled
# out in the middle, while the mouse moves the hand, and put in again; a stick's force is felt, ends when it should, and when the program is killed. Its
# first use is stick_fit.sh's.
set -euo pipefail
kind=$1
program=$2
shim=$3
device=$4
# shellcheck source=tests/system/screen.sh
source "$(dirname -- "$0")/screen.sh"
need xdotool

# wait_until TEXT AWK: until a line "hand X Y" for which AWK holds comes after this call.
wait_until() {
    local deadline=$((SECONDS + 30)) from
    from=$(wc -l <"$folder/said")
    until tail -n "+$((from + 1))" "$folder/said" | awk "/^hand /"' && ('"$2"') { found = 1 } END { exit !found }'; do
        if ((SECONDS > deadline)); then
            echo "never came: $1"
            tail -n 20 "$folder/said"
            exit 1
        fi
        sleep 0.05
    done
}
tell() { printf '%s\n' "$*" >&"${virtual[1]}"; }
# ask WORDS: what the device answers.
ask() {
    local answer
    tell "$@"
    read -r -t 60 -u "${virtual[0]}" answer
    printf '%s\n' "$answer"
}
# pushes: until a force is felt that begins where it is small, as it must after every stop and every fade.
pushes() {
    local deadline=$((SECONDS + 60)) felt
    until tell stick 0 0 && sleep 1 && tell stick 511 0 && sleep 1 && felt=$(ask felt) &&
        awk -v felt="${felt#felt }" 'BEGIN { exit !(felt > 0.1) }'; do
        ((SECONDS <= deadline)) || { echo "$felt, not more than 0.1"; exit 1; }
        # An arm with force is stopped while nobody could press Escape: the window gets the keys, and Return lifts the stop.
        xdotool search --onlyvisible --name Fulcrum windowfocus && sleep 0.5 && xdotool key Return
    done
}

# A spring to where the hand begins, and where the hand is, four times a second.
mkdir "$folder/x"
cat >"$folder/x/lesson.lua" <<'LUA'
local L = lesson { id = "x", title = "X", level = "A1", minutes = 1 }
local x, y, next_s, now_s = 0, 0, 0, 0
function L:start(world)
  world:spring { at = { 0, 0, 0 }, stiffness = 40, damping = 1 }
  local hand = world:hand { centre = { 0, 0, 0 }, scale = 2 }
  hand:force(function(tool) x, y = tool.x, tool.y return 0, 0, 0 end)
end
function L:update(world, dt)
  now_s = now_s + dt
  if now_s >= next_s then
    next_s = now_s + 0.25
    print(("hand %.3f %.3f"):format(x, y))
  end
end
return L
LUA

path=$folder/d.hid
coproc virtual { "$device" "$kind" "$path"; }
trap 'kill "$virtual_PID" 2>/dev/null || true; finish' EXIT
read -r -t 30 -u "${virtual[0]}" said && [[ $said == plugged ]]

: >"$folder/said"
LD_PRELOAD=$shim "$program" run "$folder/x" --hand "hid:$path" --first-use never --mute --seconds 120 >"$folder/said" 2>&1 &
child=$!
wait_for "hand "

if [[ $kind == cap ]]; then
    tell push 350 0 0 # to the right
    wait_until "the hand goes to the right" '$2 > 0.1 && $3 < 0.05'
    tell garbage # which is no push, and after a moment no push either
    sleep 1
    tell push 0 0 0
    tell push 0 0 350 # down
    wait_until "the hand goes down" '$3 < -0.05'
else
    tell stick 511 0
    wait_until "the hand goes to the right" '$2 > 0.25'
    pushes # 40 N/m over 0.3 m, held to 3 N, and to a third of it while nobody has tried this stick
fi

tell unplug
if [[ $kind == cap ]]; then name=SpaceNavigator; else name="Force stick"; fi
wait_for "$name has gone; plug it in again, and the lesson goes on with it."
[[ $kind == cap ]] || [[ $(ask still) == still ]]
wait_until "the lesson goes on without it" '1'
# The mouse moves the hand meanwhile: to the upper left.
wait_for "The mouse moves the hand until it is there again."
xdotool mousemove 200 60
wait_until "the mouse moves the hand" '$2 < -0.05 && $3 > 0.05'
tell push 0 0 0
tell plug
wait_for "$name is back."
wait_for "It moves the hand again; its force comes softly."
if [[ $kind == cap ]]; then
    tell push -350 0 0
    wait_until "the hand goes to the left" '$2 < -0.1'
    kill -INT "$child"
    wait "$child" || true
else
    wait_until "the hand comes back" '$2 < 0.05'
    pushes
    kill -KILL "$child"
    wait "$child" 2>/dev/null || true
    # Nobody renews the effect any more.
    [[ $(ask still) == still ]]
fi
child=
grep -q "terminate\|Sanitizer\|runtime error" "$folder/said" && { cat "$folder/said"; exit 1; }

# In a window a stick's first use is asked about, in a stick's words.
if [[ $kind == stick ]]; then
    tell stick 0 0
    tell yield 60 60
    : >"$folder/said"
    LD_PRELOAD=$shim "$program" run "$folder/x" --hand "hid:$path" --mute --voice none --seconds 90 >"$folder/said" 2>&1 &
    child=$!
    deadline=$((SECONDS + 60))
    until grep -q '^Which way does the stick push: left, right, to you, or away?$' "$folder/said"; do
        ((SECONDS <= deadline)) || { echo "a stick's first use is not asked about"; cat "$folder/said"; exit 1; }
        # A window without the keys has stopped it: Return lifts that.
        xdotool search --onlyvisible --name Fulcrum windowfocus && sleep 0.5 && xdotool key Return
        sleep 0.5
    done
    xdotool key --delay 30 r i g h t Return
    wait_for "  right"
    kill -INT "$child"
    wait "$child" || true
    child=
    tell yield 0 0
fi

# What cannot be is told in a sentence, with exit code 2.
refused() {
    local code=0
    LD_PRELOAD=$shim timeout 60 "$program" run "$folder/x" --mute --seconds 1 "${@:2}" >"$folder/said" 2>&1 || code=$?
    if [[ $code != 2 ]] || ! grep -qF -- "$1" "$folder/said"; then
        echo "${*:2}: exit code $code, not 2 and \"$1\""
        cat "$folder/said"
        exit 1
    fi
}
refused "none.hid: there is no device to be opened" --hand "hid:$folder/none.hid"
refused "this is no HID device" --hand "hid:$folder/x/lesson.lua"
refused "names no device" --hand hid:

# Without a window it is played with as well, in its own time; the device that is there still takes part.
LD_PRELOAD=$shim timeout 60 "$program" run "$folder/x" --headless --first-use never --seconds 2 --hand "hid:$path" >"$folder/said" 2>&1 || { cat "$folder/said"; exit 1; }
wait_for "(1 times real time)"
wait_for "Haptic loop: "
