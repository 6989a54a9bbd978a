#!/usr/bin/env bash
# changes_apply.sh [ROOT]: fails on a row of tests/mutation/changes.tsv that no longer fits the tree: its text stands in its
# file not exactly once, or would stay as it is.
set -euo pipefail
mutation=$(cd -- "$(dirname -- "$0")/../mutation" && pwd)
cd "${1:-$mutation/../..}"

awk -v root=. -f "$mutation/apply.awk" tests/mutation/changes.tsv
