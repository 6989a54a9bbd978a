#!/usr/bin/env bash
# unruly_recogniser.sh FULCRUM: a program that hears and floods, or says nothing, stops no lesson: the run ends with a sentence, and a signal
# ends it at once.
set -euo pipefail
# shellcheck source=tests/system/home.sh
source "$(dirname -- "$0")/home.sh" "$1"
player=
# What is tried may take no notice of a kinder signal.
trap '[[ -z $player ]] || kill -KILL "$player" 2>/dev/null || true; cleanup' EXIT
# A quarter of a second of silence: a WAV file of 16-bit samples, mono, 16 kHz.
{
    printf 'RIFF\x64\x1f\x00\x00WAVEfmt \x10\x00\x00\x00\x01\x00\x01\x00\x80\x3e\x00\x00\x00\x7d\x00\x00\x02\x00\x10\x00data\x40\x1f\x00\x00'
    head -c 8000 /dev/zero
} >"$home/quiet.wav"
for _ in {1..9}; do echo quiet.wav; done >"$home/list"
mkdir "$home/lesson"
cat >"$home/lesson/lesson.lua" <<'LUA'
local story = require "story"
local L = lesson { id = "asks", title = "Asks", level = "A1", minutes = 5 }
L:question "ready" { prompt = "Are you ready?", answers = { "yes" }, right = function() return true end }
function L:start(world)
  story(L, function()
    story.ask(world, "ready")
    print "answered"
    world:finish { stars = 3 }
  end)
end
return L
LUA

begin() {
    env --default-signal=INT "$fulcrum" run "$home/lesson" --headless --speech "exec:$1" --hear "$home/list" "${@:2}" >"$home/said.log" 2>&1 &
    player=$!
}
seconds() { date +%s%N | sed 's/.........$//'; }

# ends COMMAND SENTENCE LONGEST_S: by itself, for nobody answers, or by what is typed.
ends() {
    local from code=0
    from=$(seconds)
    begin "$1"
    wait "$player" || code=$?
    player=
    [[ $code -eq 1 ]] || fail "$1: code $code, not 1"
    (($(seconds) - from <= $3)) || fail "$1: took longer than $3 s"
    grep -qF "$2" "$home/said.log" || fail "$1: nobody says: $2"
    grep -q 'nobody answered' "$home/said.log" || fail "$1: nothing is said of the end"
    echo yes >"$home/typed"
    begin "$1" --say "$home/typed"
    wait "$player" || fail "$1: what is typed does not go on"
    player=
    grep -q '^answered' "$home/said.log" || fail "$1: typing did not answer"
}
ends yes "says much more than it is asked, and was ended; type the answers." 30
ends "tr '\\0' a </dev/zero" "says a line that is too long; type the answers." 30
ends "exec >&- <&-; sleep 1000" "has ended; type the answers." 30
ends "sleep 1000" "has said nothing of what was spoken for 20 s, and was ended; type the answers." 50

# ended_by SIGNAL CODE COMMAND: while it is waited for.
ended_by() {
    local code=0 from
    begin "$3"
    sleep 2
    kill -0 "$player" || fail "$3: it ended by itself"
    from=$(date +%s%N)
    kill -"$1" "$player"
    wait "$player" || code=$?
    player=
    [[ $code -eq $2 ]] || fail "$3: SIG$1 ends with code $code, not $2"
    (($(date +%s%N) - from < 3000000000)) || fail "$3: SIG$1 took longer than 3 s"
}
for command in "sleep 1000" "while sleep 0.1; do echo '{\"heard\":99,\"text\":\"a\",\"confidence\":1}'; done"; do
    ended_by INT 130 "$command"
    ended_by TERM 143 "$command"
done
echo "unruly_recogniser.sh: passed"
