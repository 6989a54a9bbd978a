#!/usr/bin/env bash
# hearing.sh PROGRAM: what hears is started, and its models are read, only where somebody asked for it and the lesson asks anything.
set -euo pipefail
program=$1
command -v strace >/dev/null || { echo "no strace: skipped"; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
export HOME=$folder
unset XDG_DATA_HOME XDG_CACHE_HOME DISPLAY WAYLAND_DISPLAY
mkdir "$folder/silent"
cat >"$folder/silent/lesson.lua" <<'LUA'
local L = lesson { id = "silent", title = "Silent", level = "A1", minutes = 1 }
function L:start(world) world:body { name = "stone", model = "sphere", radius = 0.05, solid = true, visible = true } end
return L
LUA

# hears LESSON OPTION…: how often a run started what hears or opened one of its models.
hears() {
    strace -f -qq -e trace=execve,openat -o "$folder/calls" "$program" run "$1" --headless --seconds 20 "${@:2}" >"$folder/said" 2>&1 ||
        grep -q "nobody answered" "$folder/said" || { cat "$folder/said" >&2; exit 1; }
    grep -cE '"[^"]*(fulcrum-sphinx|pocketsphinx)[^"]*"' "$folder/calls" || true
}

spoken=$(hears gravity --speech sphinx)
typed=$(hears gravity)
silent=$(hears "$folder/silent" --speech sphinx)
echo "asked for $spoken times where answers are spoken, $typed where they are typed, $silent where nothing is asked"
((spoken > 0 && typed == 0 && silent == 0))
