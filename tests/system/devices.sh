#!/usr/bin/env bash
# devices.sh PROGRAM SHIM DEVICE: fulcrum devices lists what udev knows. The machine's devices are umockdev's invention; hidapi and udev
# are the real ones, and what is listed is opened.
set -euo pipefail
program=$1
shim=$2
device=$3
for tool in umockdev-run; do
    command -v "$tool" >/dev/null || { echo "no $tool: skipped"; exit 77; }
done
folder=$(mktemp -d)
here=$(cd -- "$(dirname -- "$0")" && pwd)
pids=()
trap 'kill "${pids[@]}" 2>/dev/null || true; rm -rf -- "$folder"' EXIT

# descriptor SEED: the report descriptor of a seed of the fuzzer, in hexadecimal.
descriptor() {
    local seed=$here/../fuzz/corpus/hid/$1 n
    n=$(od -An -tu2 -N2 "$seed" | tr -d ' ')
    od -An -v -tx1 -j2 -N"$n" "$seed" | tr -d ' \n' | tr a-f A-F
}
# hidraw N VENDOR PRODUCT NAME SEED: as Linux tells of a device on USB.
hidraw() {
    local hid="/devices/usb1/1-$1/1-$1:1.0/0003:$2:$3.000$1"
    printf '%s\n' "P: /devices/usb1/1-$1" 'E: DEVTYPE=usb_device' 'E: SUBSYSTEM=usb' "A: idVendor=${2,,}" "A: idProduct=${3,,}" \
        "A: manufacturer=Maker" "A: product=$4" '' \
        "P: ${hid%/*}" 'E: DEVTYPE=usb_interface' 'E: SUBSYSTEM=usb' 'A: bInterfaceNumber=00' '' \
        "P: $hid" 'E: SUBSYSTEM=hid' "E: HID_ID=0003:0000$2:0000$3" "E: HID_NAME=Maker $4" 'E: HID_UNIQ=' \
        "H: report_descriptor=$(descriptor "$5")" '' \
        "P: $hid/hidraw/hidraw$1" "N: hidraw$1" "L: device=../../../${hid##*/}" 'E: SUBSYSTEM=hidraw' "E: DEVNAME=/dev/hidraw$1" ''
}
{
    hidraw 0 046D C626 SpaceNavigator space_mouse_two
    hidraw 1 1234 BEEF "Force stick" force_stick_0
    hidraw 2 F00D C0DE "Self-built mouse" space_mouse_one
} >"$folder/machine.umockdev"
# listed WORDS…: what the program says of that machine.
listed() {
    umockdev-run -d "$folder/machine.umockdev" -- env LD_PRELOAD="$shim:libumockdev-preload.so.0" FULCRUM_HID_NODES="$folder" "$program" "$@" 2>&1
}
says() { grep -qF -- "$2" <<<"$1" || { echo "never said: $2"; echo "$1"; exit 1; }; }

all=$(listed devices)
says "$all" "SpaceNavigator (046d:c626): 6 axes, 2 buttons, no force: it is shown and heard.  --hand hid:/dev/hidraw0"
says "$all" "Force stick (1234:beef): 3 axes, 8 buttons, force along 2 axes.  --hand hid:/dev/hidraw1"
says "$all" "Self-built mouse (f00d:c0de): 6 axes, 2 buttons, no force: it is shown and heard.  --hand hid:/dev/hidraw2"
says "$all" "simulated hand"
says "$(listed devices --json)" '"udev_file": "/etc/udev/rules.d/70-fulcrum.rules"'

# Of those two the one with force is chosen, and opened by the path that udev tells.
nodes=$folder
(
    # shellcheck source=tests/system/screen.sh
    source "$here/screen.sh"
    mkdir "$folder/x"
    printf '%s\n' 'local L = lesson { id = "x", title = "X", level = "A1", minutes = 1 }' 'function L:start(world) print("began") end' 'return L' >"$folder/x/lesson.lua"
    coproc virtual { "$device" stick "$nodes/hidraw1.hid"; }
    trap 'kill "$virtual_PID" 2>/dev/null || true; finish' EXIT
    read -r -t 30 -u "${virtual[0]}" _
    said=$(umockdev-run -d "$nodes/machine.umockdev" -- env LD_PRELOAD="$shim:libumockdev-preload.so.0" \
        FULCRUM_HID_NODES="$nodes" timeout 60 "$program" run "$folder/x" --hand hid --mute --seconds 2 2>&1)
    says "$said" began
)
