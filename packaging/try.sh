#!/usr/bin/env bash
# try.sh DEB KEPT: installs the package into a bare Debian 12 and uses it there as an ordinary user does: every lesson's test, a picture,
# a window with voice and effects, words that are heard, a lesson in the home folder; then purges it. What was fetched stays in KEPT.
# Ends with 0 where all went well, with 1 where something did not, with 77 where it could not be tried: "not run: reason".
set -euo pipefail

# shellcheck source=packaging/bare_debian.sh
. "$(dirname -- "$(readlink -f -- "$0")")/bare_debian.sh"
need_bare_debian

deb=$(readlink -f -- "$1")
mkdir -p "$2"
kept=$(cd -- "$2" && pwd)

bare=$(mktemp -d -p "$kept" bare.XXXXXX)
screen=
clean() {
    [[ -z $screen ]] || kill "$screen" 2>/dev/null || true
    rm -rf --one-file-system -- "$bare"
}
trap clean EXIT
log=$kept/try.log
: >"$log"

# Nothing else of this machine but its screen.
x=${TMPDIR:-/tmp}/.X11-unix
shown=("$x" "$x")
# pupil SCRIPT: as an ordinary user, in the home folder.
pupil() { inside setpriv --reuid pupil --regid pupil --init-groups env HOME=/pupil DISPLAY="${display:-}" sh -euc "cd; $1"; }

# ---- a bare Debian ---------------------------------------------------------------------------------------------------

unpack_bare_debian
cp "$deb" "$bare/fulcrum.deb"
# shellcheck disable=SC2086
if ! inside $apt install --download-only /fulcrum.deb >"$kept/fetch.log" 2>&1; then
    cat "$kept/fetch.log" >>"$log"
    # What apt cannot resolve is the package's own fault; what it cannot fetch is not.
    ! grep -qE 'Failed to fetch|Temporary failure|Could not (resolve|connect)' "$kept/fetch.log" ||
        not_run "what the package depends on could not be fetched: $(grep -m 1 -E '^(E|Err|W):' "$kept/fetch.log")"
fi

# ---- a claim a line --------------------------------------------------------------------------------------------------

begun=$SECONDS
# shellcheck disable=SC2086
claim "apt installs it with all that it depends on" inside $apt install --no-install-recommends /fulcrum.deb
echo "  in $((SECONDS - begun)) s, what it depends on being fetched before"
inside useradd --create-home --home-dir /pupil --groups audio pupil
claim "an ordinary user plays" pupil 'fulcrum run gravity --headless --seconds 8'
echo "  $((SECONDS - begun)) s after its installation began, eight seconds of the lesson gravity are played, the first force among them"

claim "the program starts, with its manual page, menu entry, icon, rules and limits" pupil '
    fulcrum --version
    for file in share/man/man1/fulcrum.1.gz share/applications/fulcrum.desktop share/icons/hicolor/scalable/apps/fulcrum.svg \
        lib/udev/rules.d/70-fulcrum-hands.rules share/doc/fulcrum/reference.md; do
        test -s /usr/$file
    done
    test -s /etc/security/limits.d/fulcrum.conf'
mapfile -t lessons < <(pupil 'fulcrum list' | awk '{ print $1 }')
claim "the lessons are listed" test "${#lessons[@]}" -ge 7
for lesson in "${lessons[@]}"; do
    claim "the test of $lesson is passed" pupil "fulcrum test $lesson"
done
claim "gravity is played, recorded, and repeated to the bit" pupil '
    fulcrum run gravity --headless --learner Mina --record run.rec
    fulcrum run gravity --headless --hand replay:run.rec'
claim "a picture is drawn without a display" pupil '
    fulcrum run gravity --headless --seconds 2 --screenshot picture.png
    test "$(stat -c %s picture.png)" -gt 20000'
claim "a spoken answer is heard" pupil '
    flite -voice slt -t "a watermelon is the heaviest" -o heaviest.wav
    echo heaviest.wav >list
    fulcrum run gravity --headless --speech sphinx --seconds 60 --hear list >heard 2>&1 || true
    cat heard
    grep -q "learner .*watermelon is the heaviest" heard'
claim "a lesson in the home folder is checked, tested, and listed when it lies among one's own" pupil '
    mkdir -p .local/share/fulcrum/scenarios/heavier
    cat >.local/share/fulcrum/scenarios/heavier/lesson.lua
    fulcrum check .local/share/fulcrum/scenarios/heavier
    fulcrum test heavier
    fulcrum list | grep -q "^heavier .*Which one is heavier"' <<'LUA'
local game = require "game"
local story = require "story"
local L = lesson { id = "heavier", title = "Which one is heavier?", level = "A1" }
L:question "heavier" {
  prompt = "Which one is heavier?",
  answers = { "[the|a|an] {thing} is <comparative:heavy> [than [the|a|an] {other}]" },
  right = function(answer) return answer.thing == "stone" end,
}
function L:start(world)
  world:bucket {}
  local stone = world:body { name = "stone", model = "egg", mass = 0.3, radius = 0.04, movable = true }
  world:body { name = "apple", model = "apple", mass = 0.1, radius = 0.04, movable = true }
  game.play(L, world, function()
    world:caption "Feel the stone."
    stone:hold()
    story.wait(3)
    world:release()
    game.ask("heavier", { hint = "One of them pulls your hand down more.", solution = "The stone is heavier." })
  end)
end
L:test { say = { "the apple is heavier", "the stone is more heavy" }, expect = { finished = true, stars = 1, form_errors = 1 } }
return L
LUA

# loudness FILE: the root mean square of a WAV file of 16 bits.
loudness() {
    { [[ ! -f $1 ]] || od -An -v -t d2 -w2 -j 80 "$1"; } | awk '{ sum += $1 * $1 } END { printf "%d", NR ? sqrt(sum / NR) : 0 }'
}
# A screen of this machine: the bare Debian has none, nor any library of one that the package does not ask for.
if command -v Xvfb >/dev/null; then
    Xvfb -displayfd 3 -screen 0 1280x720x24 -nolisten tcp -ac -noreset 3>"$kept/display" >/dev/null 2>&1 &
    screen=$!
    for _ in $(seq 100); do
        [[ ! -s $kept/display ]] || break
        sleep 0.1
    done
    display=:$(<"$kept/display")
    printf 'drivers = wave\nchannels = mono\nsample-type = int16\nfrequency = 22050\n[wave]\nfile = /pupil/sound.wav\n' >"$bare/pupil/alsoft.conf"
    rm -f "$kept"/*.wav
    for voice in none flite; do
        claim "a window opens and plays, with $([[ $voice == none ]] && echo "effects" || echo "effects and a voice")" pupil "
            ALSOFT_CONF=/pupil/alsoft.conf fulcrum run gravity --hand /usr/share/fulcrum/scenarios/gravity/catcher.lua --seconds 12 --voice $voice"
        mv -f "$bare/pupil/sound.wav" "$kept/$voice.wav" 2>/dev/null || true
    done
    kill "$screen" && screen=
    effects=$(loudness "$kept/none.wav") all=$(loudness "$kept/flite.wav")
    echo "  loudness of effects $effects, with a voice $all, of 32768"
    claim "effects are heard in the file" test "$effects" -ge 20
    claim "the voice is heard in the file" test "$all" -ge $((effects + effects / 4 + 20))
else
    leave_out "window, voice and effects" "Xvfb is missing; packages-package.txt names it"
fi
# With values that any root may set, which this machine's may not have for the real ones.
claim "the limits reach a member of audio" inside sh -euc '
    cd /etc/security/limits.d
    cp fulcrum.conf /as_installed
    sed -i "s/memlock unlimited/memlock 1024/; s/rtprio 95/rtprio 0/" fulcrum.conf
    got=$(su pupil -c "ulimit -Hl")
    mv /as_installed fulcrum.conf
    echo "$got"
    test "$got" = 1024'
if (ulimit -Hr 95) 2>/dev/null; then
    claim "a member of audio keeps the haptic loop's priority and memory" inside su pupil -c '
        cd
        fulcrum run gravity --headless --real-time --seconds 5 >run.log 2>&1
        cat run.log
        grep -q "SCHED_FIFO 80, memory locked" run.log'
else
    leave_out "the haptic loop's priority for an ordinary user" "not even root may raise them on this machine (CAP_SYS_RESOURCE)"
fi

# ---- and away --------------------------------------------------------------------------------------------------------

# shellcheck disable=SC2086
claim "it is purged" inside $apt purge fulcrum
left=$(cd "$bare" && find . -xdev -iname '*fulcrum*' ! -path './pupil/*' ! -path ./fulcrum.deb ! -path './var/cache/apt/*' ! -path './proc/*')
claim "nothing of it is left" test -z "$left"
[[ -z $left ]] || printf '    %s\n' "$left"
claim "the pupil's own files are left" test -s "$bare/pupil/.local/share/fulcrum/progress.db" -a \
    -s "$bare/pupil/.local/share/fulcrum/scenarios/heavier/lesson.lua"
((failed == 0)) || { echo "fulcrum: the package failed in a bare Debian; all that was said is in $log" >&2; exit 1; }
echo "passed$( ((left_out == 0)) || echo " but for $left_out not run"): $(du -sh --apparent-size "$deb" | cut -f 1) package, a bare Debian with it $(du -sh --apparent-size "$bare" | cut -f 1)."
