#!/usr/bin/env bash
# same_bits.sh [ROOT]: fails on what gives other bits from run to run, so that a record would not replay: Eigen's stable norms
# sum in an order that depends on where the vector lies in memory, and {} for one of two vectors, as in {{x, y, z}, {}},
# leaves that one unset.
set -euo pipefail
cd "${1:-$(dirname -- "$0")/../..}"
failed=0

# forbid WHERE ADVICE PATTERN…: grep's 0 is some found, 2 that it failed itself.
forbid() {
    local where=$1 advice=$2 found=0
    shift 2
    # shellcheck disable=SC2086
    grep -rnE --include='*.h' --include='*.cpp' "$@" $where || found=$?
    [[ $found -eq 1 ]] || failed=1
    [[ $found -ne 0 ]] || echo "$advice"
}

forbid 'haptics dialogue runtime' 'use compute_length or compute_direction of haptics/math/length.h instead' \
    -e '\.(stableNorm|stableNormalized?|blueNorm)\('
forbid '.' 'write Vector3::Zero() for the vector that is {}' \
    --exclude-dir=build --exclude-dir=.git \
    -e '\{\{[^{}]*,[^{}]*,[^{}]*\}, \{\}\}' -e '\{\{\}, (Vector3|\{[^{}]*,[^{}]*,[^{}]*\}\})' -e '\{Vector3[^{}]*\), \{\}\}'
exit "$failed"
