#!/usr/bin/env bash
# realtime_symbols.sh ARCHIVE OBJECT[=LOAD_PATH]...: fails when a function of these objects calls what a real-time thread must
# not: allocation, locks, waiting, files, logging, exceptions thrown, Lua. LOAD_PATH is a regular expression of functions that
# only load (constructors, validate) and are passed over; an object without one is judged whole. An object that is missing in
# the archive, or that has no function left to judge, is a failure too.
set -euo pipefail
archive=$1
shift

forbidden='operator (new|delete)|\<(m|c|re)alloc[-+@>]|\<free[-+@>]|aligned_alloc|posix_memalign|\<mmap[-+@>]'
forbidden+='|pthread_(mutex|cond|rwlock|create|join)|\<sem_|__cxa_(throw|allocate_exception|guard_acquire)|std::__throw'
forbidden+='|nanosleep|\<u?sleep[-+@>]|\<poll[-+@>]|\<select[-+@>]|printf|\<puts[-+@>]|\<f?open(64)?[-+@>]|\<f(write|read|flush)[-+@>]'
forbidden+='|\<(write|read)[-+@>]|std::(basic_)?[io]?stream|std::ios|std::__cxx11|std::function|std::vector<.*::(reserve|resize|_M_)'
forbidden+='|syslog|\<lua_|\<luaL_|\<exit[-+@>]'

bad=0
for judged in "$@"; do
    object=${judged%%=*}
    load_path=""
    [[ $judged == *=* ]] && load_path=${judged#*=}
    # Every called or referred to symbol, behind the function it stands in.
    calls=$(objdump -dr --no-show-raw-insn -C "$archive" 2>/dev/null | awk -v object="$object" '
        /file format/ { here = ($1 == object ":"); seen += here; next }
        !here { next }
        /^[0-9a-f]+ <.*>:$/ { name = $0; sub(/^[0-9a-f]+ </, "", name); sub(/>:$/, "", name); print name "\t"; next }
        / R_/ || /(call|jmp) / { print name "\t" $0 }
        END { exit !seen }') || { echo "$object: is not in $archive"; bad=1; continue; }
    if [[ -n $load_path ]]; then
        calls=$(awk -F '\t' -v pass="$load_path" '$1 !~ pass' <<<"$calls")
    fi
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
