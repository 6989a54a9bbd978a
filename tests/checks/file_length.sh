#!/usr/bin/env bash
# file_length.sh [ROOT]: fails on a source file of more than 400 lines: it holds two concepts.
set -euo pipefail
cd "${1:-$(dirname -- "$0")/../..}"

find haptics dialogue runtime scripts scenarios assets tests -path 'scripts/meta' -prune -o \
    \( -name '*.h' -o -name '*.cpp' -o -name '*.lua' -o -name '*.sh' \) -exec wc -l {} + |
    awk '$2 != "total" && $1 > 400 { print $2 ": " $1 " lines"; bad = 1 } END { exit bad }'
