#!/usr/bin/env bash
# economy.sh PROBE MORE TESTED SILENT: only what a scene calls for is executed, counted in instructions by callgrind.
#   1  a scene executes functions of the effects that it has, and no instruction of any other effect;
#   2  a library that knows one kind of field more (MORE) executes in every scene exactly as many instructions;
#   3  a loop built without the places that tell a listener of its stages (SILENT) executes as
#      many, but for one a round by which the compiler orders one text or the other better (there are ten places and more);
#   4  a world's round at rest costs the same with 1 body and with 64.
# Each can fail: every effect is seen where it is used; one comparison a round (TESTED) moves the count; falling bodies cost.
set -euo pipefail
command -v valgrind >/dev/null || { echo "skipped: no valgrind (Debian package valgrind)"; exit 77; }
probe=$(realpath "$1") more=$(realpath "$2") tested=$(realpath "$3") silent=$(realpath "$4")
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
failed=0
fail() {
    echo "$*"
    failed=1
}

# An effect, and what its functions are called: the beginnings of their names in namespace fulcrum.
effects='
god-object  (GodObject|MovingSolid|BoundingTree|NearbyTriangles|find_nearest_hit|compute_constrained_point)
coupling    (ContactStage::step|compute_contact_damping|TouchVelocity::|compute_coupling|compute_spring_force_N)
surface     (SurfaceEffects::|TouchMotion::)
texture     (TextureStage::|Texture::|TextureMap::|feel_on_body)
transient   (TransientStage::|Transient::)
sound       TouchTeller::
shading     (ShadedNormals::|ContactStage::shade)
weight      WeightRamp::
fields      FieldStage::
spring      pull_of_spring
viscosity   pull_of_liquid
magnet      pull_of_magnet
lesson      (LinearisedWrenchStage::|compute_linearised_wrench|bound_gains)
passivity   (PassivityStage::|PassivityController::)
kalman      KalmanVelocity::
flight      (step_flight|compute_falling_velocity)
catcher     Catcher::
line        (LineStage::|LineFeel::)
kite        (KiteFlight::|KiteLine::|KiteAirLoad::|compute_plate_force|step_gusts)
bodies      BodyStage::
rigid       (RigidWorld::|NearBodies::|ContactsAhead::|SceneIslands::|IslandTurns::|IslandStepper::|WayBounds::|BodyLoads::|IslandSolver::|ContactProblem::|ContactSolver::)
'
# A scene, and the effects that it calls for.
scenes='
bare
weight     weight passivity
spring     fields spring passivity
viscosity  fields viscosity passivity
magnet     fields magnet passivity
lesson     lesson passivity
solid      god-object coupling passivity
textured   god-object coupling surface texture passivity
tapped     god-object coupling surface transient passivity
shaded     god-object coupling shading passivity
kalman     kalman
rest-4
fall-4     flight
caught-4   flight catcher
line       line passivity
flown      kite
pushed     god-object coupling bodies rigid passivity
'
rounds=400

# count PROGRAM SCENE ROUNDS: callgrind's account of the loops' steps. Program and arguments look alike in each run, and
# everything is bound before it starts, so that nothing but the steps decides what is counted.
count() {
    local place
    place="$folder/$(basename "$1").$2.$3"
    mkdir -p "$place"
    cp "$1" "$place/probe"
    (cd "$place" && env -i PATH="$PATH" LD_BIND_NOW=1 valgrind --tool=callgrind --callgrind-out-file=account \
        --compress-strings=no --compress-pos=no --toggle-collect='fulcrum::HapticLoop::step*' \
        --toggle-collect='fulcrum::WorldLoop::step*' \
        --toggle-collect='fulcrum::KiteLoop::step*' --toggle-collect='fulcrum::RigidLoop::step*' ./probe "$2" "$3" >said 2>&1) ||
        { cat "$place/said" && return 1; }
}
export -f count
export folder

# total PROGRAM SCENE ROUNDS: how many instructions there were.
total() { sed -n 's/^summary: //p' "$folder/$(basename "$1").$2.$3/account"; }

# executed SCENE PATTERN: how many instructions of the functions of an effect, without what they call.
executed() {
    awk -v pattern="^([a-z]+ )?fulcrum::([(]anonymous namespace[)]::)?$2" '
        /^fn=/ { ours = substr($0, 4) ~ pattern }
        /^calls=/ { getline; next }
        ours && /^[0-9]/ { n += $2 }
        END { print n + 0 }' "$folder/$(basename "$probe").$1.$rounds/account"
}

{
    while read -r scene _; do
        [[ -n $scene ]] && echo "$probe $scene $rounds"
    done <<<"$scenes"
    for scene in bare weight spring viscosity magnet lesson solid kalman added; do
        echo "$more $scene $rounds"
    done
    echo "$tested bare $rounds"
    for scene in bare weight spring lesson solid; do
        echo "$silent $scene $rounds"
    done
    for scene in rest-1 rest-64 fall-1 fall-64; do
        echo "$probe $scene 100"
        echo "$probe $scene 300"
    done
} >"$folder/runs"
xargs -P "$(nproc)" -L 1 bash -c 'count "$@"' count <"$folder/runs" || fail "a probe did not run"
((failed == 0)) || exit 1

# 1
printf '%-10s instructions of each effect in %d rounds\n' scene "$rounds"
while read -r scene used; do
    [[ -n $scene ]] || continue
    printf '%-10s' "$scene"
    while read -r effect pattern; do
        [[ -n $effect ]] || continue
        n=$(executed "$scene" "$pattern")
        ((n == 0)) || printf ' %s %d' "$effect" "$n"
        if [[ " $used " == *" $effect "* ]]; then
            ((n > 0)) || fail "  $scene calls for $effect, but none of its functions is seen"
        else
            ((n == 0)) || fail "  $scene does not call for $effect, but executes $n instructions of it"
        fi
    done <<<"$effects"
    echo " of $(total "$probe" "$scene" "$rounds")"
done <<<"$scenes"

# 2
for scene in bare weight spring viscosity magnet lesson solid kalman; do
    before=$(total "$probe" "$scene" "$rounds")
    after=$(total "$more" "$scene" "$rounds")
    ((before == after)) || fail "$scene: $before instructions, but $after once the library has another kind of field"
done
grep -q 'pull_of_wind' "$folder/$(basename "$more").added.$rounds/account" || fail "the added kind of field is not felt"
bare=$(total "$probe" bare "$rounds")
bare_tested=$(total "$tested" bare "$rounds")
((bare_tested >= bare + rounds)) || fail "a comparison in each round is not seen: $bare instructions, with it $bare_tested"
echo "one kind of field more: not an instruction in 8 scenes; one comparison a round: $((bare_tested - bare))"

# 3
for scene in bare weight spring lesson solid; do
    with=$(total "$probe" "$scene" "$rounds")
    without=$(total "$silent" "$scene" "$rounds")
    ((with - without <= rounds && without - with <= rounds)) || fail "$scene: $with instructions where nobody listens, $without in a loop that has nothing to tell"
done

# 4
# a_round SCENE: of 200 rounds after the first 100, which take the commands.
a_round() { echo $((($(total "$probe" "$1" 300) - $(total "$probe" "$1" 100)) / 200)); }
rest_1=$(a_round rest-1) rest_64=$(a_round rest-64) fall_1=$(a_round fall-1) fall_64=$(a_round fall-64)
echo "instructions of a world's round: at rest $rest_1 with one body, $rest_64 with 64; falling $fall_1 and $fall_64"
((rest_1 > 0 && rest_64 * 100 <= rest_1 * 102)) || fail "64 bodies at rest cost $rest_64 instructions a round, one $rest_1"
((rest_64 * 60 <= fall_64)) || fail "64 bodies at rest cost $rest_64 instructions a round, falling only $fall_64"
exit "$failed"
