#!/usr/bin/env bash
# build_id.sh PROGRAM STRIP OBJCOPY: writes PROGRAM's build id, for which the linker left room: a hash of what stripping leaves, with zeros
# in that room. So the program that is packed has the id of that which was tested, wherever it was built, and debug information counts for nothing.
set -euo pipefail
program=$1 strip=$2 objcopy=$3
section=.note.gnu.build-id
trap 'rm -f -- "$program".{stripped,note,id}' EXIT
"$strip" -o "$program.stripped" "$program"
"$objcopy" --dump-section "$section=$program.note" "$program" /dev/null
# write_id FILE HEX: the id is the note's last 20 bytes.
write_id() {
    { head -c -20 "$program.note" && printf '%b' "$(sed 's/../\\x&/g' <<<"$2")"; } >"$program.id"
    "$objcopy" --update-section "$section=$program.id" "$1"
}
# Written by objcopy as the program is: it may lay sections out otherwise than the linker.
write_id "$program.stripped" "$(printf '0%.0s' {1..40})"
write_id "$program" "$(sha1sum <"$program.stripped" | cut -c 1-40)"
