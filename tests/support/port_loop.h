// A loop of 1 kHz in front of a port, as a server's: reads the arm and orders what a law gives for where it was last. It has no gate, so
// that what a port takes away is the port's doing.
#pragma once

#include "runtime/arms/arm_device.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <thread>

namespace fulcrum::test_support {

class PortLoop {
  public:
    /// The force, frame D, for a place of the handle. `device` outlives the loop.
    using Law = std::function<Vector3(const Vector3& position_D)>;

    PortLoop(runtime::ArmDevice& device, Law law)
        : device_(device), law_(std::move(law)), thread_([this] { run(); }) {}
    PortLoop(const PortLoop&) = delete;
    PortLoop& operator=(const PortLoop&) = delete;
    ~PortLoop() {
        stops_ = true;
        thread_.join();
    }

    [[nodiscard]] bool is_there() const { return is_there_; }
    /// While true nothing is ordered.
    void be_silent(bool is_silent) { is_silent_ = is_silent; }
    /// The oldest pose that it was given since it was last asked, seconds.
    [[nodiscard]] double take_oldest_s() { return oldest_s_.exchange(0.0); }

  private:
    void run() {
        Vector3 position = Vector3::Zero();
        while (!stops_) {
            DeviceReading reading;
            const double now_s = monotonic_now_s();
            const bool is_there = device_.read(now_s, reading);
            if (is_there) {
                position = reading.pose_D.position;
                oldest_s_ = std::max(oldest_s_.load(), now_s - reading.stamp_s);
            }
            is_there_ = is_there;
            if (!is_silent_) {
                (void)device_.write(now_s, {.force = law_(position)});
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }

    runtime::ArmDevice& device_;
    Law law_;
    std::atomic<bool> stops_{false};
    std::atomic<bool> is_silent_{false};
    std::atomic<bool> is_there_{false};
    std::atomic<double> oldest_s_{0.0};
    std::thread thread_;
};

/// A wall of `stiffness_N_per_m` that begins `depth_m` along the axis (0 to 2), on its far side.
[[nodiscard]] inline PortLoop::Law make_wall(int axis, double depth_m, double stiffness_N_per_m) {
    return [=](const Vector3& position_D) {
        const double in_m = position_D[axis] / depth_m > 1.0 ? position_D[axis] - depth_m : 0.0;
        Vector3 force = Vector3::Zero();
        force[axis] = -stiffness_N_per_m * in_m;
        return force;
    };
}

}  // namespace fulcrum::test_support
