#!/usr/bin/env bash
# figures.sh [ROOT]: fails where a figure of docs/measured.md, or of a CSV under tests/bench/figures, names no commit, or no command
# that can be given here. Lists the figures whose sources have changed since their commit: they want measuring again.
#
# A table has columns "command" and "commit", or stands below a line "Measured by `COMMAND` at COMMIT". A row that is "not measured yet"
# has the commit "-", and its command may be one that is still to come.
set -euo pipefail
cd "${1:-$(dirname -- "$0")/../..}"

bad=0
complain() {
    echo "$*"
    bad=1
}

# ---- what can be given as a command --------------------------------------------------------------------------------

# "NAME FILE" of each benchmark.
benches=$(awk '/^const Registration / { open = 1 }
    open && match($0, /"[a-z0-9-]+"/) { print substr($0, RSTART + 1, RLENGTH - 2), FILENAME; open = 0 }' tests/bench/curves/*.cpp)
verbs=$(sed -nE -e 's/^#   \.\/fulcrum ([a-z]+).*/\1/p' -e 's/^ +\{"([a-z]+)", [a-z_]+, .*/\1/p' fulcrum runtime/app/option_table.cpp)
program="assets cmake dialogue haptics runtime scenarios scripts"

# What a benchmark is made of: its file, what that includes, and the source beside each header.
declare -A parts
while read -r name files; do
    parts[$name]=$files
done < <(grep -rHoE --include='*.h' --include='*.cpp' '^#include "[^"]+"' dialogue haptics runtime tests/bench tests/stability tests/support |
    awk -v benches="$benches" '
        { file = $0; sub(/:.*/, "", file); gsub(/.*#include "|"/, ""); has[file] = has[file] " " $0 }
        function take(file) { if (!(file in seen)) { seen[file] = 1; list[++n] = file } }
        END {
            count = split(benches, line, "\n")
            for (b = 1; b <= count; ++b) {
                split(line[b], word, " ")
                split("", seen)
                n = 0
                take(word[2])
                printf "%s", word[1]
                for (i = 1; i <= n; ++i) {
                    printf " %s", list[i]
                    m = split(has[list[i]], included, " ")
                    for (k = 1; k <= m; ++k) take(included[k])
                    source = list[i]
                    if (sub(/[.]h$/, ".cpp", source) && source in has) take(source)
                }
                print ""
            }
        }')

# sources_of COMMAND: sets `sources`, or `why` not.
sources_of() {
    local word=${1%% *} own='(^|[ (])(\./)?fulcrum ([a-z]+)(.*)'
    sources='' why=''
    if [[ ! $1 =~ $own || $word == */*.sh ]]; then
        [[ $word == ctest || -x $word && ! -d $word ]] || why="\"$word\" is no program of the project's"
        sources="$program tests .ci fulcrum"
    elif [[ ${BASH_REMATCH[3]} == bench ]]; then
        for word in ${BASH_REMATCH[4]}; do
            [[ $word != -* ]] || break
            sources+=" ${parts[$word]:-}"
            [[ -n ${parts[$word]:-} ]] || why="no benchmark is called $word"
        done
        sources=${sources:-${parts[*]}}
    else
        word=${BASH_REMATCH[3]}
        grep -qxF -- "$word" <<<"$verbs" || why="the program knows no command $word"
        sources=$program
        [[ $word != test ]] || sources+=" tests fulcrum"
    fi
}

# ---- the figures ---------------------------------------------------------------------------------------------------

# PLACE, WHAT, COMMANDS with | between them, COMMIT and STATE of each figure, with a letter between them that no text has.
figures() {
    awk -F ' *[|] *' -v OFS='\037' '
        # Of the code in a text, what is a command.
        function commands(text,    found, code) {
            while (match(text, /`[^`]+`/)) {
                code = substr(text, RSTART + 1, RLENGTH - 2)
                text = substr(text, RSTART + RLENGTH)
                if (code ~ /(^|[ \/])fulcrum [a-z]|^(ctest|tests\/[^ ]+[.]sh|[.]ci\/[a-z]+)( |$)/) found = found (found ? "|" : "") code
            }
            return found ? found : "-"
        }
        FNR == 1 || /^#/ { above = "-"; commit_above = "" }
        /^Measured by `/ { above = commands($0); commit_above = $0; sub(/.*` at /, "", commit_above); sub(/[^0-9a-z].*/, "", commit_above) }
        !/^[|]/ { row = 0; next }
        ++row == 1 { own = $(NF - 1) == "commit" && $(NF - 2) == "command" }
        row > 2 && own {
            state = index($0, "| not measured yet |") ? "open" : "measured"
            print FILENAME ":" FNR, substr($2, 1, 70), commands($(NF - 2)), $(NF - 1), state
        }
        row == 3 && !own { print FILENAME ":" FNR, "this table", above, commit_above, "measured" }' docs/measured.md
    # A CSV is called after its benchmark.
    local csv name commit
    for csv in tests/bench/figures/*.csv; do
        name=$(basename "$csv" .csv)
        while [[ -z ${parts[$name]:-} && $name == *-* ]]; do name=${name%-*}; done
        commit=$(sed -n 's/^# commit: \([0-9a-f]*\)+\?$/\1/p' "$csv")
        printf '%s\037its figure\037%s %s\037%s\037measured\n' "$csv" "$(sed -n 's/^# command: \(fulcrum bench\).*/\1/p' "$csv")" "$name" "$commit"
    done
}

has_history=no
git cat-file -e HEAD 2>/dev/null && has_history=yes
n=0 n_old=0
while IFS=$'\037' read -r place what given commit state; do
    n=$((n + 1))
    [[ $given != - ]] || { complain "$place: $what: no command" && continue; }
    [[ $state != open || $commit != - ]] || continue
    if [[ ! $commit =~ ^[0-9a-f]{7,40}$ ]]; then
        complain "$place: $what: \"$commit\" is no commit"
    fi
    all=''
    IFS='|' read -ra commands <<<"$given"
    for command in "${commands[@]}"; do
        sources_of "$command"
        [[ -z $why ]] || complain "$place: $what: $why"
        all+=" $sources"
    done
    [[ $bad == 0 && $has_history == yes ]] || continue
    # shellcheck disable=SC2086 # one word a file
    changed=$(git diff --name-only "$commit" -- $all ':!*.md' 2>/dev/null) || changed="its commit is not in this history"
    [[ -z $changed ]] || { n_old=$((n_old + 1)) && echo "to be measured again: $place: $what: $commit, ${changed%%$'\n'*}"; }
done < <(figures)
((n_old == 0)) || echo "Of $n figures $n_old are older than their sources; behind each the first file that has changed since."
exit "$bad"
