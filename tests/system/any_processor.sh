#!/usr/bin/env bash
# any_processor.sh PROGRAM: fails where a function of it uses what not every x86-64 processor has (instructions of AVX and later), but for
# the kernels that are taken where the processor has it; what they share with others, such as the standard library's functions, is compiled
# for all. Those kernels must be seen.
set -euo pipefail
# Names as the linker has them: a demangler may stumble over some of them.
objdump -d --no-show-raw-insn "$1" | awk '
    /^[0-9a-f]+ <.*>:$/ { name = $0; sub(/^[0-9a-f]+ </, "", name); sub(/>:$/, "", name); next }
    /\tv[a-z0-9]+ .*%[xyz]mm/ { if (name ~ /[0-9]avx(2|512)_(kernels|band)/) kernels[name]; else others[name] = $0 }
    END {
        for (name in kernels) n_kernels++
        for (name in others) { print name "\n" others[name]; bad = 1 }
        if (n_kernels < 10) { print "only " n_kernels + 0 " functions of wider kernels are in it"; bad = 1 }
        exit bad
    }'
