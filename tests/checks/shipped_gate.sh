#!/usr/bin/env bash
# shipped_gate.sh [ROOT]: fails on a test that gives a plan's or an arm's gate another slew than ships, unless its title says so; and counts those that do.
# What ships is what is tested. Benchmarks may draw it against other slews. The gate's own tests (safety*_test.cpp) try all of its settings and are not looked at.
set -euo pipefail
cd "${1:-$(dirname -- "$0")/../..}"

find tests -path tests/bench -prune -o -type f \( -name '*.h' -o -name '*.cpp' \) ! -name 'safety*_test.cpp' -print0 | sort -z |
    xargs -0 awk '
        FNR == 1 { title = ""; open = 0 }
        /TEST_CASE\(/ { title = ""; open = 1 }
        open { title = title $0; if (/\{[ ]*$/) { open = 0 } }
        /safety\.max_slew_N_per_s *=[^=]/ {
            if (title ~ /slew/) { ++n } else { print FILENAME ":" FNR ": another slew than ships, and the title of no test says so"; bad = 1 }
        }
        END { print n + 0 " with another slew, by their titles"; exit bad }'
