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

cp "$root/haptics/loop/haptic_loop.cpp" "$copy/tested/haptics/loop"
insert "$copy/tested/haptics/loop/haptic_loop.cpp" '^void HapticLoop::compute_forces' '^}' '    if (plan_.weight_onset_s < 0.0) {
        state_.faults |= Fault::command_invalid;
    }'

silent=$copy/silent/haptics/loop/haptic_loop.cpp
sed -E 's/^( *)passed\(.*\);$/\1(void)passed;/' "$root/haptics/loop/haptic_loop.cpp" >"$silent"
[[ $(grep -c '(void)passed;' "$silent") -ge 10 && $(grep -c '^ *passed(' "$silent") -eq 0 ]] ||
    { echo "add_effect.sh: haptic_loop.cpp tells of its stages in another way now" >&2 && exit 1; }
