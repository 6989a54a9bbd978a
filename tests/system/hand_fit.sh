#!/usr/bin/env bash
# hand_fit.sh FULCRUM: how an arm is set is kept with the learner and the arm, and its forces are tried once, between two processes
# over a real socket.
set -euo pipefail
# shellcheck source=tests/system/home.sh
source "$(dirname -- "$0")/home.sh" "$1"

# An arm on a desk, which reaches 16 by 12 by 7 cm.
start_arm arm --arm desktop
echo "an egg is the lightest" >"$home/say.txt"
# play NAME OPTIONS...: a second of the gravity game.
play() {
    local name=$1
    shift
    "$fulcrum" run gravity --headless --hand "udp:127.0.0.1:$port" --say "$home/say.txt" --db "$home/p.db" \
        --seconds 1 "$@" >"$home/$name.log" 2>&1 || fail "$name: the lesson was not played"
}

# The first time it is tried, gently; the scene is as large as what it reaches.
play first --learner Mina
expect "$home/first.log" '^The arm pushes gently' "its forces were not tried"
refuse "$home/first.log" 'no force in this lesson' "a good arm was found bad"
expect "$home/first.log" '16 by 12 by 7 cm, so it moves 4[.]0 times as far' "the scene was not fitted to what it reaches"
most=$(sed -n 's/.*most \([0-9.]*\).*/\1/p' "$home/arm.log" | tail -n 1)
[[ -n $most ]] && awk "BEGIN { exit !($most > 0.5 && $most <= 5) }" || fail "the arm felt $most N"
# The second time not; what is said once is kept, and holds without being said.
play second --learner Mina --scale 2 --handed left
refuse "$home/second.log" 'pushes gently' "it was tried again"
refuse "$home/second.log" 'so it moves' "the scale that was said was not taken"
play third --learner Mina
refuse "$home/third.log" 'so it moves' "the scale was not kept"
# Of another learner nothing is known.
play other --learner Jun --first-use never
refuse "$home/other.log" 'pushes gently' "it was tried though it was to be never"
expect "$home/other.log" 'so it moves 4[.]0 times' "another learner has Mina's scale"
# An arm that may give less than the lesson asks for: the weights are fitted to it, and the record says to how much.
kill "$arm" && wait "$arm" 2>/dev/null || true
mkdir -p "$home/weak/fulcrum"
echo "force_limit = 2" >"$home/weak/fulcrum/site.conf"
XDG_CONFIG_HOME=$home/weak start_arm weak_arm --arm desktop --key "$home/config/fulcrum/arm.key"
play weak --learner Mina --first-use never --record "$home/weak.rec"
"$fulcrum" export "$home/weak.rec" --out "$home/weak.csv" >"$home/export.log" 2>&1 || fail "the record was not exported"
grep -hE '^"?option[.]device N"?,"?2"?' "$home"/weak*.csv >/dev/null || fail "the lesson was not fitted to an arm of 2 N: $(grep -h 'device N' "$home"/weak*.csv)"
# Two arms: each is tried once and moves as far as it reaches; each has settings of its own.
first_port=$port
start_arm second --arm desktop --key "$home/config/fulcrum/arm.key"
play_both() {
    "$fulcrum" run "$(dirname -- "$0")/../../examples/two-fingers" --headless --hand "udp:127.0.0.1:$first_port" \
        --hand "udp:127.0.0.1:$port" --say "$home/say.txt" --db "$home/p.db" --seconds 1 --learner Ana >"$1" 2>&1 ||
        fail "two arms: the lesson was not played"
}
play_both "$home/both.log"
expect "$home/both.log" '^The arm pushes gently' "the first arm's forces were not tried"
expect "$home/both.log" '^The second arm pushes gently' "the second arm's forces were not tried"
refuse "$home/both.log" 'no force in this lesson' "a good arm was found bad"
expect "$home/both.log" 'The second arm reaches 16 by 12 by 7 cm, so it moves' "the second hand's scale was not fitted"
felt=$(sed -n 's/.*most \([0-9.]*\).*/\1/p' "$home/second.log" | tail -n 1)
[[ -n $felt ]] && awk "BEGIN { exit !($felt > 0.5) }" || fail "the second arm felt $felt N"
# Two arms, each with a key of its own.
second_port=$port
start_arm third --arm desktop --key "$home/third.key"
cmp -s "$home/third.key" "$home/config/fulcrum/arm.key" && fail "two arms have one key"
play_keys() {
    "$fulcrum" run "$(dirname -- "$0")/../../examples/two-fingers" --headless --first-use never --say "$home/say.txt" --db "$home/p.db" \
        --seconds 1 --hand "udp:127.0.0.1:$first_port" "${@:2}" >"$1" 2>&1
}
play_keys "$home/keys.log" --hand "udp:127.0.0.1:$port" --key "$home/third.key" || fail "two arms with a key each were not played with"
play_keys "$home/keys_both.log" --key "$home/config/fulcrum/arm.key" --hand "udp:127.0.0.1:$port" --key "$home/third.key" ||
    fail "two arms whose keys are both named were not played with"
! play_keys "$home/keys_wrong.log" --key "$home/third.key" --hand "udp:127.0.0.1:$port" || fail "the second arm's key opened the first"
expect "$home/keys_wrong.log" 'no arm answers' "nothing says that the first arm does not answer"
kill "$arm" && wait "$arm" 2>/dev/null || true
port=$second_port
# Two arms that nobody has tried: a guest's are tried each time, without a window too; none pushes before that with more than 0.8 N.
guest() {
    "$fulcrum" run "$(dirname -- "$0")/../../examples/two-fingers" --headless --hand "udp:127.0.0.1:$first_port" \
        --hand "udp:127.0.0.1:$port" --say "$home/say.txt" --db "$home/p.db" --seconds 1 >"$home/guest.log" 2>&1 ||
        fail "a guest's lesson was not played"
}
guest
expect "$home/guest.log" '^The arm pushes gently' "a guest's arm was not tried"
expect "$home/guest.log" '^The second arm pushes gently' "a guest's second arm was not tried"
play_both "$home/again.log"
refuse "$home/again.log" 'pushes gently' "an arm was tried again"
# The way to each is measured before anything is planned for it: what is touched is as soft as the longest needs it, and a replay knows that.
start_arm far_arm --arm desktop --delay 8 --key "$home/config/fulcrum/arm.key"
"$fulcrum" run "$(dirname -- "$0")/../../examples/two-fingers" --headless --first-use never --hand "udp:127.0.0.1:$first_port" \
    --hand "udp:127.0.0.1:$port" --say "$home/say.txt" --db "$home/p.db" --seconds 1 --record "$home/far.rec" >"$home/far.log" 2>&1 ||
    fail "an arm 8 ms away was not played with"
expect "$home/far.log" 'rock is felt .* over a link of [12][0-9] ms there and back' "the way to the second arm was not planned for"
"$fulcrum" run "$(dirname -- "$0")/../../examples/two-fingers" --headless --hand "replay:$home/far.rec" >"$home/far_replay.log" 2>&1 ||
    fail "two arms with a way each were not replayed to the bit: $(tail -n 2 "$home/far_replay.log")"
[[ $(grep 'rock is felt' "$home/far.log") == "$(grep 'rock is felt' "$home/far_replay.log")" ]] || fail "what was touched was not as soft in the replay"
echo "hand_fit.sh: passed"
