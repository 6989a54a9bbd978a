#!/usr/bin/env bash
# arm.sh FULCRUM: the arm link as a person uses it, between two processes over a real socket: a lesson is played with the arm, the
# program is killed, the arm fades by itself, a stop from outside, another key, an arm that is held, none at all, and a bad line.
set -euo pipefail
# shellcheck source=tests/system/home.sh
source "$(dirname -- "$0")/home.sh" "$1"
# A ceiling that the circling hand goes up into, for three seconds of five: the arm presses.
mkdir "$home/ceiling"
cat >"$home/ceiling/lesson.lua" <<'LUA'
local L = lesson { id = "ceiling", title = "Ceiling", level = "A1", minutes = 1 }
function L:start(world)
  world:hand { centre = { 0, 0, 0 } }
  world:body { name = "ceiling", model = "box", size = { 0.6, 0.1, 0.6 }, solid = true, visible = true, at = { 0, 0.065, 0 } }
end
L:test {}
return L
LUA
# await_force LOG: until the arm that writes LOG presses by more than 0.5 N.
await_force() {
    for _ in $(seq 200); do
        tail -n 1 "$1" | grep -qE ': held, ([1-9][0-9]*|0[.][5-9])[.0-9]* N' && return
        sleep 0.1
    done
    fail "the arm does not press"
}
# check_gone LOG: it is without force, and was so 20 ms and a fade of 100 ms after the last command, and what a busy computer adds.
check_gone() {
    tail -n 1 "$1" | grep -q 'waiting, 0[.]00 N' || fail "the arm still holds a program that is gone"
    local gone_ms
    gone_ms=$(tail -n 1 "$1" | sed -n 's/.* gone \([0-9]*\) ms after the last command.*/\1/p')
    [[ -n $gone_ms && $gone_ms -ge 100 && $gone_ms -le 250 ]] || fail "the force was gone after ${gone_ms:-?} ms"
}
# Nobody holds these arms: first use is hand_fit.sh's.
play() { "$fulcrum" run gravity --headless --first-use never --hand "udp:127.0.0.1:$port" "$@"; }
# play_beside NAME OPTIONS…: in the background; its process in $player.
play_beside() {
    local name=$1
    shift
    "$fulcrum" run "$home/ceiling" --headless --first-use never --hand "udp:127.0.0.1:$port" "$@" >"$home/$name.log" 2>&1 &
    player=$!
}

# Played for three seconds, in three seconds, by an arm that loses packets, and left in good order.
start_arm good --motion circle --loss 3 --burst 5 --delay 1 --jitter 1 --duplicate 2 --corrupt 1 --seed 7
play --seconds 3 >"$home/play.log" 2>&1 || fail "the lesson was not played over the link"
expect "$home/play.log" "The arm's link: round trip [0-9.]+ ms" "it does not say how the link did"
expect "$home/play.log" 'ended after 3[.][0-9] s [(]1 times real time[)]' "it did not take its time"
# Killed while it presses: the arm fades by itself in the time that is stated, and is there for the next within a second.
play_beside killed --seconds 60
await_force "$home/good.log"
kill -KILL "$player"
wait "$player" 2>/dev/null || true
sleep 1.5
check_gone "$home/good.log"
# Stopped in the middle and continued, as by a terminal's Ctrl-Z: the arm lets go by itself, the program begins without force and anew.
play_beside paused --seconds 15
await_force "$home/good.log"
kill -STOP "$player"
sleep 1.5
check_gone "$home/good.log"
kill -CONT "$player"
wait "$player" || fail "a program that was stopped does not go on"
expect "$home/paused.log" 'asleep [1-9]' "the program did not notice that it had stood still"
expect "$home/paused.log" 'made [2-9] ' "the link was not made anew"
# The same with the arm's side: the program has no pose, says so, and has one again.
play_beside waits --seconds 6
sleep 2
kill -STOP "$arm"
sleep 1.5
kill -CONT "$arm"
wait "$player" || fail "a program whose arm stood still does not go on"
expect "$home/waits.log" 'made [2-9] ' "the link was not made anew after the arm stood still"
# All processors busy: it is played, and how late its rounds were is told.
busy=()
for _ in $(seq $((2 * $(nproc)))); do
    (while :; do :; done) &
    busy+=("$!")
done
code=0
play --seconds 3 >"$home/busy.log" 2>&1 || code=$?
kill "${busy[@]}"
[[ $code -eq 0 ]] || fail "the lesson was not played on busy processors"
expect "$home/busy.log" 'Haptic loop: [0-9]+ rounds, late by [0-9]+ us' "it does not say how late it was"
# Another key is told apart from no arm: the arm says nothing to who has none, and counts him; where none waits the computer says so.
good_port=$port
good_arm=$arm
start_arm locked
printf '%064d\n' 0 >"$home/other.key"
chmod 600 "$home/other.key"
code=0
play --key "$home/other.key" --seconds 3 >"$home/key.log" 2>&1 || code=$?
[[ $code -ne 0 ]] || fail "a wrong key was taken"
expect "$home/key.log" 'no arm answers, .* another key or version' "nothing says that the key may be another"
sleep 1.1
expect "$home/locked.log" '[(][1-9][0-9]* of another key' "the arm does not say that somebody knocked with another key"
port=$good_port
arm=$good_arm
# A stop from outside: the arm fades, and a key at it lifts the stop. This arm's alone: others may be held on this computer.
"$fulcrum" stop --only "$arm" >"$home/stop.log"
expect "$home/stop.log" '^Stopped: [1-9]' "nothing was stopped"
sleep 1.5
expect "$home/good.log" 'STOPPED' "the arm does not say that it is stopped"
echo >"$home/good.keys"
sleep 1.5
tail -n 1 "$home/good.log" | grep -q STOPPED && fail "a key at the arm does not lift the stop"
# One that moves no hand is told as such, and nothing is stopped: nobody may believe that there was nothing to stop.
code=0
"$fulcrum" stop --only $$ >"$home/stop_none.log" 2>&1 || code=$?
[[ $code -eq 1 ]] || fail "a stop of what moves no hand was a success"
expect "$home/stop_none.log" "^Process $$ moves no hand of yours: nothing was stopped" "nothing says that nothing was stopped"
# One arm, one program.
play_beside first --seconds 20
sleep 1.5
code=0
play --seconds 3 >"$home/second.log" 2>&1 || code=$?
[[ $code -ne 0 ]] || fail "two programs hold one arm"
expect "$home/second.log" 'held by another program' "nothing says that the arm is held"
kill -INT "$player"
wait "$player" || true
kill -INT "$arm"
wait "$arm" || true
expect "$home/good.log" 'On the line: .* [1-9][0-9]* lost, [1-9][0-9]* delayed, .* [1-9][0-9]* doubled, [1-9][0-9]* damaged' "faults did not occur"
# No arm at all.
code=0
play --seconds 3 >"$home/none.log" 2>&1 || code=$?
[[ $code -ne 0 ]] || fail "there was no arm, and nothing was said"
expect "$home/none.log" 'no arm waits there' "nothing says that there is no arm"
echo "arm.sh: passed"
