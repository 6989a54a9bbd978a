// The passivity stage of the haptic loop: one observer and controller for force, one for torque (coupling/passivity.h), in
// the hand's own metres.
//
// Each port has a budget of its own: a brake on turning cannot take back what a push gave, and what a damper took from
// the one must not license the other to buzz. Two passive ports are passive together.
//   d_n = (p_n - p_(n-1)) / scale,  world axes        forces are unscaled, so that d is what the hand really moved
//   theta_n = log(q_n q_(n-1)^-1)                     exact work of a held torque while the axis stays; else second order
// A round without a new pose moves nothing and holds the brake; the next pose is charged at the force sent last.
//
// Thread: haptic loop. Cost: about 30 ns, and as much again for the torque, which is there when the plan has torques.
#pragma once

#include "haptics/coupling/passivity.h"
#include "haptics/device/device.h"
#include "haptics/loop/haptic_plan.h"
#include "haptics/math/spatial.h"

#include <optional>

namespace fulcrum {

/// What the scene asks for in one round, and what of it gives the hand's work back.
struct SceneDemand {
    Wrench wrench_W{};
    ElasticForce force{};     ///< newtons
    ElasticForce torque{};    ///< newton metres
    ContactSpring contact{};  ///< part of `force`; its energy in metres of the world
};

class PassivityStage {
  public:
    /// Takes a plan that `validate` accepted. A device that renders no torque gets no brake on it.
    PassivityStage(const HapticPlan& plan, const DeviceTraits& traits) noexcept;

    /// Counts the period that has just ended with the tool now at `tool_W`, and returns the brake to add to `demand`.
    /// `is_new` is false where the device has told no pose since the last round.
    [[nodiscard]] Wrench step(const SceneDemand& demand, const Pose& tool_W, double dt_s,
                              bool is_new = true) noexcept;
    /// What was sent to the device, in world axes.
    void sent(const Wrench& applied_W) noexcept;
    /// Begins anew: the hand has jumped.
    void forget() noexcept;

    [[nodiscard]] const PortEnergy& force_energy() const noexcept { return force_.energy(); }
    /// Zeros where there is no torque.
    [[nodiscard]] PortEnergy torque_energy() const noexcept {
        return torque_ ? torque_->energy() : PortEnergy{};
    }

  private:
    double scale_;  // world metres a metre of the hand
    PassivityController force_;
    std::optional<PassivityController> torque_;
    bool has_pose_ = false;
    Pose last_W_{};
    ContactSpring contact_{};
};

}  // namespace fulcrum
