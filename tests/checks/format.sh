#!/usr/bin/env bash
# format.sh [ROOT]: fails on C++ that clang-format would write differently; 77, which ctest reports as skipped, where
# there is no clang-format. Mends it all: tests/checks/format.sh --list | xargs clang-format -i
set -euo pipefail
list=0
if [[ ${1:-} == --list ]]; then
    list=1
    shift
fi
cd "${1:-$(dirname -- "$0")/../..}"

command -v clang-format >/dev/null || exit 77
# Many at once, for starting takes most of its time; one by one where something is wrong among them.
# shellcheck disable=SC2016 # expanded by the inner shell
wrong=$(find haptics dialogue runtime assets tests \( -name '*.h' -o -name '*.cpp' \) -print0 |
    xargs -0 -r -P "$(nproc)" -n 40 bash -c 'clang-format --dry-run --Werror "$@" 2>/dev/null || for file; do
        clang-format --dry-run --Werror "$file" 2>/dev/null || printf "%s\n" "$file"; done' _ | LC_ALL=C sort)
[[ -n $wrong ]] || exit 0
printf '%s\n' "$wrong"
((list)) || { echo "clang-format writes these differently; mend them with: tests/checks/format.sh --list | xargs clang-format -i"; exit 1; }
