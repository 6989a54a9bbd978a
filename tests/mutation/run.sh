#!/usr/bin/env bash
# tests/mutation/run.sh [ID…]: makes each change of changes.tsv in a copy of the committed tree, builds the test programs
# that the change concerns, and runs test by test until one fails: first those of the change's own room. Says which test
# caught it in build/mutation/result.tsv; README.md has the columns. Without an ID it goes on where it was stopped, until
# $MUTATION_WANTED changes (72) are judged; with IDs those are tried again.
#
# FULCRUM_JOBS: how many compilers and tests run at once; MUTATION_LIMIT_S: time for one program's tests of a change (3600).
set -euo pipefail
here=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")" && pwd)
root=$(cd -- "$here/../.." && pwd)
table=$here/changes.tsv
work=$root/build/mutation
tree=$work/tree
build=$tree/build/dev
result=$work/result.tsv
jobs=${FULCRUM_JOBS:-$(nproc)}
wanted=${MUTATION_WANTED:-72}
export LIMIT_S=${MUTATION_LIMIT_S:-3600}
export TEST_LIMIT_S=120            # as ctest has it
export RC_PARAMS="seed=1"          # the same random inputs for each change

# programs_of AREA ROOM: what tests a change there, the room's own tests first.
programs_of() {
    local all own=test_unit_$1_$2
    all=$(ninja -C "$build" -t targets all | sed -nE "s,^tests/(test_unit_$1[a-z_]*): .*,\\1,p")
    grep -xF "$own" <<<"$all" || true
    grep -vxF "$own" <<<"$all"
    [[ $1 != haptics ]] || printf '%s\n' test_stability stability_cases
}

say() { printf '%s\n' "$*" >&2; }
die() {
    say "mutation: $*"
    exit 2
}

# ---- what is started can be stopped -------------------------------------------------------------------------------

group=
end_group() {
    [[ -z $group ]] || kill -KILL -- "-$group" 2>/dev/null || true
    group=
}

# attempt COMMAND…: in a process group of its own, of which nothing stays behind.
attempt() {
    local status=0
    set -m
    "$@" </dev/null &
    group=$!
    set +m
    wait "$group" || status=$?
    end_group
    return "$status"
}

restore() { [[ ! -d $tree/.git ]] || git -C "$tree" checkout -q -- .; }
leave() {
    trap - EXIT INT TERM HUP
    end_group
    restore
    exit "$1"
}
trap 'leave $?' EXIT
trap 'leave 130' INT
trap 'leave 143' TERM HUP

# ---- the copy -----------------------------------------------------------------------------------------------------

# What the results depend on: of all that is committed the code, its tests and how they are built.
tree_key() {
    git -C "$root" ls-tree HEAD haptics dialogue cmake CMakeLists.txt CMakePresets.json tests/CMakeLists.txt tests/support \
        tests/stability tests/unit | git hash-object --stdin | cut -c 1-12
}

prepare() {
    local key commit
    commit=$(git -C "$root" rev-parse HEAD)
    key=$(tree_key)
    mkdir -p "$work"
    exec {lock}>"$work/.lock"
    flock -n "$lock" || die "build/mutation: another run is at work; wait for it or stop it"
    [[ -z $(git -C "$root" status --porcelain haptics dialogue tests/unit tests/stability tests/support cmake) ]] ||
        say "What is not committed is not tried."
    if [[ ! -d $tree/.git ]]; then
        git clone -q --shared "$root" "$tree" || die "build/mutation: the tree could not be copied"
    fi
    restore
    # Only what differs is written, so that only that is built again.
    git -C "$tree" checkout -q --detach "$commit"
    if [[ -f $result && $(head -n 1 "$result") != "# tree $key" ]]; then
        mv -- "$result" "$work/result-$(sed -n '1s/^# tree //p' "$result").tsv"
    fi
    [[ -f $result ]] || printf '# tree %s\nid\tresult\tby\tseconds\n' "$key" >"$result"
    awk -v root="$tree" -f "$here/apply.awk" "$table" >&2 || die "changes.tsv does not fit the tree; mend the rows above"
    # Warnings of a changed law, such as a name that it no longer uses, are no errors.
    attempt cmake -S "$tree" -B "$build" --preset dev -DFULCRUM_WERROR=OFF >"$work/configure.log" 2>&1 ||
        die "CMake could not configure; $work/configure.log says why"
}

# build PROGRAM…: false when the compiler refuses; any other failure ends the run.
build() {
    attempt ninja -C "$build" -j "$jobs" "$@" >"$work/build.log" 2>&1 && return
    grep -qE ':[0-9]+: error: ' "$work/build.log" || die "the build failed, and not of the change; $work/build.log says why"
    return 1
}

# ---- tests --------------------------------------------------------------------------------------------------------

# list_tests PROGRAM: writes the names of its tests.
list_tests() {
    local out=$work/$1.names status=0 n
    (cd "$build/tests" && "./$1" --list-test-names-only) >"$out" || status=$?
    # It returns how many there are, 255 where there are more.
    n=$(wc -l <"$out")
    ((status == (n < 255 ? n : 255))) || die "$1 cannot list its tests: it ended with $status after $n names"
}

# try_one PROGRAM NAME FAILED: as ctest would, in a process of its own. What fails is run again, so that nothing is caught by
# a busy machine. 255 tells xargs to start no more.
try_one() {
    local pattern status=0
    # shellcheck disable=SC2001
    pattern=$(sed 's/[],["]/\\&/g' <<<"$2") # Catch2 reads a pattern
    ulimit -c 0 -v 16000000
    [[ $(date +%s) -lt $DEADLINE ]] || status=124
    for _ in 1 2; do
        ((status == 124)) || { timeout --foreground -s KILL "$TEST_LIMIT_S" "./$1" "$pattern" >/dev/null 2>&1 && return; status=$?; }
    done
    # KILL: its time was up.
    if ((status == 124 || status == 137)); then
        printf 'timed out\t%s: %s\n' "${1#test_}" "$2" >>"$3"
    else
        printf 'caught\t%s: %s\n' "${1#test_}" "$2" >>"$3"
    fi
    [[ $EACH == all ]] || exit 255
}
export -f try_one

# try_all PROGRAM NAMES: false when one of them fails; which then stands in $work/failed.
try_all() {
    : >"$work/failed"
    # shellcheck disable=SC2016 # expanded by the inner shell
    attempt bash -c 'cd "$1" && tr "\n" "\0" <"$2" | xargs -0 -r -P "$3" -I{} bash -c '\''try_one "$0" "$1" "$2"'\'' "$4" {} "$5"' _ \
        "$build/tests" "$2" "$jobs" "$1" "$work/failed" 2>/dev/null || true
    [[ ! -s $work/failed ]]
}

# note ID RESULT BY SECONDS: in the place of what stood there.
note() {
    local kept
    kept=$(awk -F '\t' -v id="$1" '$1 != id' "$result")
    printf '%s\n%s\t%s\t%s\t%s\n' "$kept" "$@" >"$result.new"
    mv -f -- "$result.new" "$result"
}

# result_of ID: empty when it was not tried yet.
result_of() { awk -F '\t' -v id="$1" '$1 == id { print $2 }' "$result"; }

# The tree as it stands must pass, or a change would be caught by what fails without it.
try_unchanged() {
    local area=$1 begun=$SECONDS program
    [[ $(result_of "unchanged $area") != passes ]] || return 0
    mapfile -t list < <(programs_of "$area" "")
    say "$area, unchanged: building ${#list[@]} programs …"
    build "${list[@]}" || die "the unchanged tree does not compile; $work/build.log says why"
    for program in "${list[@]}"; do
        list_tests "$program"
        say "$area, unchanged: running $(wc -l <"$work/$program.names") tests of $program …"
        if ! EACH=all DEADLINE=9999999999 try_all "$program" "$work/$program.names"; then
            cut -f 2 "$work/failed" >&2
            die "these tests fail without any change; mend them first"
        fi
    done
    note "unchanged $area" passes "${#list[@]} programs" "$((SECONDS - begun))"
}

# ---- changes ------------------------------------------------------------------------------------------------------

# try_change ID FILE: notes what came of it.
try_change() {
    local id=$1 file=$2 area room begun=$SECONDS program outcome=survived by=
    IFS=/ read -r area room _ <<<"$file"
    awk -v root="$tree" -v id="$id" -f "$here/apply.awk" "$table"
    for program in $(programs_of "$area" "$room"); do
        if ! build "$program"; then
            outcome='does not compile'
            break
        fi
        DEADLINE=$(($(date +%s) + LIMIT_S))
        export DEADLINE EACH=one
        if ! try_all "$program" "$work/$program.names"; then
            IFS=$'\t' read -r outcome by <"$work/failed"
            break
        fi
    done
    restore
    note "$id" "$outcome" "$by" "$((SECONDS - begun))"
    say "    $outcome${by:+ by $by} ($((SECONDS - begun)) s)"
}

n_judged() { awk -F '\t' '$1 ~ /^[0-9]/ && $2 != "does not compile"' "$result" | wc -l; }

for id in "$@"; do
    grep -q "^$id"$'\t' "$table" || die "changes.tsv has no row $id; its ids have three digits"
done
prepare
while IFS=$'\x1f' read -r -u 3 id kind file text changed equivalent; do
    if [[ $# -eq 0 ]]; then
        (($(n_judged) < wanted)) || break
        [[ -z $(result_of "$id") ]] || continue
    elif [[ " $* " != *" $id "* ]]; then
        continue
    fi
    if [[ -n $equivalent ]]; then
        say "$id $file: no change: $equivalent"
        continue
    fi
    try_unchanged "${file%%/*}"
    say "[$(n_judged)/$wanted] $id $file: $kind"
    say "    $text"
    say "    $changed"
    try_change "$id" "$file"
done 3< <(tail -n +2 "$table" | tr '\t' '\037')
awk -F '\t' '$1 ~ /^[0-9]/ { n[$2]++ } END { for (what in n) { print n[what] "\t" what } }' "$result" | sort -k 2
