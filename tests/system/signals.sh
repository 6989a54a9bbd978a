#!/usr/bin/env bash
# signals.sh FULCRUM: a run that Ctrl-C, the system or a closed terminal ends: the force fades, record and progress are whole, the lesson's
# process is gone, and the exit code is 128 and the signal's number. With an arm in real time, and under a virtual clock.
set -euo pipefail
# shellcheck source=tests/system/home.sh
source "$(dirname -- "$0")/home.sh" "$1"
start_arm arm

# A spring that is felt from half a second on, a question that is answered, and nothing that would end it.
mkdir "$home/lesson"
cat >"$home/lesson/lesson.lua" <<'LUA'
local story = require "story"
local L = lesson { id = "endless", title = "Endless", level = "A1", minutes = 60 }
L:question "ready" { prompt = "Are you ready?", answers = { "yes" }, right = function() return true end }
function L:start(world)
  local rope = world:spring { at = { 0.05, 0.05, 0 }, stiffness = 60, damping = 1 }
  rope:off()   -- a force begins with a calm hand
  story(L, function()
    story.wait(0.5)
    rope:on()
    story.ask(world, "ready")
    story.wait(80000)
  end)
end
L:test {}
return L
LUA

# ended_by SIGNAL CODE NAME OPTIONS…: plays until its record has some blocks, then sends the signal.
ended_by() {
    local signal=$1 right=$2 name=$3 code=0
    shift 3
    # Shells let what they start in the background take no notice of Ctrl-C: env gives it back.
    env --default-signal=INT "$fulcrum" run "$home/lesson" --headless --seconds 86400 --errors 0 --learner "$name" --record "$home/$name.rec" "$@" \
        >"$home/$name.log" 2>&1 &
    local player=$! child
    for ((i = 0; i < 300; ++i)); do
        kill -0 "$player" 2>/dev/null || fail "$name: it ended by itself"
        [[ $(stat -c %s "$home/$name.rec" 2>/dev/null || echo 0) -lt 800000 ]] || break
        sleep 0.1
    done
    [[ $i -lt 300 ]] || fail "$name: nothing is recorded"
    child=$(pgrep -P "$player") || fail "$name: the lesson has no process"
    kill -"$signal" "$player"
    wait "$player" || code=$?
    [[ $code -eq $right ]] || fail "$name: SIG$signal ends with code $code, not $right"
    grep -q '^endless: ended after' "$home/$name.log" || fail "$name: nothing is said of what was played"
    grep -q 'what there is of the run is kept' "$home/$name.log" || fail "$name: nobody says that it was ended"
    for pid in $child; do
        [[ ! -e /proc/$pid ]] || fail "$name: the lesson's process is left behind"
    done
    "$fulcrum" export "$home/$name.rec" --out "$home/$name.csv" >"$home/$name.export.log" 2>&1 || fail "$name: the record cannot be read"
    grep -q 'cut off' "$home/$name.export.log" && fail "$name: the record has no end"
    "$fulcrum" report --format csv >"$home/$name.report.log" 2>&1 || fail "$name: there is no report"
    grep -q "^$name,.*,endless,.*,ready," "$home/$name.report.log" || fail "$name: nothing is kept of the learner"
}
# force FILE: the length of what the hand was given in the last round and the most in any.
force() {
    awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i ~ /^applied_f/) at[++n] = i; next }
        n == 3 && $at[1] != "" { last = sqrt($at[1]^2 + $at[2]^2 + $at[3]^2); if (last > most) most = last }
        END { printf "%.6f %.6f\n", last, most }' "$1"
}
for case in "INT 130 Ida" "TERM 143 Tom" "HUP 129 Hal"; do
    read -r signal code name <<<"$case"
    ended_by "$signal" "$code" "$name" --first-use never --hand "udp:127.0.0.1:$port"
    read -r last most < <(force "$home/$name.csv")
    awk "BEGIN { exit !($most > 0.5) }" || fail "$name: no force was felt before, $most N"
    awk "BEGIN { exit !($last < 0.001) }" || fail "$name: the last round's force is $last N"
done
ended_by INT 130 Vic
ended_by TERM 143 Vera
echo "signals.sh: passed"
