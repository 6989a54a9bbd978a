#!/usr/bin/env bash
# installed.sh BUILD: what is installed below a prefix stays below it, and plays from there, alone too: lessons, models, and what hears.
set -euo pipefail
build=$1
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
fail() {
    echo "installed.sh: $*" >&2
    exit 1
}
prefix="$folder/a prefix"
cmake --install "$build" --prefix "$prefix" >"$folder/log" 2>&1 || { tail -n 5 "$folder/log" >&2 && fail "it cannot be installed"; }
outside=$(sed -nE 's/^-- (Installing|Up-to-date): (.*)/\2/p' "$folder/log" | grep -vF "$prefix/" || true)
[[ -z $outside ]] || fail "installed outside of the prefix: $outside"
for file in etc/security/limits.d/fulcrum.conf etc/fulcrum/site.conf share/man/man1/fulcrum.1.gz share/applications/fulcrum.desktop; do
    [[ -s $prefix/$file ]] || fail "$file is missing"
done

# What is packed is stripped, and knows itself for the very program that was tested: its build id is a hash of what stripping leaves. A
# sanitized program, which is never packed, is laid out anew each time that its id is written.
for program in bin/fulcrum libexec/fulcrum/fulcrum-sphinx libexec/fulcrum/fulcrum-is-hand; do
    ! grep -q __asan_init "$build/fulcrum" || break
    cp "$build/${program##*/}" "$folder/tested"
    strip -o "$folder/packed" "$folder/tested"
    ids=()
    for file in tested packed; do
        ids+=("$(readelf -n "$folder/$file" | sed -n 's/^ *Build ID: //p')")
    done
    objcopy --dump-section .note.gnu.build-id="$folder/note" "$folder/packed" /dev/null
    { head -c -20 "$folder/note" && head -c 20 /dev/zero; } >"$folder/empty"
    objcopy --update-section .note.gnu.build-id="$folder/empty" "$folder/packed"
    [[ ${ids[*]} == "$(sha1sum <"$folder/packed" | sed 's/^\(.\{40\}\).*/\1 \1/')" ]] || fail "$program: its build id is ${ids[0]} and, stripped, ${ids[1]}"
done

mkdir "$folder/home" && cd "$folder/home"
export HOME=$folder/home
unset XDG_DATA_HOME XDG_DATA_DIRS XDG_CACHE_HOME DISPLAY WAYLAND_DISPLAY
flite -voice slt -t "a watermelon is the heaviest" -o heaviest.wav
echo heaviest.wav >list
"$prefix/bin/fulcrum" run gravity --headless --speech sphinx --seconds 60 --hear list >said 2>&1 || true
grep -q 'learner .*watermelon' said || { cat said >&2 && fail "gravity was not played, or nobody heard"; }
cp "$prefix/bin/fulcrum" alone
! XDG_DATA_DIRS=$folder/home ./alone list >said 2>&1 || fail "a program without lessons says nothing"
grep -q 'lessons and words are not found' said || { cat said >&2 && fail "a program without lessons says something else"; }
XDG_DATA_DIRS="$prefix/share" ./alone list | grep -q '^gravity ' || fail "alone it does not find the lessons of its place"
echo "installed.sh: passed"
