#!/usr/bin/env bash
# class_sources.sh [ROOT]: fails where a class has its methods in more than two sources (build and step). A class that needs more is several.
set -euo pipefail
cd "${1:-$(dirname -- "$0")/../..}"

find haptics dialogue runtime -name '*.cpp' | LC_ALL=C sort | { xargs -r grep -HoE '^[A-Za-z].*[^A-Za-z_:][A-Z][A-Za-z]+::~?[A-Za-z_]+\(|^[A-Z][A-Za-z]+::~?[A-Za-z_]+\(' || true; } | awk -F: '
{
    file = $1
    line = substr($0, length(file) + 2)
    if (line ~ / = |return /) next
    sub(/\($/, "", line)
    sub(/::~?[A-Za-z_]+$/, "", line)
    sub(/^.*[^A-Za-z]/, "", line)
    if (!((line, file) in seen)) {
        seen[line, file] = 1
        files[line] = files[line] " " file
        ++n[line]
    }
}
END {
    for (name in n) {
        if (n[name] > 2) { print name " has its methods in " n[name] " sources:" files[name]; bad = 1 }
    }
    exit bad
}'
