#!/usr/bin/env bash
# is_hand.sh PROGRAM: of folders as the kernel has them for HID devices, the program that udev asks takes SpaceMice and joysticks by any bus,
# and no keyboard, nor what says nothing of itself or no sense.
set -euo pipefail
program=$1
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
chmod a+rx "$folder"

axes='\x09\x30\x09\x31\x15\x00\x26\xff\x00\x75\x08\x95\x02\x81\x02'
buttons='\x05\x09\x19\x01\x29\x08\x15\x00\x25\x01\x75\x01\x95\x08\x81\x02'
stick="\\x05\\x01\\x09\\x04\\xa1\\x01$axes$buttons\\xc0"
range='\x16\xa2\xfe\x26\x5e\x01\x75\x10'
cap="\\x05\\x01\\x09\\x08\\xa1\\x01\\x09\\x30\\x09\\x31\\x09\\x32$range\\x95\\x03\\x81\\x02\\xc0"
half="\\x05\\x01\\x09\\x08\\xa1\\x01\\x09\\x30$range\\x95\\x01\\x81\\x02\\xc0"
keyboard='\x05\x01\x09\x06\xa1\x01\x05\x07\x19\xe0\x29\xe7\x15\x00\x25\x01\x75\x01\x95\x08\x81\x02\xc0'
failed=0

# expect STATUS WHAT ID DESCRIPTOR
expect() {
    local status=0 device="$folder/$2"
    mkdir -p "$device/device"
    printf 'DRIVER=hid-generic\nHID_ID=%s\nHID_NAME=x\n' "$3" >"$device/device/uevent"
    # shellcheck disable=SC2059 # its bytes
    printf "$4" >"$device/device/report_descriptor"
    "$program" "$device" || status=$?
    ((status == $1)) || { echo "is_hand.sh: $2: $status, not $1" >&2; failed=1; }
}
expect 0 'a joystick by USB' 0003:0000045E:0000001B "$stick"
expect 0 'a joystick by Bluetooth' 0005:0000045E:0000001B "$stick"
expect 0 'a SpaceMouse by USB' 0003:0000256F:0000C635 "$cap"
expect 0 'a SpaceMouse by Bluetooth' 0005:0000256F:0000C63A "$cap"
expect 0 'a self-built one with six directions' 0003:0000F00D:0000C0DE "$cap"
expect 1 'one with one direction' 0003:0000256F:0000C635 "$half"
expect 1 'a keyboard' 0003:0000046D:0000C31C "$keyboard"
expect 1 'a keyboard of who makes SpaceMice' 0003:0000256F:0000C635 "$keyboard"
expect 1 'nothing' 0003:0000045E:0000001B ''
expect 1 'a joystick that is cut off' 0003:0000045E:0000001B "${stick:0:28}"
expect 1 'no numbers, and no sense' 'x:::y' '\xff\xfe\xfd'
status=0
"$program" "$folder/nowhere" || status=$?
((status == 1)) || { echo "is_hand.sh: nowhere: $status, not 1" >&2; failed=1; }
exit "$failed"
