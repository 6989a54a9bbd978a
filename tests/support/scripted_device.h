// A device for tests: gives the reading it was told to give, and keeps the wrench it was given.
#pragma once

#include "haptics/device/device.h"

namespace fulcrum {

class ScriptedDevice final : public Device {
  public:
    ScriptedDevice() {
        traits_.name = "scripted device";
        traits_.renders_force = true;
        traits_.max_force_N = 100.0;
        traits_.max_torque_Nm = 10.0;
    }

    [[nodiscard]] const DeviceTraits& traits() const noexcept override { return traits_; }
    [[nodiscard]] bool read(double now_s, DeviceReading& reading) noexcept override {
        reading.stamp_s = now_s - age_s;
        reading.pose_D = pose_D;
        reading.buttons = buttons;
        return gives_pose;
    }
    [[nodiscard]] bool write(double /*now_s*/, const Wrench& wrench_D) noexcept override {
        written_D = wrench_D;
        ++n_writes;
        return takes_wrench;
    }

    DeviceTraits traits_;
    Pose pose_D{};
    std::uint32_t buttons = 0;
    double age_s = 0.0;        ///< how old the pose is
    bool gives_pose = true;    ///< what `read` returns
    bool takes_wrench = true;  ///< what `write` returns
    Wrench written_D{};        ///< the last wrench
    int n_writes = 0;
};

}  // namespace fulcrum
