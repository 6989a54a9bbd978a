#!/usr/bin/env bash
# package.sh BUILD [--try]: the Debian package of what was built in BUILD; --try uses it in a bare Debian (try.sh). Its time is that of the
# commit, so that the same commit gives the same bytes.
set -euo pipefail
root=$(cd -- "$(dirname -- "$0")/.." && pwd)
build=$(cd -- "$1" && pwd)
shift
[[ $# -eq 0 || $* == --try ]] || { echo "fulcrum: package takes --try or nothing, not $*" >&2; exit 2; }
if [[ -z ${SOURCE_DATE_EPOCH:-} ]]; then
    SOURCE_DATE_EPOCH=$(git -C "$root" log -1 --format=%ct 2>/dev/null) || SOURCE_DATE_EPOCH=$(stat -c %Y "$root/CMakeLists.txt")
fi
export SOURCE_DATE_EPOCH
# Newer commits are newer packages.
version=$(sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' "$build/CMakeCache.txt")+$(date -u -d "@$SOURCE_DATE_EPOCH" +%Y%m%d%H%M%S)
stage=$build/stage log=$build/package.log
rm -rf -- "$stage" "$build/packed"
umask 022
if ! { DESTDIR=$stage cmake --install "$build" --strip &&
    find "$stage" -exec touch -h -d "@$SOURCE_DATE_EPOCH" {} + &&
    cpack --config "$build/CPackConfig.cmake" -B "$build/packed" -D "CPACK_PACKAGE_VERSION=$version" \
        -D "CPACK_INSTALLED_DIRECTORIES=$stage;/"; } >"$log" 2>&1; then
    tail -n 15 "$log" >&2
    echo "fulcrum: the package could not be made; the whole of what was said is in $log" >&2
    exit 2
fi
made=("$build"/packed/*.deb)
deb=$root/build/${made[0]##*/}
mv -f -- "${made[0]}" "$deb"
printf '%s: %s bytes, %s installed.\nTo install it:  sudo apt install %q\n' "$deb" "$(stat -c %s "$deb")" \
    "$(du -sh --apparent-size "$stage" | cut -f 1)" "$deb"
[[ $# -eq 0 ]] || exec "$root/packaging/try.sh" "$deb" "$root/build/package-try"
