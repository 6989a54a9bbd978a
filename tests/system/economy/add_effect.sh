#!/usr/bin/env bash
# add_effect.sh ROOT COPY: what it takes to add an effect, done to copies of the sources, for economy.sh to count.
#   COPY/kind    the rooms field and loop with one more kind of field, "wind": declared, with its law, its gains, its stage
#   COPY/tested  the haptic loop that asks one question more in each round
#   COPY/silent  the haptic loop that tells nobody when a stage has ended
set -euo pipefail
root=$1 copy=$2
mkdir -p "$copy"/{kind,tested,silent}/haptics/loop "$copy/kind/haptics/field"

# insert FILE AFTER BEFORE TEXT: puts TEXT in a line of its own before the first line that matches BEFORE and stands after
# one that matches AFTER.
insert() {
    awk -v after="$2" -v before="$3" -v text="$4" '
        !done && found && $0 ~ before { print text; done = 1 }
        $0 ~ after { found = 1 }
        { print }
        END { exit !done }' "$1" >"$1.new" ||
        { echo "add_effect.sh: ${1#"$copy"/} has no place to add to any more (a line /$3/ after /$2/): tell this script where a new effect goes" >&2 && exit 1; }
    mv "$1.new" "$1"
}

tree=$copy/kind/haptics
cp "$root"/haptics/field/*.{h,cpp} "$tree/field"
cp "$root"/haptics/loop/*.{h,cpp} "$tree/loop"
sed -i 's/^\(enum class FieldKind .*\) };$/\1,\n wind };/' "$tree/field/field_plan.h"
grep -q '^ wind };$' "$tree/field/field_plan.h" || { echo "add_effect.sh: field_plan.h declares its kinds in another way now" >&2 && exit 1; }
insert "$tree/field/field.cpp" '^namespace [{]' '^// In the order of FieldKind' 'Vector3 pull_of_wind(const FieldPlan& plan, const Vector3&, const Vector3&) noexcept {
    return Vector3(plan.peak_force_N, 0.0, 0.0);
}
'
insert "$tree/field/field.cpp" ' kLaws\[\] = ' '^};' '    {pull_of_wind, true},'
insert "$tree/field/field.cpp" '^FieldGains compute_largest_gains' '^    }$' '        case FieldKind::wind:
            return {0.0, plan.damping_Ns_per_m};'
insert "$tree/loop/haptic_plan.h" '^enum class HapticStage' '^    lesson,' '    wind,'
insert "$tree/loop/haptic_plan.h" ' kNames\[\] = ' '"forces: lesson"' '"forces: wind",'
insert "$tree/loop/haptic_plan.h" ' kStages\[\] = ' '^ *HapticStage::magnet};' 'HapticStage::wind,'

told=(haptic_loop.cpp scene_forces.cpp)
cp "${told[@]/#/$root/haptics/loop/}" "$copy/tested/haptics/loop"
insert "$copy/tested/haptics/loop/scene_forces.cpp" '^void SceneForces::compute' '^}' '    if (plan_.weight_onset_s < 0.0) {
        round.state.faults |= Fault::command_invalid;
    }'

silent=("${told[@]/#/$copy/silent/haptics/loop/}")
for source in "${told[@]}"; do
    sed -E 's/^( *)passed\(.*\);$/\1(void)passed;/' "$root/haptics/loop/$source" >"$copy/silent/haptics/loop/$source"
done
[[ $(grep -h '(void)passed;' "${silent[@]}" | wc -l) -ge 18 && $(grep -h '^ *passed(' "${silent[@]}" | wc -l) -eq 0 ]] ||
    { echo "add_effect.sh: haptic_loop.cpp and scene_forces.cpp tell of their stages in another way now" >&2 && exit 1; }
for source in "${silent[@]}"; do
    grep -q '(void)passed;' "$source" || { echo "add_effect.sh: ${source##*/} tells of no stage any more" >&2 && exit 1; }
done
