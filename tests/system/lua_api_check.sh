#!/usr/bin/env bash
# lua_api_check.sh [BUILD]: the unit tests of runtime/lua and the hostile lessons, as BUILD (build/dev) has them, upon a Lua that looks
# at each call from outside (LUA_USE_APICHECK): a push beyond the places that were asked for, an index of nothing, a wrong number of
# results. That Lua is Debian's own source of the version that the tests link, compiled as C++ as theirs is; nothing of ours is
# compiled again. It stays in build/lua-api-check.
# A lesson's process may not say which look it failed at: the hostile list names the lesson's line, the unit tests say more.
# Ends with 0 where all went well, with 1 where something did not, with 77 where there is no such Lua: "not run: reason".
set -euo pipefail
root=$(cd -- "$(dirname -- "$(readlink -f -- "$0")")/../.." && pwd)
build=$(cd -- "${1:-$root/build/dev}" && pwd)
# shellcheck source=packaging/bare_debian.sh
. "$root/packaging/bare_debian.sh"
kept=$root/build/lua-api-check log=$root/build/lua-api-check/log
mkdir -p "$kept/lists/partial"
: >"$log"
tests=$build/tests/test_unit_lua hostile=$build/tests/lua_hostile
for program in "$tests" "$hostile"; do
    [[ -x $program ]] || { echo "fulcrum: $program is not built; start ./fulcrum test -N" >&2; exit 2; }
done

# ---- its source ------------------------------------------------------------------------------------------------------

linked=$(ldd "$hostile" | awk '$1 ~ /^liblua/ { print $1, $3 }')
name=${linked% *}
package=$(dpkg-query -S "$(readlink -f -- "${linked#* }")" 2>>"$log" | cut -d : -f 1) || not_run "no package of Debian has $name"
version=$(dpkg-query -W -f '${source:Package}=${source:Version}' "$package" 2>>"$log" | head -n 1)
source=$kept/${version//[=:]/_}
# apt SUBCOMMAND…: with the sources of what this machine's packages are from, and lists of its own.
apt_source() {
    (cd "$kept" && apt-get -qq -o Dir::Etc::sourcelist="$kept/sources.list" -o Dir::Etc::sourceparts=- -o Dir::State::lists="$kept/lists" \
        -o APT::Sandbox::User="$(id -un)" -o APT::Get::List-Cleanup=false "$@") >>"$log" 2>&1
}
if [[ ! -d $source ]]; then
    command -v dpkg-source >/dev/null || not_run "dpkg-source is missing; packages-package.txt names its package, dpkg-dev"
    key=/usr/share/keyrings/debian-archive-keyring.gpg
    # shellcheck disable=SC2016 # apt's own
    apt-get indextargets --format '$(REPO_URI) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' 'Origin: Debian' 'Component: main' |
        sort -u | sed "s|^|deb-src [signed-by=$key] |" >"$kept/sources.list"
    [[ -s $kept/sources.list ]] || not_run "apt knows no mirror of Debian"
    rm -rf -- "$source.part" "$kept"/*.dsc
    { apt_source update && apt_source source --download-only "$version"; } ||
        not_run "Debian's source of $version could not be fetched: $(grep -m 1 -E '^(E|Err|W):' "$log")"
    dpkg-source --extract "$kept"/*.dsc "$source.part" >>"$log" 2>&1
    mv "$source.part" "$source"
fi

# ---- compiled --------------------------------------------------------------------------------------------------------

checked=$source/checked
if [[ ! -s $checked/$name ]]; then
    mkdir -p "$checked"
    find "$source/src" -name '*.c' ! -name lua.c ! -name luac.c -printf '%f\n' |
        xargs -P "$(nproc)" -I{} g++ -x c++ -O1 -fPIC -w -DLUA_COMPAT_5_3 -DLUA_USE_LINUX -DLUA_USE_APICHECK -c "$source/src/{}" -o "$checked/{}.o"
    g++ -shared -Wl,-soname,"$name" -Wl,--version-script="$source/debian/version-script" "$checked"/*.o -ldl -o "$checked/$name.part"
    mv "$checked/$name.part" "$checked/$name"
fi
upon_it() { (cd "$build/tests" && LD_LIBRARY_PATH=$checked "$@"); }
# It looks: 25 pushes in a function that asked for no place are refused.
g++ -w -o "$checked/probe" -x c++ - -x none "$checked/$name" <<'CODE'
#include <lua5.4/lua.hpp>
int main() {
    lua_State* lua = luaL_newstate();
    lua_pushcfunction(lua, [](lua_State* in) { for (int i = 0; i < 25; ++i) lua_pushnil(in); return 0; });
    return lua_pcall(lua, 0, 0, 0);
}
CODE
if upon_it "$checked/probe" 2>"$kept/probe.log"; then
    echo "fulcrum: that Lua lets a function push more than it asked for; look at how $0 compiles it" >&2
    exit 1
fi

# ---- used ------------------------------------------------------------------------------------------------------------

claim "the unit tests of runtime/lua, upon $version with LUA_USE_APICHECK" upon_it "$tests"
claim "the hostile lessons, likewise" upon_it "$hostile" "$root/tests/system/hostile" "$root/scripts/lib"
grep -ah 'Assertion .* failed' "$log" || true
((failed == 0)) || { echo "fulcrum: a binding breaks the rules of Lua's interface; all that was said is in $log" >&2; exit 1; }
echo "passed."
