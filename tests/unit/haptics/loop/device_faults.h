// What can go wrong with a device's reading, and what is noticed of it.
#pragma once

#include "haptics/loop/safety.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/scripted_device.h"

namespace fulcrum {

struct DeviceFault {
    const char* name;
    void (*spoil)(ScriptedDevice& device);
    Fault told;
};

inline const DeviceFault kDeviceFaults[] = {
    {"gives no pose", [](ScriptedDevice& d) { d.gives_pose = false; }, Fault::device_read},
    {"gives old poses", [](ScriptedDevice& d) { d.age_s = 0.021; }, Fault::device_stale},
    {"gives no number", [](ScriptedDevice& d) { d.pose_D.position.y() = kNan; },
     Fault::device_invalid},
    {"gives no orientation", [](ScriptedDevice& d) { d.pose_D.orientation.coeffs().setZero(); },
     Fault::device_invalid},
    {"jumps, 11 m/s", [](ScriptedDevice& d) { d.pose_D.position.y() += 0.011; },
     Fault::device_invalid}};

}  // namespace fulcrum
