#!/usr/bin/env bash
# bench.sh PROGRAM BENCHMARKS: every benchmark in its quick form writes its files, figures drawn again from their files are
# the same, the figures that are kept are what their files say, and wrong use ends with a sentence.
set -euo pipefail
program=$1 benchmarks=$2
figures=$(cd -- "$(dirname -- "$0")/../bench/figures" && pwd)
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
failed=0
fail() {
    echo "$*"
    failed=1
}

# Every benchmark, quickly.
"$benchmarks" --quick --out "$folder/all" >"$folder/said" 2>"$folder/progress" || fail "a quick run ended with $?: $(tail -n 3 "$folder/progress")"
[[ $(<"$folder/said") == "$folder/all/index.html" ]] || fail "it does not say where the page is: $(<"$folder/said")"
n_names=$("$benchmarks" --list | wc -l)
n_done=$(grep -c ' s$' "$folder/progress" || true)
((n_names > 0 && n_done == n_names)) || fail "of $n_names benchmarks $n_done say that they ended"
for csv in "$folder"/all/*.csv; do
    name=$(basename "$csv" .csv)
    grep -q "id=\"$name\"" "$folder/all/index.html" || fail "$name is not on the page"
    ! grep -qE '[,"]-?(nan|inf)[,"]' "$csv" || fail "$name holds what is no number"
    grep -q '^# advice: .\{20\}' "$csv" || fail "$name does not say what to choose"
    grep -q '^# kind: sheet' "$csv" && continue
    [[ -s ${csv%csv}svg ]] || { fail "$name has no figure" && continue; }
    cp "$csv" "$folder/again.csv"
    "$benchmarks" --draw "$folder/again.csv"
    cmp "$folder/again.svg" "${csv%csv}svg" || fail "$name drawn again from its file is another figure"
done

# What is kept for docs/accuracy.md.
for csv in "$figures"/*.csv; do
    cp "$csv" "$folder/kept.csv"
    "$benchmarks" --draw "$folder/kept.csv"
    cmp "$folder/kept.svg" "${csv%csv}svg" || fail "$csv: its figure is out of date; draw it with --draw"
done

# Wrong use.
"$benchmarks" no-such-thing >"$folder/said" 2>&1 && fail "an unknown name is taken"
grep -q 'no benchmark "no-such-thing"' "$folder/said" || fail "an unknown name: $(<"$folder/said")"
"$benchmarks" --draw "$0" >"$folder/said" 2>&1 && fail "a file that is no figure is drawn"
grep -q "no figure's CSV" "$folder/said" || fail "a file that is no figure: $(<"$folder/said")"
"$benchmarks" --draw "$folder/all/stability.csv" >"$folder/said" 2>&1 && fail "a table is drawn"
grep -q 'a table has no figure' "$folder/said" || fail "a table: $(<"$folder/said")"
"$benchmarks" --out /dev/null/x stability >"$folder/said" 2>&1 && fail "a folder that cannot be made is taken"
grep -q -- '--out' "$folder/said" || fail "a folder that cannot be made: $(<"$folder/said")"

# The program hands over to the benchmarks beside it, or says that they are not there.
[[ $("$program" bench --list) == "$("$benchmarks" --list)" ]] || fail "fulcrum bench does not hand over"
mkdir "$folder/alone" && cp "$program" "$folder/alone/fulcrum"
"$folder/alone/fulcrum" bench >"$folder/said" 2>&1 && fail "benchmarks that are not there run"
grep -q './fulcrum bench, which builds them' "$folder/said" || fail "benchmarks that are not there: $(<"$folder/said")"
exit "$failed"
