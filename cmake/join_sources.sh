#!/usr/bin/env bash
# cmake/join_sources.sh OUT SOURCE…: writes one source that stands for several, each in a namespace of its own; their includes
# come first, so that within those namespaces none has any effect left.
set -euo pipefail
out=$1
shift
{
    echo "// Made by cmake/join_sources.sh."
    sed -nE 's/^#include ([<"][^>"]+[>"]).*/#include \1/p' "$@" | awk '!seen[$0]++'
    n=0
    for source in "$@"; do
        # What the source adds to the project's namespaces has to see what is in them.
        sed -nE 's/^namespace (fulcrum[a-z_:]*) \{.*/\1/p' "$source" |
            awk -F:: '{ space = ""; for (i = 1; i <= NF; ++i) { space = space (i > 1 ? "::" : "") $i; print space } }' | sort -u |
            while read -r space; do
                echo "namespace joined_$n::$space { using namespace ::$space; }"
            done
        printf 'namespace joined_%s {\n#include "%s"\n}\n' "$n" "$source"
        n=$((n + 1))
    done
} >"$out"
