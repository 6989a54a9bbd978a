#!/usr/bin/env bash
# open_recogniser.sh ROOT: speaks to examples/open-recogniser/hear.mjs in lines. Nothing is installed for it: the model is one
# that takes samples for letters, and without one there is a sentence.
set -euo pipefail
command -v node >/dev/null || { echo "no node: skipped"; exit 77; }
cd "$1"
node tests/system/open_recogniser.mjs
# Every package of the lock file has its hash, and no place of its own to come from.
node -e '
const { packages } = require("./examples/open-recogniser/package-lock.json");
for (const [name, entry] of Object.entries(packages)) {
  if (name !== "" && !/^sha512-/.test(entry.integrity ?? "")) throw new Error(`${name} has no hash`);
  if (entry.resolved !== undefined) throw new Error(`${name} names its registry`);
}'
