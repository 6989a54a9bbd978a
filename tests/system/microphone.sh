#!/usr/bin/env bash
# microphone.sh PROGRAM: a voice speaks into a microphone while a lesson asks in a window, and is heard; then the microphone is unplugged, which
# is a sentence, and the lesson goes on. The microphone is what a sound server of the test's own hears of its own loudspeaker.
set -euo pipefail
program=$(realpath -- "$1")
# shellcheck source=tests/system/screen.sh
source "$(dirname -- "$0")/screen.sh"
need pulseaudio pactl paplay flite xdotool

export XDG_RUNTIME_DIR=$folder/runtime PULSE_SERVER=unix:$folder/sound ALSOFT_DRIVERS=pulse
mkdir -m 700 "$XDG_RUNTIME_DIR"
start_sound() {
    pulseaudio -n --daemonize=no --exit-idle-time=-1 --use-pid-file=no --log-level=error \
    -L "module-native-protocol-unix socket=$folder/sound auth-anonymous=1" -L "module-null-sink sink_name=ear" -L "module-null-sink sink_name=mouth" \
    2>"$folder/server" &
    sound=$!
}
start_sound
trap 'kill "$sound" 2>/dev/null || true; finish' EXIT
for _ in {1..100}; do
    ! pactl info >/dev/null 2>&1 || break
    sleep 0.05
done
pactl set-default-sink mouth || { cat "$folder/server"; exit 1; }
pactl set-default-source ear.monitor

mkdir "$folder/heard"
cat >"$folder/heard/lesson.lua" <<'LUA'
local game = require "game"
local story = require "story"
local L = lesson { id = "heard", title = "Say it", level = "A1", minutes = 1 }
L:question "heavier" {
  prompt = "Which one is heavier?",
  answers = { "[the] {thing} is <comparative:heavy>" },
  right = function(answer) return answer.thing == "watermelon" end,
}
L:question "again" {
  prompt = "And now?",
  answers = { "[the] {thing} is <comparative:heavy>" },
  right = function(answer) return answer.thing == "watermelon" end,
}
function L:start(world)
  world:body { name = "apple", noun = "apple", model = "apple", visible = true }
  world:body { name = "watermelon", noun = "watermelon", model = "watermelon", visible = true, at = { 0.2, 0, 0 } }
  game.play(L, world, function()
    print "asking"
    game.ask("heavier", { hint = "Feel them.", solution = "The watermelon is heavier." })
    print "answered"
    game.ask("again", { hint = "Feel them.", solution = "The watermelon is heavier." })
    print "typed"
    game.point()
  end)
end
return L
LUA
flite -voice slt -t "the watermelon is heavier" -o "$folder/voice.wav" </dev/null

: >"$folder/said"
"$program" run "$folder/heard" --speech sphinx --listen always --seconds 90 --learner Ann >"$folder/said" 2>&1 &
child=$!
wait_for asking 60
# Spoken until it is heard: the program is deaf while it speaks itself.
for _ in {1..8}; do
    sleep 3
    ! grep -q answered "$folder/said" || break
    paplay --device=ear "$folder/voice.wav"
done
wait_for answered 20
kill "$sound"
wait_for "microphone" 20
wait_for "The sound card is gone" 20
start_sound
wait_for "There is a sound card again" 20
xdotool search --onlyvisible --name Fulcrum windowfocus
sleep 1
xdotool type --delay 60 "the watermelon is heavier"
xdotool key Return
wait_for typed 20
grep -F microphone "$folder/said" | head -n 2
