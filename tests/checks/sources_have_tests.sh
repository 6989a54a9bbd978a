#!/usr/bin/env bash
# sources_have_tests.sh [ROOT]: fails on a .cpp of haptics, dialogue or runtime without a test under tests/unit: NAME_test.cpp,
# NAME_table.txt, which the test of its folder reads, or a suite whose first block of includes, which says what it tests, has
# NAME.h. untested.txt lists those that are tested elsewhere, each with the place and the reason; an entry that is no longer
# needed fails too.
set -euo pipefail
cd "${1:-$(dirname -- "$0")/../..}"

exceptions=tests/checks/untested.txt
bad=0
declare -A test_of suite_of excepted
while read -r file; do
    name=${file##*/}
    name=${name%_test.cpp}
    test_of[${name%_table.txt}]=$file
done < <(find tests/unit -name '*_test.cpp' -o -name '*_table.txt')
while read -r file header; do
    suite_of[${header%.h}]=$file
done < <(find tests/unit -name '*_test.cpp' | LC_ALL=C sort | xargs -r awk '
    FNR == 1 { head = 1 }
    !/^#include "/ { head = 0 }
    head { split($0, part, "\""); print FILENAME, part[2] }')
while read -r source _; do
    excepted[${source:-#}]=yes
done <"$exceptions"
while read -r source; do
    name=${source##*/}
    has_test=${test_of[${name%.cpp}]:-${suite_of[${source%.cpp}]:-}}
    if [[ -z $has_test && -z ${excepted[$source]:-} ]]; then
        echo "$source: no test of this name under tests/unit, and no suite there that begins with its header"
        bad=1
    elif [[ -n $has_test && -n ${excepted[$source]:-} ]]; then
        echo "$exceptions: $source has its test $has_test"
        bad=1
    fi
done < <(find haptics dialogue runtime -name '*.cpp' | LC_ALL=C sort)
while read -r source hash reason; do
    [[ -n $source && $source != '#' ]] || continue
    [[ -f $source ]] || { echo "$exceptions: $source does not exist"; bad=1; }
    [[ $hash == '#' && -n $reason ]] || { echo "$exceptions: $source gives no reason"; bad=1; }
done <"$exceptions"
exit "$bad"
