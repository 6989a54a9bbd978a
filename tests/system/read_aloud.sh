#!/usr/bin/env bash
# read_aloud.sh FULCRUM: what keys choose in a window is read aloud: a card of the list, a setting, an answer. The voice is
# a program of the test's that writes down what it is to say.
set -euo pipefail
fulcrum=$1
# shellcheck source=tests/system/screen.sh
source "$(dirname -- "$0")/screen.sh"
need xdotool
export ALSOFT_DRIVERS=null
mkdir "$folder/bin"
spoken=$folder/spoken
: >"$spoken"
cat >"$folder/bin/flite" <<END
#!/bin/sh
for text; do :; done
echo "\$text" >>"$spoken"
exit 1
END
chmod +x "$folder/bin/flite"
PATH=$folder/bin:$PATH
# reads TEXT: until the voice was asked to say that; what it said before is forgotten.
reads() {
    local deadline=$((SECONDS + 30))
    until grep -qF -- "$1" "$spoken"; do
        ((SECONDS <= deadline)) || { echo "never read: $1"; cat "$spoken" "$folder/said"; exit 1; }
        sleep 0.05
    done
    : >"$spoken"
}

mkdir "$folder/x"
cat >"$folder/x/lesson.lua" <<'LUA'
local L = lesson { id = "x", title = "X", level = "A1", minutes = 5 }
L:question "which" {
  prompt = "Which one?", answers = { "[the] {thing} is <comparative:heavy>" }, right = function(a) return a.thing == "apple" end,
}
function L:start(world)
  world:body { name = "apple", noun = "apple", model = "apple", visible = true }
  world:body { name = "egg", noun = "egg", model = "egg", visible = true, at = { 0.2, 0, 0 } }
  world:ask "which"
end
return L
LUA
"$fulcrum" menu --learner Ann --language en >"$folder/said" 2>&1 &
child=$!
reads "Which one is the heaviest?"
xdotool search --onlyvisible --name Fulcrum windowfocus
xdotool key Right
reads "What is it made of?"
xdotool key F4
reads "Sound"
kill "$child"
wait "$child" || true
"$fulcrum" run "$folder/x" --learner Ann --language en >"$folder/said" 2>&1 &
child=$!
reads "Which one?"
until xdotool search --onlyvisible --name Fulcrum windowfocus >/dev/null 2>&1; do sleep 0.1; done
xdotool key Down sleep 1 key Down
reads "is heavier"
kill "$child"
wait "$child" || true
child=
