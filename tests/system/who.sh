#!/usr/bin/env bash
# who.sh PROGRAM ROOT: a class of thirty is made by one command and asked "Who are you?" in a real window, on a screen of its own. Two clicks
# find a pupil, and what is played then is that pupil's; a wrong picture finds nobody, and a guest is apart from all.
set -euo pipefail
program=$1
root=$2
# shellcheck source=tests/system/screen.sh
source "$(dirname -- "$0")/screen.sh"
need xdotool

fail() { echo "who: $*"; cat "$folder/said"; exit 1; }
# refused TEXT COMMAND…: exit code 2 and one sentence with that text.
refused() {
    local text=$1 told
    shift
    told=$("$folder/fulcrum" "$@" 2>&1 >/dev/null </dev/null) && fail "not refused: $*"
    (($(wc -l <<<"$told") == 1)) || fail "not one sentence: $told"
    grep -qF -- "$text" <<<"$told" || fail "told \"$told\", not \"$text\""
}
# until_true SECONDS COMMAND…: waits until the command succeeds.
until_true() {
    local deadline=$((SECONDS + $1))
    until "${@:2}" >/dev/null; do
        ((SECONDS <= deadline)) || fail "never true: ${*:2}"
        sleep 0.1
    done
}

# A place of its own, with one lesson.
mkdir -p "$folder/assets" "$folder/scripts" "$folder/scenarios/one"
cp "$program" "$folder/fulcrum"
cp -r "$root/assets/words" "$folder/assets/words"
cp -r "$root/scripts/lib" "$folder/scripts/lib"
printf '%s\n' 'local L = lesson { id = "one", title = "one", level = "A1", minutes = 1 }' \
    'function L:start(world) print("playing one") end' 'return L' >"$folder/scenarios/one/lesson.lua"
: >"$folder/said"

# The command: thirty at once, no two cards alike, and what cannot be in one sentence.
for ((i = 0; i < 30; ++i)); do printf 'Pupil %02d\n' "$i"; done >"$folder/4b.txt"
"$folder/fulcrum" class new 4b --names "$folder/4b.txt" >"$folder/listed"
"$folder/fulcrum" class list | cmp - "$folder/listed"
cards=$(sed -n 's/^  Pupil [0-9]*  \(.*\)  secret: .*/\1/p' "$folder/listed" | awk '{ print ($1 < $3) ? $1 " " $3 : $3 " " $1 }' | sort -u | wc -l)
((cards == 30)) || fail "$cards cards of 30"
refused 'there is a class "4B" already' class new 4B Mina
refused '4b: "pupil 03" is in the class already' class add 'pupil 03'
refused '4b: the class would have 37 pupils' class add A B C D E F G
refused 'there are no names' class new 5a --names /dev/null
refused "$folder: the names cannot be read" class new 5a --names "$folder"
printf 'Mina\nTim\nmina\n' >"$folder/5a.txt"
refused "$folder/5a.txt:3: \"mina\" stands there twice" class new 5a --names "$folder/5a.txt"
refused 'there is no picture "elephant"' class picture 'Pupil 00' apple kite elephant
refused 'write new, add, list' class remove 'Pupil 00'
refused 'write pictures or names' class show-as walls
refused 'there is no class "5a"' class list --class 5a
[[ $("$folder/fulcrum" class list) == "$(<"$folder/listed")" ]] || fail "what was refused changed the class"

# Known pictures for two pupils; pupil 07 gets another secret by chance.
"$folder/fulcrum" class show-as names | grep -q '^4b: 30 pupils, shown as names$' || fail "not shown as names"
"$folder/fulcrum" class show-as pictures | grep -q '^4b: 30 pupils, shown as pictures$' || fail "not shown as pictures"
before=$(grep 'Pupil 07' "$folder/listed")
"$folder/fulcrum" class picture 'Pupil 07' >"$folder/now"
[[ ${before%secret:*} == "$(sed 's/secret:.*//' "$folder/now")" && $before != "$(<"$folder/now")" ]] || fail "no other secret: $(<"$folder/now")"
secret=$(sed -n 's/.*secret: //p' "$folder/now")

"$folder/fulcrum" >"$folder/said" 2>&1 &
child=$!
until_true 30 xdotool search --name '^Fulcrum$'
sleep 1
# Cards of the class are 159 wide and 171 apart, seven in a row, in a window of 1280 x 720, those of the secrets likewise in two rows.
click_at() { xdotool mousemove "$1" "$2" sleep 0.2 click 1; }
pupil() { click_at $((127 + 171 * ($1 % 7))) $((137 + 128 * ($1 / 7))); }
pictures=(apple banana bucket earth egg flower gem kite ring star tree watermelon)
picture() {
    local i
    for i in "${!pictures[@]}"; do
        [[ ${pictures[i]} != "$1" ]] || break
    done
    if ((i < 7)); then click_at $((127 + 171 * i)) 237; else click_at $((213 + 171 * (i - 7))) 469; fi
}
escape() { xdotool key Escape sleep 0.5; }
# The list of lessons has one, and the card that leads back; at this place of it there is no secret picture.
lesson() { click_at 450 353; }
plays() { "${@:2}" && (($(grep -c '^playing' "$folder/said") >= $1)); }
who_played() { "$folder/fulcrum" report --guests --format csv | awk -F, '$3 == "one" { print $1 }'; }

# Wrong pictures: after the third all are face down for four seconds, in which the right one lets nobody in either.
pupil 7
sleep 0.6
for wrong in "${pictures[@]}"; do
    [[ $wrong != "$secret" ]] && break
done
for wait in 1.6 2.6 0.3; do
    picture "$wrong"
    sleep "$wait"
done
picture "$secret"
sleep 0.5
lesson
sleep 1
! grep -q '^playing' "$folder/said" || fail "a wrong picture let somebody in"
sleep 3
escape
escape_leaves() { ! kill -0 "$child" 2>/dev/null; }
escape_leaves && fail "escape from the pictures left the program"

# Two clicks find the pupil, and the lesson is theirs; a double click on the card is one, and no wrong picture.
pupil 7
xdotool click 1
sleep 0.6
picture "$secret"
sleep 1
until_true 20 plays 1 lesson
xdotool key Escape sleep 0.5 key Escape sleep 0.5
[[ $(who_played) == 'Pupil 07' ]] || fail "not pupil 07 played: $(who_played)"

# Back to who they are; by keyboard a guest is the last card, twice, and each is another.
guest_by_keys() { xdotool key Down Down Down Down Right Right Right Right Right Right Return sleep 1; }
escape
guest_by_keys
xdotool key Return
until_true 20 plays 2 sleep 0.3
xdotool key Escape sleep 0.5 key Escape sleep 0.5
escape
guest_by_keys
xdotool key Return
until_true 20 plays 3 sleep 0.3
xdotool key Escape sleep 0.5 key Escape sleep 0.5
escape # who are you?
leaves() { xdotool key Escape && sleep 0.3 && escape_leaves; }
until_true 20 leaves
wait "$child" || fail "exit code $?"
child=
who_played >"$folder/played"
(($(grep -c '^guest ' "$folder/played") == 2 && $(wc -l <"$folder/played") == 3)) || fail "played: $(<"$folder/played")"
"$folder/fulcrum" report --lesson one | grep -qx 'Guests (2)' || fail "the report folds no guests"
# Who plays without the list is a guest of their own, too.
timeout 60 "$folder/fulcrum" run "$folder/scenarios/one" --mute --seconds 1 >"$folder/said" 2>&1 || fail "the run ended with $?"
"$folder/fulcrum" report --lesson one | grep -qx 'Guests (3)' || fail "a run without a learner is no guest's own"
