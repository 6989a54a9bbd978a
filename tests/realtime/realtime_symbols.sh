#!/usr/bin/env bash
# realtime_symbols.sh ARCHIVE [all] [-SOURCE]... [SOURCE[=LOAD_PATH]]...: fails when a function of the judged sources calls what a
# real-time thread must not: allocation, locks, waiting, files, logging, exceptions thrown, Lua. With "all" every source of the
# archive is judged but those behind "-"; without it those that are named. LOAD_PATH is a regular expression of functions that
# only load (constructors, validate) and are passed over. A source that is named and is missing in the archive, or that has no
# function left to judge, is a failure too. Of an object that several sources were joined into, debug information tells whose a
# function is; what a header defines belongs to all of them. Passed over and judged sources in one object are a failure.
set -euo pipefail
archive=$1
shift

forbidden='operator (new|delete)|\<(m|c|re)alloc[-+@>]|\<free[-+@>]|aligned_alloc|posix_memalign|\<mmap[-+@>]'
forbidden+='|pthread_(mutex|cond|rwlock|create|join)|\<sem_|__cxa_(throw|allocate_exception|guard_acquire)|std::__throw'
forbidden+='|nanosleep|\<u?sleep[-+@>]|\<poll[-+@>]|\<select[-+@>]|printf|\<puts[-+@>]|\<f?open(64)?[-+@>]|\<f(write|read|flush)[-+@>]'
forbidden+='|\<(write|read)[-+@>]|std::(basic_)?[io]?stream|std::ios|std::__cxx11|std::function|std::vector<.*::(reserve|resize|_M_)'
forbidden+='|syslog|\<lua_|\<luaL_|\<exit[-+@>]'

command -v objdump >/dev/null || { echo "objdump (binutils) is needed"; exit 1; }
bad=0

# Lines "object<tab>source", one for each source of the archive.
archive_name=$(basename "$archive" .a)
joined_folder=$(dirname "$archive")/CMakeFiles/${archive_name#lib}.dir/Unity
list_sources() {
    local object
    for object in $(ar t "$archive"); do
        if [[ $object == unity_* ]]; then
            sed -nE "s|^#include \".*/([^/]*)\"$|$object\t\1|p" "$joined_folder/${object%.o}"
        else
            printf '%s\t%s\n' "$object" "${object%.o}"
        fi
    done
}
owners=$(list_sources)
present=$(cut -f 2 <<<"$owners" | LC_ALL=C sort)
[[ $(uniq -d <<<"$present") == "" ]] || { echo "two sources of one name: $(uniq -d <<<"$present")"; bad=1; }

declare -A passed_over=() load_path=()
judged=()
for argument in "$@"; do
    source=${argument#-}
    source=${source%%=*}
    [[ $argument == all ]] || grep -qxF -- "$source" <<<"$present" ||
        { echo "$source: is not in $archive"; bad=1; continue; }
    case $argument in
        all) mapfile -t judged <<<"$present" ;;
        -*) passed_over[$source]=1 ;;
        *)
            [[ $argument != *=* ]] || load_path[$source]=${argument#*=}
            [[ $1 == all ]] || judged+=("$source")
            ;;
    esac
done

# Every called or referred to symbol, behind its source ("object" alone for what a header defines) and the function it stands in.
all_calls=$(awk -F '\t' '
    FILENAME == ARGV[1] { split($0, names, "\t"); n[names[1]]++; only[names[1]] = names[2]; next }
    FILENAME == ARGV[2] {
        if ($0 ~ /^[^ ]+\.o:$/) { object = $0; sub(/:$/, "", object); next }
        name = $1; sub(/^[0-9a-f]+ . /, "", name)
        file = $2; sub(/:[0-9?]+$/, "", file); sub(/^.*\//, "", file)
        if (file ~ /\.cpp$/) of[object, name] = file
        next
    }
    /file format/ { object = $0; sub(/:.*$/, "", object); next }
    /^[0-9a-f]+ <.*>:$/ {
        name = $0; sub(/^[0-9a-f]+ </, "", name); sub(/>:$/, "", name)
        source = n[object] == 1 ? only[object] : ((object, name) in of) ? of[object, name] : object
        print source "\t" name "\t"
        next
    }
    / R_/ || /(call|jmp) / { gsub(/\t/, " "); print source "\t" name "\t" $0 }' \
    <(printf '%s\n' "$owners") <(nm -lC --defined-only "$archive" 2>/dev/null) <(objdump -dr --no-show-raw-insn -C "$archive"))

# Who is judged, and what is passed over in each: lines "name<tab>pattern". Of a joined object its headers too, by the patterns of
# all that was joined; they may be empty.
declare -A object_of=() passes=() mixed=() headers=()
while IFS=$'\t' read -r object source; do
    object_of[$source]=$object
    passes[$object]+=${load_path[$source]:+|${load_path[$source]}}
    mixed[$object]+=${passed_over[$source]:-0}
done <<<"$owners"
rules=
for source in "${judged[@]}"; do
    [[ -z ${passed_over[$source]:-} ]] || continue
    object=${object_of[$source]}
    [[ ${mixed[$object]} != *1* ]] || { echo "$object: holds load path and step path, $source"; bad=1; }
    rules+=$source$'\t'${load_path[$source]:-}$'\n'
    [[ $object == "$source.o" ]] || headers[$object]=${passes[$object]#|}
done
for object in "${!headers[@]}"; do
    rules+=$object$'\t'${headers[$object]}$'\n'
done

# What they call in functions that are not passed over: lines "name<tab>function<tab>call", and "name<tab>" where there is none.
# Copies of the standard library's functions are judged where they are called.
calls=$(awk -F '\t' '
    FILENAME == ARGV[1] { if ($1 != "") { pattern[$1] = $2; left[$1] = 0 } next }
    $1 in pattern && (pattern[$1] == "" || $2 !~ pattern[$1]) {
        left[$1]++
        if ($2 !~ /^([a-z]+ )?(std::|fulcrum::fail\()/) print
    }
    END { for (name in left) if (!left[name] && name !~ /\.o$/) print name "\t" }' <(printf '%s' "$rules") <(printf '%s\n' "$all_calls"))
while IFS=$'\t' read -r name _; do
    echo "$name: nothing in it is left to judge"
    bad=1
done < <(awk -F '\t' 'NF == 2' <<<"$calls")
found=$(grep -E $'\t.*\t.*('"$forbidden"')' <<<"$calls" || true)
if [[ -n $found ]]; then
    awk -F '\t' '$1 != last { print $1 ":"; last = $1; n = 0 } n++ < 5 { print $2 "\t" $3 }' <<<"$found"
    bad=1
fi
exit $bad
