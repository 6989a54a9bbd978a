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
