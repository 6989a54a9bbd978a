#!/usr/bin/env bash
# typing.sh FULCRUM HOW: what is composed arrives in the answer line. HOW is "compose": keys that the X library composes itself, a dead accent and
# letters of other scripts; or "nabi": an input method of its own for Hangul, as a program beside ours (XIM), whose letters are q w e r.
set -euo pipefail
fulcrum=$1
how=$2
# shellcheck source=tests/system/screen.sh
source "$(dirname -- "$0")/screen.sh"
need xdotool
export LC_ALL=C.UTF-8 # the X library's table of composed letters is chosen by the locale, as is xdotool's reading of its words
unset XMODIFIERS

method=
if [[ $how == nabi ]]; then
    need nabi
    export XMODIFIERS=@im=nabi
    nabi >/dev/null 2>&1 &
    method=$!
    finish_with_nabi() {
        kill "$method" 2>/dev/null || true
        finish
    }
    trap finish_with_nabi EXIT
    until xdotool search --class nabi >/dev/null 2>&1; do
        kill -0 "$method" || { echo "nabi ended"; exit 1; }
        sleep 0.1
    done
    sleep 1
fi

mkdir "$folder/x"
cat >"$folder/x/lesson.lua" <<'LUA'
local L = lesson { id = "x", title = "X", level = "A1", minutes = 5, tries = 20 }
L:question "heavier" {
  prompt = "Which one is heavier?",
  answers = { "[the] {thing} is <comparative:heavy>" },
  right = function(answer) return answer.thing == "watermelon" end,
}
function L:start(world)
  world:body { name = "apple", noun = "apple", model = "apple", visible = true }
  world:body { name = "watermelon", noun = "watermelon", model = "watermelon", visible = true, at = { 0.2, 0, 0 } }
  world:ask "heavier"
  print "asking"
end
function L:answered(answer) if answer.right then print "right" end end
return L
LUA
: >"$folder/said"
"$fulcrum" run "$folder/x" --mute --seconds 60 --record "$folder/run.rec" >"$folder/said" 2>&1 &
child=$!
wait_for asking
until xdotool search --onlyvisible --name Fulcrum windowfocus >/dev/null 2>&1; do sleep 0.1; done
sleep 1

answer() {
    sleep 0.4
    xdotool key Return
    sleep 0.6
}
if [[ $how == nabi ]]; then
    # Shift and the blank turn the method on and off.
    xdotool key --delay 150 shift+space
    xdotool type --delay 150 gksrnr
    sleep 0.3
    xdotool key --delay 150 shift+space
    answer
    wanted=(한국)
else
    xdotool type --delay 250 한국어
    answer
    xdotool type --delay 250 caf
    xdotool key --delay 250 dead_acute e
    answer
    xdotool type --delay 250 "שלום abc"
    answer
    wanted=(한국어 café "שלום abc")
fi
# English goes on, and is marked.
xdotool type --delay 60 "the watermelon is heavier"
answer
wait_for right 10
xdotool key Escape Escape
wait "$child" || true
child=
for words in "${wanted[@]}"; do
    grep -aqF -- "$words" "$folder/run.rec" || { echo "what was typed did not arrive: $words"; exit 1; }
done
echo "arrived: ${wanted[*]}"
