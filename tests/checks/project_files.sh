#!/usr/bin/env bash
# project_files.sh [ROOT]: fails unless LICENSE and README.md are there, the README names each top folder in its table
# and no folder that is not there, and no file names a path of one machine.
set -euo pipefail
cd "${1:-$(dirname -- "$0")/../..}"

bad=0
complain() {
    echo "$*"
    bad=1
}
for file in LICENSE README.md packages.txt; do
    [[ -s $file ]] || complain "$file: missing"
done
[[ -f README.md ]] || exit 1
for folder in */; do
    [[ $folder == build/ ]] || grep -qE "^\| *\[?\`$folder\`" README.md || complain "README.md: no row of the folder table for $folder"
done
# shellcheck disable=SC2016 # the quotes are Markdown's
while read -r folder; do
    [[ -d $folder ]] || complain "README.md: the folder table names $folder, which is not there"
done < <(sed -nE 's/^\| *\[?`([a-z]+\/)`.*/\1/p' README.md)
if grep -rnI --exclude-dir=build --exclude-dir=node_modules --exclude-dir=.git -E '(^|[^A-Za-z0-9_.}])/(tm[p]|hom[e]|roo[t])/' .; then
    complain "fixed paths of one machine: make scratch folders with mktemp"
fi
exit "$bad"
