#!/usr/bin/env bash
# can_fail.sh: proves that each check beside it passes on a good tree and fails on each bad one, with the right words.
# shellcheck disable=SC2016 # quotes inside the trees' files are Markdown's
set -euo pipefail
checks=$(cd -- "$(dirname -- "$0")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
failed=0

# put FILE TEXT: writes a file of the tree.
put() {
    mkdir -p "$tree/$(dirname -- "$1")"
    printf '%b\n' "$2" >"$tree/$1"
}

# own TEXT: a source whose own that is.
own() { printf 'namespace fulcrum {\nnamespace {\n%b\n}  // namespace\n}' "$1"; }

# changes [ROW]: a table of changes with that row.
changes() { printf 'id\\tkind\\tfile\\ttext\\tchanged\\tequivalent\\n%s' "${1:-1\\tconstant\\tdialogue/english/noun.cpp\\tint   kMost=3;\\tint kMost = -3;\\t}"; }

# measured_row COMMIT COMMAND: a table with one figure.
measured_row() { printf '| what | figure | command | commit |\\n| --- | --- | --- | --- |\\n| a wall | 3 N | %s | %s |' "$2" "$1"; }

good_tree() {
    tree="$scratch/a tree"
    rm -rf -- "$tree"
    mkdir -p "$tree"/{haptics/{base,math,loop},dialogue/english,runtime/{app,scene/gltf},scripts,scenarios,assets,cmake,docs,tests/{unit,checks,stability,support}}
    put LICENSE "MIT"
    put packages.txt "cmake # builds"
    put README.md "# The house\n\n| folder | what |\n|---|---|\n$(cd "$tree" && printf '| `%s` | x |\\n' */)"
    put docs/measured.md "# Measured figures\n\n$(measured_row 0a1b2c3d '`./fulcrum bench wall`')\n\n[all](../README.md#the-house) [these](#measured-figures)"
    put fulcrum '#   ./fulcrum test [-L unit …]  runs all tests'
    put runtime/app/option_table.cpp '        {"run", run, "LESSON", "play a lesson"},'
    put tests/bench/curves/wall.cpp '#include "haptics/loop/step.h"\nconst Registration kWall{{\n    "wall", "stiff", run_wall}};'
    put tests/bench/figures/wall-cost.csv '# commit: 0a1b2c3d+\n# command: fulcrum bench'
    put haptics/base/error.h '#include <string>'
    put haptics/math/spatial.h '#include "haptics/base/error.h"'
    put haptics/math/to_eigen.h '#include "haptics/math/spatial.h"\n#include <Eigen/Core>'
    put haptics/loop/step.h '#include "haptics/math/spatial.h"\n#include <sys/mman.h>'
    put dialogue/english/noun.h '#include <tl/expected.hpp>'
    put runtime/scene/gltf/model.h '#include "haptics/base/error.h"\n#include <tiny_gltf.h>'
    put runtime/app/main.cpp '#include "runtime/scene/gltf/model.h"\n#include "dialogue/english/noun.h"'
    put dialogue/english/noun.cpp "$(own 'constexpr int kMost = 3;\nusing Kind = Noun::Kind;\nint twice(int n) {\n    return n;\n}')"
    put tests/unit/main_test.cpp ''
    put tests/unit/noun_test.cpp ''
    put tests/unit/option_table_test.cpp ''
    put tests/checks/untested.txt '# none'
    put tests/mutation/changes.tsv "$(changes)"
    cp "$checks/../../.clang-format" "$tree"
}

# passes CHECK: on the tree as it stands.
passes() {
    local output
    output=$("$checks/$1.sh" "$tree" 2>&1) || { echo "$1: should pass, but: $output"; failed=1; }
}

# spoilt CHECK WORDS FILE TEXT: with this one file the check fails, and says these words; then the tree is good again.
spoilt() {
    local output
    put "$3" "$4"
    if output=$("$checks/$1.sh" "$tree" 2>&1); then
        echo "$1: should fail on $3 with \"$4\""
        failed=1
    elif [[ $output != *"$2"* ]]; then
        echo "$1: should say \"$2\", but says: $output"
        failed=1
    fi
    good_tree
}

good_tree
for check in include_direction effect_rooms class_sources vendor_headers unfinished same_bits file_length sources_have_tests project_files merge_markers joined_names changes_apply shipped_gate pages figures; do
    passes "$check"
done

spoilt include_direction 'haptics must not know runtime' haptics/loop/bad.h '#include "runtime/scene/gltf/model.h"'
spoilt include_direction 'haptics must not know dialogue' haptics/loop/bad.h '#include "dialogue/english/noun.h"'
spoilt include_direction 'dialogue must not know haptics' dialogue/english/bad.h '#include "haptics/base/error.h"'
spoilt include_direction 'haptics/base must not use haptics/loop' haptics/base/bad.h '#include "haptics/loop/step.h"'
spoilt include_direction 'haptics/math must not use haptics/loop' haptics/math/bad.cpp '  #  include "haptics/loop/step.h"'
spoilt include_direction 'runtime/scene must not use runtime/app' runtime/scene/bad.h '#include "runtime/app/app.h"'
spoilt include_direction 'runtime/lua/wire must not use runtime/lua/api' runtime/lua/wire/bad.h '#include "runtime/lua/api/needs.h"'
spoilt include_direction 'runtime/lua/attic has no place' runtime/lua/attic/bad.h '#include "runtime/lua/wire/wire.h"'
spoilt include_direction 'not written from the root' haptics/math/bad.h '#include "spatial.h"'
spoilt include_direction 'not written from the root' haptics/math/bad.h '#include "../base/error.h"'
spoilt include_direction 'haptics/attic has no place' haptics/attic/bad.h '#include "haptics/base/error.h"'
spoilt include_direction 'a file outside the rooms uses haptics/loop' haptics/bad.h '#include "haptics/loop/step.h"'
put haptics/math/turn.h '#include "haptics/math/angle.h"'
spoilt include_direction 'angle.cpp:2: "haptics/math/turn.h" closes the circle of haptics/math/angle haptics/math/turn' haptics/math/angle.cpp '#include "haptics/math/angle.h"\n#include "haptics/math/turn.h"'
put haptics/math/turn.h '#include "haptics/math/angle.h"'
spoilt include_direction 'angle_build.cpp:2: "haptics/math/turn.h" closes the circle' haptics/math/angle_build.cpp '#include "haptics/math/angle.h"\n#include "haptics/math/turn.h"'
put haptics/math/turn.h '#include "haptics/math/angle.h"'
put haptics/math/angle.cpp '#include "haptics/math/angle.h"'
put haptics/math/angle_turn.cpp '#include "haptics/math/turn.h"'
passes include_direction
put runtime/effect/field/field_fields.h 'FieldKind::spring'
passes effect_rooms
spoilt effect_rooms 'runtime/app/bad.cpp:1:' runtime/app/bad.cpp 'if (kind == FieldKind::spring) {'
put haptics/loop/turner.cpp 'void Turner::turn() {\n}'
put haptics/loop/turner_build.cpp 'Turner::Turner() {\n}'
passes class_sources
put haptics/loop/turner.cpp 'void Turner::turn() {\n}'
put haptics/loop/turner_build.cpp 'Turner::Turner() {\n}'
spoilt class_sources 'Turner has its methods in 3 sources' haptics/loop/turner_told.cpp 'double Turner::tell() {\n}'
spoilt vendor_headers '<GLFW/glfw3.h> belongs' runtime/app/bad.h '#include <GLFW/glfw3.h>'
spoilt vendor_headers '<tiny_gltf.h> belongs' runtime/scene/bad.h '#include <tiny_gltf.h>'
spoilt vendor_headers '<sqlite3.h> belongs' runtime/progress/bad.h '# include <sqlite3.h>'
spoilt vendor_headers '<lua.hpp> belongs' runtime/scene/bad.h '#include <lua.hpp>'
spoilt vendor_headers '<Eigen/Core> belongs' dialogue/english/bad.h '#include <Eigen/Core>'
spoilt vendor_headers '<Eigen/Core> belongs' haptics/loop/bad.h '#include <Eigen/Core>'
spoilt vendor_headers '<nlohmann/json.hpp> belongs' haptics/loop/bad.h '#include <nlohmann/json.hpp>'
spoilt vendor_headers 'from no library that the house knows' haptics/loop/bad.h '#include <boost/any.hpp>'
spoilt shipped_gate 'another slew than ships' tests/unit/bad_test.cpp 'TEST_CASE("a wall: it stands") {\n    plan.safety.max_slew_N_per_s = 5000.0;\n}'
spoilt same_bits 'use compute_length' haptics/loop/bad.cpp 'const double n = (a - b).stableNorm();'
spoilt same_bits 'write Vector3::Zero()' haptics/loop/bad.cpp 'const Twist up{{0.0, 1.0, 0.0}, {}};'
spoilt same_bits 'write Vector3::Zero()' haptics/loop/bad.cpp 'step(Wrench{{}, Vector3(0.0, 1.0, 0.0)});'
spoilt joined_names 'kMost is called so in dialogue/english/noun.cpp too' dialogue/english/verb.cpp "$(own 'constexpr int kMost = 4;')"
spoilt joined_names 'Kind is called so' dialogue/english/verb.cpp "$(own 'using Kind = Verb::Kind;')"
spoilt joined_names 'twice(int) is called so' dialogue/english/verb.cpp "$(own 'double twice(int times) { return 2.0 * times; }')"
put dialogue/english/verb.cpp "$(own 'using Kind = Noun::Kind;\ndouble twice(double x) { return x; }')"
passes joined_names
good_tree
spoilt unfinished 'later' runtime/app/bad.h '// TO''DO: later'
spoilt unfinished 'CHECK(rc::check' tests/unit/bad_test.cpp '    rc::che''ck([] {});'
spoilt unfinished 'bad.lua' scenarios/bad.lua '-- not yet imple''mented'
spoilt file_length 'long.cpp: 401 lines' haptics/math/long.cpp "$(printf 'x\\n%.0s' {1..400})"
spoilt sources_have_tests 'runtime/app/lonely.cpp: no test' runtime/app/lonely.cpp ''
spoilt sources_have_tests 'has its test' tests/checks/untested.txt 'runtime/app/main.cpp # tested elsewhere'
spoilt sources_have_tests 'does not exist' tests/checks/untested.txt 'runtime/app/gone.cpp # tested elsewhere'
for mark in '<''<<<<<< HEAD' '|''|||||| base' '>''>>>>>> 0a1b2c3 A change'; do
    spoilt merge_markers 'was not finished' haptics/math/bad.md "before\\n$mark\\nafter"
done
noun='1\tconstant\tdialogue/english/noun.cpp'
spoilt changes_apply 'noun.cpp has no "int' dialogue/english/noun.cpp "$(own 'constexpr int kMost = 4;')"
spoilt changes_apply 'more than once' dialogue/english/noun.cpp "$(own 'constexpr int kMost = 3;\nstatic int kMost = 3;')"
spoilt changes_apply 'gone.cpp is not there' tests/mutation/changes.tsv "$(changes '1\tsign\tdialogue/gone.cpp\ta + b\ta - b\t')"
spoilt changes_apply 'changes nothing' tests/mutation/changes.tsv "$(changes "$noun\\tkMost = 3\\tkMost  =  3\\t")"
spoilt changes_apply 'six columns' tests/mutation/changes.tsv "$(changes "$noun\\tkMost = 3\\tkMost = 4")"
spoilt changes_apply 'has no row' tests/mutation/changes.tsv 'id'
rm -- "$tree/LICENSE"
spoilt project_files 'LICENSE: missing' scripts/good.lua ''
spoilt project_files 'no row of the folder table for attic/' attic/bad.h ''
spoilt project_files 'which is not there' README.md '| folder |\n|---|\n| `attic/` | x |'
spoilt project_files 'fixed paths' scripts/bad.lua 'open("/''tmp/x")'
spoilt pages '121 lines' README.md "# The house$(printf '\\nx%.0s' {1..120})"
spoilt pages 'docs/bad.md:2: (../gone.md) leads to no file' docs/bad.md 'a\n[b](../gone.md)'
spoilt pages 'leads to no file' haptics/loop/bad.md '![`code`](gone.png)'
spoilt pages 'leads to no heading' docs/bad.md '[a](../README.md#the-attic)'
spoilt pages 'leads to no heading' docs/bad.md '```\n# Here\n```\n[a](#here)'
spoilt figures '"today" is no commit' docs/measured.md "$(measured_row today '`./fulcrum bench wall`')"
spoilt figures '"-" is no commit' docs/measured.md "$(measured_row - '`./fulcrum bench wall`')"
spoilt figures '"" is no commit' docs/measured.md "$(measured_row '' '`./fulcrum bench wall`')"
spoilt figures 'this table: "" is no commit' docs/measured.md 'Measured by `.ci/run`.\n\n| what | figure |\n| --- | --- |\n| a wall | 3 N |'
spoilt figures 'a wall: no command' docs/measured.md "$(measured_row 0a1b2c3d 'by `hand`')"
spoilt figures 'no benchmark is called attic' docs/measured.md "$(measured_row 0a1b2c3d '`./fulcrum bench wall attic --quick`')"
spoilt figures 'knows no command walk' docs/measured.md "$(measured_row 0a1b2c3d '`time ./fulcrum walk gravity`')"
spoilt figures 'is no program' docs/measured.md "$(measured_row 0a1b2c3d '`tests/system/gone.sh`')"
spoilt figures 'this table: no command' docs/measured.md '| what | figure |\n| --- | --- |\n| a wall | 3 N |'
spoilt figures 'wall-cost.csv: its figure: "" is no commit' tests/bench/figures/wall-cost.csv '# commit: unknown\n# command: fulcrum bench'
spoilt figures 'no benchmark is called attic' tests/bench/figures/attic-cost.csv '# commit: 0a1b2c3d\n# command: fulcrum bench'
# What was measured before its sources changed is told, and is no failure; nor is what was measured since.
history() { git -C "$tree" -c user.name=x -c user.email=x "$@"; }
history init -q && history add . && history commit -qm one
measured=$(history rev-parse HEAD)
put docs/measured.md "$(measured_row "$measured" '`./fulcrum bench wall`')"
said=$("$checks/figures.sh" "$tree")
[[ $said != *"a wall"* ]] || { echo "figures: tells of what is as it was: $said" && failed=1; }
put haptics/base/error.h '#include <vector>'
said=$("$checks/figures.sh" "$tree")
[[ $said == *"a wall: $measured, haptics/base/error.h"* ]] || { echo "figures: a changed source is not told: $said" && failed=1; }
good_tree
if command -v clang-format >/dev/null; then
    spoilt format 'bad.h' runtime/app/bad.h 'int   x ;'
fi
exit "$failed"
