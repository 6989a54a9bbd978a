#!/usr/bin/env bash
# man.sh OUT PROGRAM…: writes the manual page, compressed, out of what the program's own help says.
set -euo pipefail
out=$1
shift
version=$("$@" --version)
usage=$("$@" help)
{
    cat <<EOT
.TH FULCRUM 1 "" "$version" "Education"
.SH NAME
fulcrum \\- lessons that are felt, by a haptic arm or a mouse
.SH SYNOPSIS
.B fulcrum
[COMMAND …]
.SH DESCRIPTION
.nf
$(sed -e 's/\\/\\e/g' -e 's/-/\\-/g' -e "s/^[.']/\\\\\&&/" <<<"$usage")
.fi
.SH FILES
.TP
.I ~/.local/share/fulcrum/scenarios/NAME/lesson.lua
a lesson of your own: text in Lua, listed beside the others
.TP
.I ~/.local/share/fulcrum/progress.db
the learners' progress
.TP
.I /etc/fulcrum/site.conf, ~/.config/fulcrum/site.conf
limits of force for this place
.TP
.I /etc/security/limits.d/fulcrum.conf
who may have the haptic loop's priority: the group audio
.SH SEE ALSO
reference.md and README.md beside the package's documentation: all that a lesson can do.
EOT
} | gzip -9n >"$out"
