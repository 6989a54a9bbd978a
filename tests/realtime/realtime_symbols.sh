#!/usr/bin/env bash
# realtime_symbols.sh ARCHIVE [all] [-OBJECT]... [OBJECT[=LOAD_PATH]]...: fails when a function of the judged objects calls what a
# real-time thread must not: allocation, locks, waiting, files, logging, exceptions thrown, Lua. With "all" every object of the
# archive is judged but those behind "-"; without it those that are named. LOAD_PATH is a regular expression of functions that
# only load (constructors, validate) and are passed over. An object that is named and is missing in the archive, or that has no
# function left to judge, is a failure too.
set -euo pipefail
archive=$1
shift

forbidden='operator (new|delete)|\<(m|c|re)alloc[-+@>]|\<free[-+@>]|aligned_alloc|posix_memalign|\<mmap[-+@>]'
forbidden+='|pthread_(mutex|cond|rwlock|create|join)|\<sem_|__cxa_(throw|allocate_exception|guard_acquire)|std::__throw'
forbidden+='|nanosleep|\<u?sleep[-+@>]|\<poll[-+@>]|\<select[-+@>]|printf|\<puts[-+@>]|\<f?open(64)?[-+@>]|\<f(write|read|flush)[-+@>]'
forbidden+='|\<(write|read)[-+@>]|std::(basic_)?[io]?stream|std::ios|std::__cxx11|std::function|std::vector<.*::(reserve|resize|_M_)'
forbidden+='|syslog|\<lua_|\<luaL_|\<exit[-+@>]'

command -v objdump >/dev/null || { echo "objdump (binutils) is needed"; exit 1; }
present=$(ar t "$archive" | LC_ALL=C sort)
bad=0
declare -A passed_over=() load_path=()
judged=()
for argument in "$@"; do
    object=${argument#-}
    object=${object%%=*}
    [[ $argument == all ]] || grep -qxF -- "$object" <<<"$present" ||
        { echo "$object: is not in $archive"; bad=1; continue; }
    case $argument in
        all) mapfile -t judged <<<"$present" ;;
        -*) passed_over[$object]=1 ;;
        *)
            [[ $argument != *=* ]] || load_path[$object]=${argument#*=}
            [[ $1 == all ]] || judged+=("$object")
            ;;
    esac
done
[[ $(uniq -d <<<"$present") == "" ]] || { echo "two objects of one name: $(uniq -d <<<"$present")"; bad=1; }

# Every called or referred to symbol, behind its object and the function it stands in.
all_calls=$(objdump -dr --no-show-raw-insn -C "$archive" | awk '
    /file format/ { object = $1; sub(/:$/, "", object); next }
    /^[0-9a-f]+ <.*>:$/ { name = $0; sub(/^[0-9a-f]+ </, "", name); sub(/>:$/, "", name); print object "\t" name "\t"; next }
    / R_/ || /(call|jmp) / { gsub(/\t/, " "); print object "\t" name "\t" $0 }')
for object in "${judged[@]}"; do
    [[ -z ${passed_over[$object]:-} ]] || continue
    calls=$(awk -F '\t' -v object="$object" -v pass="${load_path[$object]:-}" \
        '$1 == object && (pass == "" || $2 !~ pass) { print $2 "\t" $3 }' <<<"$all_calls")
    [[ -n $calls ]] || { echo "$object: nothing in it is left to judge"; bad=1; continue; }
    # Copies of the standard library's functions are judged where they are called.
    found=$(awk -F '\t' '$1 !~ /^([a-z]+ )?(std::|fulcrum::fail\()/' <<<"$calls" | grep -E $'\t.*('"$forbidden"')' || true)
    if [[ -n $found ]]; then
        echo "$object:"
        sed -n 1,5p <<<"$found"
        bad=1
    fi
done
exit $bad
