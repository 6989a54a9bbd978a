#!/usr/bin/env bash
# joined_names.sh [ROOT]: fails where two sources of a room (haptics/device with its folders) call something of their own, in
# anonymous namespaces, by the same name: some builds compile them as one (cmake/join_sources.cmake). Functions may share a
# name with other parameters.
set -euo pipefail
cd "${1:-$(dirname -- "$0")/../..}"

find haptics dialogue runtime assets -name '*.cpp' | LC_ALL=C sort | xargs -r awk '
# own(NAME): the source at hand has it to itself.
function own(name,    key) {
    key = folder SUBSEP name
    if (key in first && first[key] != FILENAME) {
        print FILENAME ":" FNR ": " name " is called so in " first[key] " too: give them two names, or one header"
        bad = 1
    }
    first[key] = FILENAME
}
# types(PARAMETERS): without their names and defaults.
function types(parameters,    n, i, part, all) {
    n = split(parameters, part, ",")
    all = ""
    for (i = 1; i <= n; ++i) {
        sub(/ *=.*/, "", part[i])
        sub(/ *[a-zA-Z_0-9]+ *$/, "", part[i])
        gsub(/ /, "", part[i])
        all = all (i > 1 ? "," : "") part[i]
    }
    return all
}
FNR == 1 {
    inside = 0
    head = ""
    folder = FILENAME
    sub("/[^/]*$", "", folder)
    if (split(folder, part, "/") > 2) folder = part[1] "/" part[2]
}
/^namespace \{/ { inside = 1; next }
/^}  \/\/ namespace$/ { inside = 0; head = ""; next }
!inside { next }
head != "" { head = head " " $0 }
head == "" && /^(constexpr|const|inline|static) [^(]* k[A-Z][A-Za-z_0-9]*( =|\{|\[| =$)/ {
    match($0, / k[A-Z][A-Za-z_0-9]*/)
    own(substr($0, RSTART + 1, RLENGTH - 1))
    next
}
head == "" && /^using [A-Z]/ {
    # An alias may be told again, of the same.
    if (!($0 SUBSEP folder in aliases)) own($2)
    aliases[$0 SUBSEP folder] = 1
    next
}
head == "" && /^(struct|class|enum class|enum) [A-Z][A-Za-z_0-9]*/ {
    match($0, /[A-Z][A-Za-z_0-9]*/)
    if ($0 !~ /;$/) own(substr($0, RSTART, RLENGTH))
    next
}
head == "" && /^[a-zA-Z].*[ *&][a-z_0-9]+\(/ { head = $0 }
head != "" && /\{$|;$|\{ .*}$/ {
    if (head !~ /;$/ && match(head, /[a-z_0-9]+\(/)) {
        name = substr(head, RSTART, RLENGTH - 1)
        rest = substr(head, RSTART + RLENGTH)
        sub(/\)[^)]*$/, "", rest)
        own(name "(" types(rest) ")")
    }
    head = ""
}
END { exit bad }'
