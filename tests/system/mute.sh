#!/usr/bin/env bash
# mute.sh PROGRAM: with --mute no sound device is opened or even looked for; without it one is, so that this can fail.
set -euo pipefail
program=$1
# shellcheck source=tests/system/screen.sh
source "$(dirname -- "$0")/screen.sh"
need strace

# sounds OPTION…: how often a run asked for a sound card, a sound server, or their settings. Libraries are no device: both
# runs load them.
sounds() {
    strace -f -qq -e trace=openat,connect -o "$folder/calls" "$program" run gravity --seconds 1 "$@" >"$folder/said" 2>&1 ||
        { cat "$folder/said" >&2; exit 1; }
    grep -E '"[^"]*(/dev/snd|/dev/dsp|pulse|asound|alsoft|pipewire|jack)[^"]*"' "$folder/calls" | grep -vcF .so || true
}

aloud=$(sounds)
muted=$(sounds --mute)
echo "sound asked for $aloud times, with --mute $muted times"
((aloud > 0 && muted == 0))
