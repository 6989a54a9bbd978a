#!/usr/bin/env bash
# stick_fit.sh PROGRAM SHIM DEVICE: a joystick with motors is tried at a learner's first use as an arm is: weakly, once; then it gives
# all its force. One that pushes the wrong way gives none, and one that nobody has tried a third.
set -euo pipefail
shim=$2
device=$3
# shellcheck source=tests/system/home.sh
source "$(dirname -- "$0")/home.sh" "$1"

# A spring to where the hand begins, told of four times a second.
mkdir "$home/x"
cat >"$home/x/lesson.lua" <<'LUA'
local L = lesson { id = "x", title = "X", level = "A1", minutes = 1 }
local next_s, now_s = 0, 0
function L:start(world)
  world:spring { at = { 0, 0, 0 }, stiffness = 40, damping = 1 }
  world:hand { centre = { 0, 0, 0 }, scale = 2 }
end
function L:update(world, dt)
  now_s = now_s + dt
  if now_s >= next_s then
    next_s = now_s + 0.25
    print("round")
  end
end
return L
LUA
echo "yes" >"$home/say.txt"
path=$home/d.hid
coproc virtual { "$device" stick "$path"; }
# shellcheck disable=SC2154 # bash gives it
started+=("$virtual_PID")
read -r -t 30 -u "${virtual[0]}" said && [[ $said == plugged ]]
tell() { printf '%s\n' "$*" >&"${virtual[1]}"; }
# felt: the most of the full force since the last time.
felt() {
    local answer
    tell felt
    read -r -t 60 -u "${virtual[0]}" answer
    printf '%s\n' "${answer#felt }"
}
between() { awk "BEGIN { exit !($2 <= $1 && $1 <= $3) }"; }
# play NAME YIELDS OPTIONS...: the stick stands in its middle until the lesson runs, gives way as YIELDS says, and is then held 7 cm to
# the right; what was felt before that in $before, and then in $after.
play() {
    local name=$1 yields=$2 player
    shift 2
    tell stick 0 0
    # shellcheck disable=SC2086
    tell yield $yields
    : >"$home/$name.log"
    felt >/dev/null
    LD_PRELOAD=$shim "$fulcrum" run "$home/x" --headless --hand "hid:$path" --say "$home/say.txt" --db "$home/p.db" --seconds 7 "$@" \
        >"$home/$name.log" 2>&1 &
    player=$!
    for ((i = 0; i < 600; ++i)); do
        ! grep -q round "$home/$name.log" || break
        kill -0 "$player" 2>/dev/null || fail "$name: it ended before"
        sleep 0.1
    done
    before=$(felt)
    tell yield 0 0
    sleep 1
    tell stick 240 0
    wait "$player" || fail "$name: the lesson was not played"
    after=$(felt)
}

# 0.8 N of 3 N, a third of it: the usual joystick.
play first "60 60" --learner Mina
expect "$home/first.log" '^The stick pushes gently' "its forces were not tried"
refuse "$home/first.log" 'no force in this lesson' "a good stick was found bad"
between "$before" 0.05 0.15 || fail "an unknown stick pushed with $before of its force"
between "$after" 0.5 1 || fail "a stick that was tried well pushed with $after of its force"
play second "60 60" --learner Mina
refuse "$home/second.log" 'pushes gently' "it was tried again"
between "$after" 0.5 1 || fail "a stick that is known pushed with $after of its force"
# Motors that run the wrong way, along either axis.
play against "-60 60" --learner Jun
expect "$home/against.log" 'the stick gives no force in this lesson: the hand goes against its push, left and right' "it was not refused"
[[ $after == 0.000 ]] || fail "a stick that pushes the wrong way pushed with $after of its force"
play against_y "60 -60" --learner Jun
expect "$home/against_y.log" 'the stick gives no force in this lesson: the hand goes against its push, up and down' "it was not refused"
# Nobody knows what a stick does that did not move.
play dead "0 0" --learner Jun
expect "$home/dead.log" 'the stick gives no force in this lesson' "a stick that did not move was found good"
# Also where it is to be tried no more, until a trial is good.
play refused "60 60" --learner Jun --first-use never
refuse "$home/refused.log" 'pushes gently' "it was tried though it was to be never"
expect "$home/refused.log" 'the stick gives no force in this lesson: its last trial was not good' "nothing says that it gives no force"
[[ $after == 0.000 ]] || fail "a stick that was found bad pushed with $after of its force"
play mended "60 60" --learner Jun
between "$after" 0.5 1 || fail "a stick that was tried anew pushed with $after of its force"
play known "60 60" --learner Jun --first-use never
between "$after" 0.5 1 || fail "a stick that was tried well pushed with $after of its force where it was not to be tried"
# Nobody tries it: it stays weak.
play never "0 0" --first-use never
refuse "$home/never.log" 'pushes gently' "it was tried though it was to be never"
between "$after" 0.1 0.34 || fail "an untried stick pushed with $after of its force"
echo "stick_fit.sh: passed"
