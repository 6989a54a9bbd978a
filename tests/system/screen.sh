# shellcheck shell=bash
# screen.sh, read by the tests of the window: a folder that is also HOME, and a screen of its own. $child, when set, is the
# program that the test started; it ends with the test, as all of this does.

# need TOOL…: without one of them the test is skipped.
need() {
    local tool
    for tool; do
        command -v "$tool" >/dev/null || { echo "no $tool: skipped"; exit 77; }
    done
}

need Xvfb
folder=$(mktemp -d)
export HOME=$folder
unset XDG_DATA_HOME XDG_CACHE_HOME WAYLAND_DISPLAY
mkfifo "$folder/display"
# What is seen stands in a file, as xwd writes it.
mkdir "$folder/screen"
screen_file=$folder/screen/Xvfb_screen0
Xvfb -noreset -displayfd 3 -screen 0 1280x720x24 -fbdir "$folder/screen" 3>"$folder/display" 2>/dev/null &
server=$!
child=
finish() {
    [[ -z $child ]] || kill "$child" 2>/dev/null || true
    kill "$server" 2>/dev/null || true
    wait 2>/dev/null || true
    rm -rf -- "$folder"
}
trap finish EXIT
DISPLAY=:$(head -n 1 "$folder/display")
export DISPLAY

# wait_for TEXT [SECONDS]: until $folder/said, to which the test sends what its program says, has TEXT; 30 seconds unless told.
wait_for() {
    local deadline=$((SECONDS + ${2:-30}))
    until grep -qF -- "$1" "$folder/said"; do
        if ((SECONDS > deadline)); then
            echo "never said: $1"
            cat "$folder/said"
            exit 1
        fi
        sleep 0.05
    done
}

# rows FIRST N: what stands on the screen, a line each row, " ffrrggbb" each pixel. The screen's file is in the form of xwd: a head that tells
# its own size and how many colours of twelve bytes follow, then four bytes a pixel.
rows() {
    local head colours
    head=$(od -An -tu4 --endian=big -N4 "$screen_file")
    colours=$(od -An -tu4 --endian=big -j76 -N4 "$screen_file")
    od -An -v -tx4 -w5120 -j $((head + 12 * colours + 5120 * $1)) -N $((5120 * $2)) "$screen_file"
}

# wait_for_pixel X Y COLOUR: until it is shown there, for 30 seconds.
wait_for_pixel() {
    local deadline=$((SECONDS + 30)) row
    until row=$(rows "$2" 1) && [[ ${row:9 * $1 + 3:6} == "$3" ]]; do
        ((SECONDS <= deadline)) || { echo "never shown at $1, $2: $3"; exit 1; }
        sleep 0.05
    done
}
