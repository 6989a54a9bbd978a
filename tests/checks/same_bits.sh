#!/usr/bin/env bash
# same_bits.sh [ROOT]: fails on what gives other bits from run to run, so that a record would not replay: Eigen's stable norms
# sum in an order that depends on where the vector lies in memory.
set -euo pipefail
cd "${1:-$(dirname -- "$0")/../..}"

found=0
grep -rnE --include='*.h' --include='*.cpp' '\.(stableNorm|stableNormalized?|blueNorm)\(' haptics dialogue runtime || found=$?
# 0: found some; 2: grep itself failed.
[[ $found -eq 0 ]] && echo "use compute_length or compute_direction of haptics/math/length.h instead"
[[ $found -eq 1 ]]
