// HID devices of this machine, by hidapi over Linux' hidraw.
//
// Listing goes through udev and opens nothing: descriptors come from sysfs, so that a device that may not be opened can be
// described too. hidapi keeps one error text for all of its callers: what touches it is done by one thread at a time; links are
// free of each other.
// Thread: any. Cost: listing some milliseconds, opening some tenths of one.
// Source: hidapi 0.13, hidapi.h; Linux, Documentation/hid/hidraw.rst.
#pragma once

#include "haptics/device/hid/hid_link.h"

#include <memory>

namespace fulcrum::hid {

[[nodiscard]] std::shared_ptr<HidBus> make_hidapi_bus();

}  // namespace fulcrum::hid
