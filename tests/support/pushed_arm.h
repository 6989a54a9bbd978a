// A simulated arm that a lesson's side pushes through a whole haptic loop, as at a learner's first use: one whose motors
// may be wired otherwise than it says, and one that may stand otherwise than it says.
#pragma once

#include "haptics/device/fitted/fitted_device.h"
#include "haptics/device/simulated/simulated_arm.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/loop/push_trial.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

namespace fulcrum {

/// What it is told is turned by a matrix before it acts.
class MiswiredArm final : public Device {
  public:
    MiswiredArm(std::unique_ptr<Device> arm, const Matrix3& wiring)
        : arm_(std::move(arm)), wiring_(wiring) {}
    [[nodiscard]] const DeviceTraits& traits() const noexcept override { return arm_->traits(); }
    [[nodiscard]] bool read(double now_s, DeviceReading& reading) noexcept override {
        const bool is_read = arm_->read(now_s, reading);
        reading.faults |= told;
        return is_read;
    }
    [[nodiscard]] bool write(double now_s, const Wrench& wrench_D) noexcept override {
        largest_N = std::max(largest_N, wrench_D.force.norm());
        largest_step_N = std::max(largest_step_N, (wrench_D.force - written_N).norm());
        written_N = wrench_D.force;
        return arm_->write(now_s, {wiring_ * wrench_D.force, wrench_D.torque});
    }

    Fault told = Fault::none;  ///< with every reading
    Vector3 written_N{Vector3::Zero()};
    double largest_N = 0.0;
    double largest_step_N = 0.0;

  private:
    std::unique_ptr<Device> arm_;
    Matrix3 wiring_;
};

inline SimulatedArmSettings arm_held_by(const HumanImpedance& human) {
    SimulatedArmSettings settings = make_desktop_arm();
    settings.human = human;
    return settings;
}

/// The arm in its loop; a lesson's frame is ten rounds.
struct PushedArm {
    explicit PushedArm(const Matrix3& wiring = Matrix3::Identity(),
                       const SimulatedArmSettings& settings = arm_held_by(kPosture),
                       const DeviceFit& fit = {})
        : PushedArm(
              wiring,
              [&](LatestValue<HandTarget>& wanted) -> std::unique_ptr<Device> {
                  return std::make_unique<SimulatedArm>(settings, wanted);
              },
              fit) {}
    using MakeArm = std::function<std::unique_ptr<Device>(LatestValue<HandTarget>&)>;
    PushedArm(const Matrix3& wiring, const MakeArm& make, const DeviceFit& fit = {}) {
        target.publish({});
        auto made = std::make_unique<MiswiredArm>(make(target), wiring);
        arm = made.get();
        device = std::make_unique<FittedDevice>(fit, std::move(made));
        HapticPlan plan;
        plan.lesson_force = true;
        plan.safety.max_force_N = kMostPush_N;
        loop = std::make_unique<HapticLoop>(plan, *device, *channels);
    }
    void frame(const Vector3& force_W) {
        constexpr int kRounds = 10;
        constexpr double kRound_s = 0.001;
        ForceCommand command;
        command.stamp_s = now_s;
        command.lesson_alive = true;
        command.linearised.stamp_s = now_s;
        command.linearised.force_W = force_W;
        channels->command.publish(command);
        for (int i = 0; i < kRounds; ++i) {
            now_s += kRound_s;
            loop->step(now_s);
        }
    }

    LatestValue<HandTarget> target;
    MiswiredArm* arm = nullptr;
    std::unique_ptr<FittedDevice> device;
    std::unique_ptr<HapticChannels> channels = std::make_unique<HapticChannels>();
    std::unique_ptr<HapticLoop> loop;
    double now_s = 0.0;
};

}  // namespace fulcrum
