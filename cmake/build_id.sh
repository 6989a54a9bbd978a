#!/usr/bin/env bash
# build_id.sh PROGRAM STRIP OBJCOPY: writes PROGRAM's build id, for which the linker left room: a hash of what stripping leaves. So the
# program that is packed has the id of that which was tested, wherever it was built, and debug information counts for nothing.
set -euo pipefail
program=$1 strip=$2 objcopy=$3
section=.note.gnu.build-id
trap 'rm -f -- "$program".{stripped,note,id}' EXIT
"$strip" -o "$program.stripped" "$program"
id=$(sha1sum <"$program.stripped" | cut -c 1-40)
"$objcopy" --dump-section "$section=$program.note" "$program" /dev/null
# The id is the note's last 20 bytes.
{ head -c -20 "$program.note" && printf '%b' "$(sed 's/../\\x&/g' <<<"$id")"; } >"$program.id"
"$objcopy" --update-section "$section=$program.id" "$program"
