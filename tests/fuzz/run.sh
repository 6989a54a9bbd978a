#!/usr/bin/env bash
# tests/fuzz/run.sh SECONDS [NAME…]: builds the fuzz targets (clang) and runs each for that long, one a core. Stops at
# the first crash, hang (10 s) or 2 GB, and says how to see it again. What is found stays in build/fuzz/corpus.
set -euo pipefail
cd "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/../.."
seconds=${1:?usage: tests/fuzz/run.sh SECONDS [NAME…]}
shift
preset=${FULCRUM_PRESET:-asan-short}
export build=build/$preset
mkdir -p build
cmake --preset "$preset" >"$build.configure.log" 2>&1 || { cat "$build.configure.log" >&2; exit 2; }
ninja --quiet -C "$build" fuzz_all

# fuzz NAME SECONDS: 255 tells xargs to start no more.
fuzz() {
    local name=$1 found=$PWD/build/fuzz/corpus/$1 crashes=$PWD/build/fuzz/crashes/$1 log options=()
    local seeds=$PWD/tests/fuzz/corpus/$name
    mkdir -p "$found" "$crashes"
    log=build/fuzz/$name.log
    [[ ! -d $seeds ]] || options+=("$seeds")
    [[ $name != lesson ]] || options+=("$PWD/tests/system/hostile") # lessons that mean harm are its best seeds
    [[ ! -f tests/fuzz/$name.dict ]] || options+=("-dict=tests/fuzz/$name.dict")
    if ! "$build/tests/fuzz_$name" "$found" "${options[@]}" -max_total_time="$2" -timeout=10 -rss_limit_mb=2048 \
        -print_final_stats=1 -artifact_prefix="$crashes/" >"$log" 2>&1; then
        grep -m 1 -A 25 -E 'ERROR:|runtime error:|ALARM' "$log" || tail -n 25 "$log"
        echo "fuzz $name: failed; see it again with: $build/tests/fuzz_$name $(sed -n 's/.*Test unit written to //p' "$log" | tail -n 1)"
        exit 255
    fi
    printf 'fuzz %-10s %s s, %s inputs, %s edges reached\n' "$name" "$2" \
        "$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")" "$(sed -n 's/.* cov: \([0-9]*\) .*/\1/p' "$log" | tail -n 1)"
}
export -f fuzz

names=("$@")
if [[ ${#names[@]} -eq 0 ]]; then
    mapfile -t names < <(find tests/fuzz -name '*_fuzz.cpp' -printf '%f\n' | sed 's/_fuzz.cpp$//' | sort)
fi
printf '%s\n' "${names[@]}" | xargs -r -P "$(nproc)" -I{} bash -c "fuzz {} $seconds"
