#!/usr/bin/env bash
# vendor_headers.sh [ROOT]: fails on a vendor's header outside the one folder that may know it. haptics and dialogue
# build on the standard library, Linux, tl::expected, (haptics) Eigen and (dialogue) utf8proc alone.
set -euo pipefail
cd "${1:-$(dirname -- "$0")/../..}"

find haptics dialogue runtime -name '*.h' -o -name '*.cpp' | LC_ALL=C sort | xargs -r grep -nHE '^[[:space:]]*#[[:space:]]*include[[:space:]]*<' | awk -F: '
BEGIN {
    # header, as a regular expression -> folder that may include it, likewise
    home["^GLFW/"] = "^runtime/render/glfw/"
    home["^epoxy/"] = "^runtime/render/"
    home["^(EGL|GL)/"] = "^runtime/render/"
    home["^(ft2build|freetype|hb|fribidi|fontconfig)"] = "^runtime/render/text/"
    home["^AL/"] = "^runtime/audio/openal/"
    home["^(lua|lauxlib|lualib)"] = "^runtime/lua/"
    home["^sqlite3"] = "^runtime/progress/sqlite/"
    home["^(libpq|pqxx)"] = "^runtime/progress/postgres/"
    home["^(tiny_gltf|stb_)"] = "^runtime/scene/gltf/"
    home["^(png|jpeglib)[.]h$"] = "^runtime/scene/picture/"
    home["^nlohmann/"] = "^(runtime|dialogue/speech/external)/"
    home["^barrett/"] = "^runtime/arms/wam/barrett/"
    home["^sodium[.]h$"] = "^runtime/link/"
    home["^(hidapi|libusb)"] = "^haptics/device/hid/hidapi/"
    home["^(pocketsphinx|ps_search|sphinxbase|flite|onnxruntime)"] = "^dialogue/speech/"
    home["^utf8proc[.]h$"] = "^dialogue/unicode[.]cpp$"
    home["^link-grammar/"] = "^dialogue/checking/link_grammar/"
    # Whoever includes a header compiles all that it includes; Eigen costs three times what a header of ours does.
    home["^Eigen/"] = "^haptics/(math/to_eigen[.]h|.*[.]cpp)$"
    home["^tl/expected[.]hpp$"] = "."
    home["^catch2/"] = "^$"
    # Linux, glibc, the compiler and the processor; the standard library has neither slash nor dot.
    home["^(sys|linux|arpa|netinet|net|sanitizer)/"] = "."
    home["^(pthread|sched|spawn|elf|link|netdb|unistd|dirent|fcntl|poll|signal|time|pwd|grp|dlfcn|malloc|termios|semaphore|immintrin|xmmintrin|emmintrin|x86intrin|cpuid)[.]h$"] = "."
    home["^[a-z_]+$"] = "."
}
{
    header = $0
    sub(/^[^<]*</, "", header)
    sub(/>.*/, "", header)
    known = 0
    for (pattern in home) {
        if (header ~ pattern) {
            known = 1
            if ($1 !~ home[pattern]) { print $1 ":" $2 ": <" header "> belongs behind an interface, in a folder of its own"; bad = 1 }
        }
    }
    if (!known) { print $1 ":" $2 ": <" header "> is from no library that the house knows"; bad = 1 }
}
END { exit bad }'
