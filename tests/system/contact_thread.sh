#!/usr/bin/env bash
# contact_thread.sh FULCRUM LEVER PLANETS: both lessons as in a window, on threads, by tools whose contacts another thread finds, or that another thread
# moves: it ran, it kept pace, the haptic loop kept its time, and the record says that it was there.
set -euo pipefail
# shellcheck source=tests/system/home.sh
source "$(dirname -- "$0")/home.sh" "$1"
# An arm in another process, so that the program keeps the time of the wall.
start_arm arm --motion circle
# live LESSON OPTIONS…: by that arm, without a window.
live() {
    local lesson=$1
    shift
    "$fulcrum" run "$home/$lesson" --headless --first-use never --hand "udp:127.0.0.1:$port" "$@"
}

cp -r "$2" "$home/lever"
cp -r "$3" "$home/planets"
# by LESSON METHOD: the same with that tool, in a folder of its own.
by() {
    cp -r "$home/$1" "$home/$1-$2"
    sed -i -e "s/tool = { shape = \"cylinder\",/& method = \"$2\",/" -e "s/method, contact = \"field_sampling\", nil/method, contact = \"$2\", nil/" \
        "$home/$1-$2/lesson.lua"
    grep -q "\"$2\"" "$home/$1-$2/lesson.lua" || fail "$1 has no tool that could be $2"
}
# number PATTERN FILE: the one that stands before, or behind, what is looked for.
number() { sed -nE "s/.*$1.*/\1/p" "$2" | head -n 1; }

# plays LESSON METHOD: live, recorded, and again.
plays() {
    local lesson=$1 method=$2 log rounds missed found rate age code
    by "$lesson" "$method"
    log=$home/$lesson-$method.log
    live "$lesson-$method" --seconds 6 --record "$home/$lesson-$method.rec" >"$log" 2>&1 ||
        fail "$lesson was not played live by $method"
    expect "$log" '[(]1 times real time[)]' "$lesson by $method did not take its time"
    rounds=$(number 'Haptic loop: ([0-9]+) rounds' "$log")
    missed=$(number 'most[)], ([0-9]+) missed' "$log")
    found=$(number 'Contact thread: ([0-9]+) rounds' "$log")
    rate=$(number 'rounds, ([0-9]+) a second' "$log")
    age=$(number 'what it told was ([0-9]+)[.][0-9] ms old' "$log")
    [[ -n $rounds && -n $missed && -n $found && -n $rate && -n $age ]] || fail "$lesson by $method does not say how its threads did"
    # On a machine that others use, too: most rounds in their time, and an answer for at least every tenth.
    ((missed * 5 < rounds)) || fail "$lesson by $method: $missed of $rounds rounds of the haptic loop were missed"
    ((found * 10 > rounds && rate > 50)) || fail "$lesson by $method: the contact thread came to $found rounds beside $rounds"
    ((found <= rounds + 100)) || fail "$lesson by $method: $found answers to $rounds places"
    ((age <= 20)) || fail "$lesson by $method: contact was $age ms old"
    # The record says so, and a repetition, which has no such thread, names it where its forces are others.
    "$fulcrum" export "$home/$lesson-$method.rec" --out "$home/$lesson-$method.csv" >"$home/export.log" 2>&1 || fail "the record cannot be told"
    expect "$home/$lesson-$method.facts.csv" 'option.contact.*by a thread beside the steps' "the record does not say who found contact"
    code=0
    "$fulcrum" run "$home/$lesson-$method" --headless --hand "replay:$home/$lesson-$method.rec" >"$home/again.log" 2>&1 || code=$?
    ((code == 0)) || expect "$home/again.log" 'contact is in each step and was by a thread' "a repetition does not say why its forces are others"
}
for method in implicit_penalty god_object; do
    for lesson in lever planets; do
        plays "$lesson" "$method"
    done
done

# Points in a field have no such thread.
live planets --seconds 2 >"$home/none.log" 2>&1 || fail "the lesson was not played"
expect "$home/none.log" 'Haptic loop: [0-9]+ rounds' "it does not say how it kept its time"
! grep -q 'Contact thread' "$home/none.log" || fail "there is a thread with nothing to do"

# What runs, and what it costs.
for method in implicit_penalty god_object; do
    "$fulcrum" explain "$home/planets-$method" --analyze --seconds 5 >"$home/analyze.log" 2>&1 || fail "it cannot be explained"
    expect "$home/analyze.log" '^contact +(finding|motion) +2000 Hz' "the thread of $method is not named"
    expect "$home/analyze.log" '^contact +(finding|motion) +[0-9]{3,} +[0-9.]+ +[0-9.]+' "the thread's time is not told by $method"
    expect "$home/analyze.log" 'age of contact in a step then, 99 % [0-9.]+ ms' "the age of contact is not told by $method"
    for lesson in lever planets; do
        echo "$lesson by $method: $(grep -h '^Contact thread' "$home/$lesson-$method.log")"
    done
done
echo "contact_thread.sh: passed"
