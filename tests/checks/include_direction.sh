#!/usr/bin/env bash
# include_direction.sh [ROOT]: fails on any #include against the direction of the house. Areas and the rooms in them
# stand in order, each above all that it may include; so there can be no cycle between rooms either. Includes are
# written from the root.
set -euo pipefail
cd "${1:-$(dirname -- "$0")/../..}"

find haptics dialogue runtime -name '*.h' -o -name '*.cpp' | LC_ALL=C sort | xargs -r grep -nHE '^[[:space:]]*#[[:space:]]*include[[:space:]]*"' | awk -F: '
BEGIN {
    # May include: itself and what is named.
    area["haptics"] = "haptics"
    area["dialogue"] = "dialogue"
    area["runtime"] = "runtime haptics dialogue"
    # Top to bottom. A folder that is not named here is no room yet: give it its place.
    order("haptics", "link loop tool point surface device flight dynamics constraint levels continuous collision record field voxel geometry coupling handover math base")
    order("dialogue", "conversation checking marking speech template english")
    order("runtime", "app lesson lua hearing render audio link progress evidence scene files text")
    # Inside a room that has rooms of its own.
    order("runtime/lua", "process host api sandbox wire")
}
function order(name, rooms,    list, n, i) {
    n = split(rooms, list, " ")
    for (i = 1; i <= n; ++i) rank[name "/" list[i]] = n - i + 1
}
function complain(why) { print $1 ":" $2 ": " why; bad = 1 }
# The inner room of a path, or nothing.
function inner_of(path,    part, n) { n = split(path, part, "/"); return n > 3 ? part[1] "/" part[2] "/" part[3] : "" }
function room_of(path,    part, n) { n = split(path, part, "/"); return n > 2 ? part[1] "/" part[2] : part[1] }
{
    included = $0
    sub(/^[^"]*"/, "", included)
    sub(/".*/, "", included)
    from = room_of($1)
    to = room_of(included)
    split(from, from_part, "/")
    split(to, to_part, "/")
    if (!(to_part[1] in area)) { complain("\"" included "\" is not written from the root"); next }
    if (!index(" " area[from_part[1]] " ", " " to_part[1] " ")) { complain(from_part[1] " must not know " to_part[1]); next }
    # Files that lie directly in an area belong to no room: all of its rooms may use them, and they use no room.
    if (from !~ /\//) { if (to ~ /\// && to_part[1] == from_part[1]) complain("a file outside the rooms uses " to); next }
    if (to !~ /\//) next
    if (!(from in rank)) { complain(from " has no place in the order of rooms"); next }
    if (!(to in rank)) { complain(to " has no place in the order of rooms"); next }
    if (from == to && (inner_from = inner_of($1)) != (inner_to = inner_of(included)) && (inner_from in rank || inner_to in rank)) {
        if (!(inner_from in rank)) complain(inner_from " has no place in the order of rooms")
        else if (!(inner_to in rank)) complain(inner_to " has no place in the order of rooms")
        else if (rank[inner_from] < rank[inner_to]) complain(inner_from " must not use " inner_to ", which stands above it")
    }
    if (from_part[1] == to_part[1] && from != to && rank[from] < rank[to]) complain(from " must not use " to ", which stands above it")
}
END { exit bad }'
