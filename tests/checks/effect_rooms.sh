#!/usr/bin/env bash
# effect_rooms.sh [ROOT]: fails where the program names a kind of force outside the room that declares them, runtime/effect/field: a new
# kind is one list there and one law in haptics/field.
set -euo pipefail
cd "${1:-$(dirname -- "$0")/../..}"

named=$(find runtime -path runtime/effect/field -prune -o \( -name '*.h' -o -name '*.cpp' \) -print0 | LC_ALL=C sort -z |
    xargs -0r grep -nE '\bFieldKind::' || true)
[[ -z $named ]] || { printf '%s\n' "$named" 'a kind of force is named outside runtime/effect/field; ask for what it is like, or put it there' && exit 1; }
