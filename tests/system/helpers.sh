#!/usr/bin/env bash
# helpers.sh ROOT BUILD: every helper that the program can start, by its own list, is built by the target of a run and starts in a
# folder that holds what this target builds and nothing else; so does a lesson whose answers are heard.
set -euo pipefail
root=$1 build=$2
folder=$(mktemp -d -p "$build")
trap 'rm -rf -- "$folder"' EXIT
fail() {
    echo "helpers.sh: $*" >&2
    exit 1
}
ninja -C "$build" -t commands fulcrum_program >"$folder/commands"

# Programs are linked into the build folder itself; models are made by the stamp's rule.
mkdir "$folder/tree"
while read -r file; do
    ln "$build/$file" "$folder/tree/$file"
done < <(grep -oE -- ' -o fulcrum[^ /]*' "$folder/commands" | cut -d ' ' -f 3)
[[ -x $folder/tree/fulcrum ]] || fail "ninja does not say what fulcrum_program builds"
if grep -qF models.stamp "$folder/commands"; then
    mkdir "$folder/tree/assets" && ln -s "$build/assets/models" "$folder/tree/assets/models"
fi

header=$root/runtime/app/places.h
mapfile -t helpers < <(sed -nE 's/^inline constexpr const char\* k[A-Za-z]*Helper = "([^"]*)";/\1/p' "$header")
((${#helpers[@]} > 0)) || fail "$header names no helper"
for helper in "${helpers[@]}"; do
    [[ -x $folder/tree/$helper ]] || fail "$helper is not built by fulcrum_program"
    "$folder/tree/$helper" </dev/null >/dev/null || fail "$helper does not start"
done

export HOME=$folder
unset XDG_DATA_HOME XDG_CACHE_HOME DISPLAY WAYLAND_DISPLAY
command -v flite >/dev/null || fail "no flite, which packages.txt names"
flite -voice slt -t "a watermelon is the heaviest" -o "$folder/heaviest.wav"
echo heaviest.wav >"$folder/list"
"$folder/tree/fulcrum" run gravity --headless --speech sphinx --seconds 60 --hear "$folder/list" >"$folder/said" 2>&1 || true
grep -q 'learner .*watermelon' "$folder/said" || { cat "$folder/said" >&2 && fail "a spoken answer was not heard"; }
echo "helpers.sh: ${helpers[*]}"
