#!/usr/bin/env bash
# same_forces.sh PROGRAM OTHER [LESSON…]: plays each lesson's own test by PROGRAM and repeats its record by OTHER, say of another
# processor's level: are all forces the same to the bit? Says for each lesson, and ends with 1 where one is not.
set -euo pipefail
program=$1 other=$2
shift 2
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
export HOME=$folder
unset XDG_DATA_HOME XDG_CACHE_HOME DISPLAY WAYLAND_DISPLAY
if (($# > 0)); then lessons=("$@"); else mapfile -t lessons < <("$program" list | awk '{ print $1 }'); fi
differ=0
for lesson in "${lessons[@]}"; do
    "$program" run "$lesson" --headless --record "$folder/run.rec" >"$folder/said" 2>&1 || { cat "$folder/said" >&2; exit 2; }
    status=0
    "$other" run "$lesson" --headless --hand "replay:$folder/run.rec" >"$folder/said" 2>&1 || status=$?
    printf '%s: %s\n' "$lesson" "$(tail -n 1 "$folder/said")"
    ((status == 0 || status == 3)) || exit 2
    ((status == 0)) || differ=1
done
exit "$differ"
