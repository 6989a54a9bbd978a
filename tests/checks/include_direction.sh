#!/usr/bin/env bash
# include_direction.sh [ROOT]: fails on any #include against the direction of the house. Areas and the rooms in them
# stand in order, each above all that it may include. Nor do files include each other in a circle: X.h and X.cpp count
# as one, and X_y.cpp, where no header is its own, as the X.h that it includes. Includes are written from the root.
# A room of runtime/effect holds all of an effect; each part of it, by its name, has the place of the layer that it is of.
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
    order("dialogue", "partner conversation checking marking speech template english")
    order("runtime", "app lesson lua hearing render audio arms link progress evidence effect scene files text")
    # Inside a room that has rooms of its own.
    order("runtime/lua", "process host api sandbox wire")
}
function order(name, rooms,    list, n, i) {
    n = split(rooms, list, " ")
    for (i = 1; i <= n; ++i) rank[name "/" list[i]] = n - i + 1
}
function complain(why) { print $1 ":" $2 ": " why; bad = 1 }
# The layer of a part of an effect, or the path itself.
function layer_of(path,    part) {
    return split(path, part, "/") != 4 || path !~ /^runtime\/effect\// ? path : \
        part[4] ~ /^run_/ ? "runtime/app/" part[4] : part[4] ~ /^(play|show)_/ ? "runtime/lesson/" part[4] : \
        part[4] ~ /^declare_/ ? "runtime/lua/api/" part[4] : part[4] ~ /^wire_/ ? "runtime/lua/wire/" part[4] : \
        part[4] ~ /_fields\.h$/ ? path : "runtime/scene/" part[4]
}
# The inner room of a path, or nothing.
function inner_of(path,    part, n) { path = layer_of(path); n = split(path, part, "/"); return n > 3 ? part[1] "/" part[2] "/" part[3] : "" }
function room_of(path,    part, n) { path = layer_of(path); n = split(path, part, "/"); return n > 2 ? part[1] "/" part[2] : part[1] }
# A file, its source or header alike.
function stem(path) { sub(/\.[a-z]+$/, "", path); return path }
function file_of(path,    name) {
    for (name = stem(path); path !~ /h$/ && !((path, name ".h") in uses); ) if (!sub(/_[^_\/]*$/, "", name)) return stem(path)
    return name
}
# Tarjan 1972: what can be reached from each other is one circle.
function visit(file,    i, to) {
    reached[file] = lowest[file] = ++n_reached
    open[++n_open] = file
    for (i = 1; i <= n_targets[file]; ++i) {
        to = target[file, i]
        if (!(to in reached)) visit(to)
        if (!(to in circle) && lowest[to] < lowest[file]) lowest[file] = lowest[to]
    }
    if (lowest[file] != reached[file]) return
    ++n_circles
    do {
        to = open[n_open--]
        circle[to] = n_circles
        members[n_circles] = " " to members[n_circles]
    } while (to != file)
}
{
    included = $0
    sub(/^[^"]*"/, "", included)
    sub(/".*/, "", included)
    place[NR] = $1 ":" $2
    user[NR] = $1
    used[NR] = included
    uses[$1, included] = 1
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
END {
    for (i = 1; i <= NR; ++i) {
        user[i] = file_of(user[i])
        used_file[i] = stem(used[i])
        if (user[i] != used_file[i]) target[user[i], ++n_targets[user[i]]] = used_file[i]
    }
    for (i = 1; i <= NR; ++i) if (!(user[i] in reached)) visit(user[i])
    for (i = 1; i <= NR; ++i) {
        if (user[i] == used_file[i] || (c = circle[user[i]]) != circle[used_file[i]]) continue
        print place[i] ": \"" used[i] "\" closes the circle of" members[c]
        bad = 1
    }
    exit bad
}'
