#!/usr/bin/env bash
# merge_markers.sh [ROOT]: fails on the lines that a merge leaves where it could not decide.
set -euo pipefail
cd "${1:-$(dirname -- "$0")/../..}"

# Written so that this file has none itself. A line of seven equals signs alone may stand under a heading, so it is none.
markers='^(<{7}|[|]{7}|>{7})( |$)'
found=0
if git rev-parse --is-inside-work-tree >/dev/null 2>&1; then
    git grep -nIE --untracked "$markers" || found=$?
else
    grep -rnIE --exclude-dir=.git "$markers" . || found=$?
fi
# 0: found some; 2 and more: grep itself failed.
[[ $found -eq 1 ]] || { echo 'a merge was not finished: keep what belongs in, and take its marks out'; exit 1; }
