#!/usr/bin/env bash
# tests/mutation/draw.sh [SEED [ROWS]]: draws changes from the laws, one from each room in turn, and prints them as
# changes.tsv has them. Left out is what no test may reach: the recogniser's own program.
set -euo pipefail
here=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")" && pwd)
cd "$here/../.."
mapfile -t files < <(find haptics dialogue \( -name '*.cpp' -o -name '*.h' \) ! -path dialogue/speech/sphinx/main.cpp |
    LC_ALL=C sort)
LC_ALL=C awk -v seed="${1:-1}" -v rows="${2:-104}" -f "$here/draw.awk" "${files[@]}"
