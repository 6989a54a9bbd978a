#!/usr/bin/env bash
# soak.sh FULCRUM [SECONDS [TIMES]]: everything under one clock and one seed: lesson, hand, learner's errors, and an arm on which things
# break. The same seed gives the same run TIMES of TIMES, another seed another; no force that may not be, no fade missed.
set -euo pipefail
seconds=${2:-12}
times=${3:-4}
# shellcheck source=tests/system/home.sh
source "$(dirname -- "$0")/home.sh" "$1"

hash_of() { "$fulcrum" soak --lesson gravity --seed "$1" --seeds 1 --seconds "$seconds" | sed -n 's/^gravity .* \([0-9a-f]\{16\}\)$/\1/p'; }
first=$(hash_of 11)
[[ -n $first ]] || fail "the run of seed 11 failed"
for ((i = 1; i < times; ++i)); do
    [[ $(hash_of 11) == "$first" ]] || fail "seed 11 gives another run the ${i}th time"
done
[[ $(hash_of 12) != "$first" ]] || fail "seeds 11 and 12 give the same run"
# Longer ones: seeds that once found something (with another course of the hand), and two of lessons with things to be touched.
for long in "kite 4" "kite 6" "gravity 7" "textures 6" "solar-system 4"; do
    read -r lesson seed <<<"$long"
    "$fulcrum" soak --lesson "$lesson" --seed "$seed" --seeds 1 --seconds 60 >"$home/long.log" || fail "$lesson: the run of seed $seed failed"
done
"$fulcrum" soak --seeds 1 --seed 21 --seconds "$seconds" >"$home/soak.log" || fail "a run of all lessons failed"
cat "$home/soak.log"
# In few and short runs too each kind of fault has occurred.
grep -qE '^Broke: packets lost' "$home/soak.log"
grep -qE '^Faded: cable pulled' "$home/soak.log"
grep -qE '^[a-z-]+ +wam +seed ' "$home/soak.log"
! grep -qE 'a torque in 0 s' "$home/soak.log" || fail "no torque was felt"
! grep -E '^(Broke|Faded|The hand):' "$home/soak.log" | grep -E ' 0[,.]' || fail "a kind of fault did not occur"
# Of each lesson it is told for how long a force was felt, and where one could be it was.
[[ $(grep -cE '^Felt in [a-z-]+: a force in [1-9][0-9]* % of the [1-9]|^Felt in [a-z-]+: a force in 0 % of the 0 s' "$home/soak.log") -eq \
    $(sed -n 's/^\([a-z-]*\) .* seed [0-9].*/\1/p' "$home/soak.log" | sort -u | wc -l) ]] ||
    fail "of some lesson no force was felt"
# How late the loops are in real time is told of each lesson.
lessons=$(sed -n 's/^\([a-z-]*\) .* seed [0-9].*/\1/p' "$home/soak.log" | sort -u | wc -l)
[[ $(grep -cE '^[a-z-]+ +in real time: Haptic loop: [0-9]+ rounds, late by ' "$home/soak.log") -eq $lessons ]] ||
    fail "no lateness in real time is told of some lesson"
grep -qE '^Deadlines under the virtual clock: [1-9][0-9]+ met\.' "$home/soak.log"
# Where there is no time for them it says so, and fails.
code=0
"$fulcrum" soak --seeds 1 --seed 21 --seconds 1 >"$home/short.log" 2>&1 || code=$?
[[ $code -eq 1 ]] && grep -q 'some kind of fault did not occur' "$home/short.log" || fail "a run that is too short is let pass"
