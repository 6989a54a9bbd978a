#!/usr/bin/env bash
# pages.sh [ROOT]: fails on a README.md of more than 120 lines at the top, and on a link between pages that leads to no file
# or no heading.
set -euo pipefail
cd "${1:-$(dirname -- "$0")/../..}"

bad=0
complain() {
    echo "$*"
    bad=1
}

most_lines=120
lines=$(wc -l <README.md)
((lines <= most_lines)) || complain "README.md: $lines lines, more than $most_lines: it is the front door, what is behind it belongs in docs/"

# What a page says outside of its fenced code, each line behind its number.
prose() { awk '/^ *```/ { fenced = !fenced; next } !fenced { print FNR ":" $0 }' "$1"; }

# A page's headings as a link names them.
headings() { prose "$1" | sed -nE 's/^[0-9]+:#+ +//p' | tr '[:upper:] ' '[:lower:]-' | sed -E 's/[^[:alnum:]_-]//g'; }

# FILE:LINE and TARGET of each link; code in a line is no link.
links() {
    local page
    # shellcheck disable=SC2016 # the quotes are Markdown's
    for page; do
        prose "$page" | sed -E 's/`[^`]*`//g' | awk -v page="$page" '{
            line = $0
            sub(/:.*/, "", line)
            while (match($0, /\]\([^()]*\)/)) {
                print page ":" line "\t" substr($0, RSTART + 2, RLENGTH - 3)
                $0 = substr($0, RSTART + RLENGTH)
            }
        }'
    done
}

mapfile -t pages < <(find . -name '*.md' -not -path './build/*' -not -path '*/node_modules/*' -printf '%P\n' | LC_ALL=C sort)
while IFS=$'\t' read -r where target; do
    [[ ! $target =~ ^[a-z]+: ]] || continue # another place's
    page=${where%:*}
    file=$page
    [[ $target == '#'* ]] || file=$(dirname -- "$page")/${target%%#*}
    if [[ ! -e $file ]]; then
        complain "$where: ($target) leads to no file"
    elif [[ $target == *'#'* ]] && ! headings "$file" | grep -qxF -- "${target#*#}"; then
        complain "$where: ($target) leads to no heading of $file"
    fi
done < <(links "${pages[@]}")
exit "$bad"
