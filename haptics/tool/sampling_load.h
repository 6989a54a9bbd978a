// A tool's points against an object as a load on the tool, for every integrator: whatever samples them.
//
// `Sampling` has sample(state, object) and sample_linearised(state, object, springs_by, brakes_by), both noexcept, whose result has a
// wrench_W; the second adds the derivatives of what brakes and of all else, which may be the same two.
// The object moves on along its twist while the step asks, so that explicit and implicit steps see it where it is.
//
// Thread: that of the step. Cost: that of the sampling.
#pragma once

#include "haptics/coupling/tool_coupling.h"
#include "haptics/dynamics/load.h"
#include "haptics/math/rotation.h"

namespace fulcrum {

/// Refers to the sampling, which must live longer.
template <class Sampling>
// NOLINTNEXTLINE(cppcoreguidelines-virtual-class-destructor): never deleted as a Load
class SamplingLoad final : public Load {
  public:
    explicit SamplingLoad(const Sampling& sampling) noexcept : sampling_(&sampling) {}

    /// The object as it was at `time_s`; at another time it is that much further along its twist.
    void set_object(const MovingFrame& object, double time_s) noexcept {
        object_ = object;
        object_time_s_ = time_s;
    }
    /// What the tool would touch in that state.
    [[nodiscard]] auto compute_contact(const RigidState& state, double time_s) const noexcept {
        return sampling_->sample(state, compute_object(time_s));
    }
    /// The same; adds the derivatives of the brakes, and of all else.
    [[nodiscard]] auto compute_linearised_contact(const RigidState& state, double time_s,
                                                  WrenchJacobian& springs_by,
                                                  WrenchJacobian& brakes_by) const noexcept {
        return sampling_->sample_linearised(state, compute_object(time_s), springs_by, brakes_by);
    }

    void add_wrench(const RigidState& state, double time_s,
                    Wrench& wrench) const noexcept override {
        const Wrench added = compute_contact(state, time_s).wrench_W;
        wrench.force += added.force;
        wrench.torque += added.torque;
    }
    void add_linearised_wrench(const RigidState& state, double time_s, Wrench& wrench,
                               WrenchJacobian& jacobian) const noexcept override {
        const Wrench added = compute_linearised_contact(state, time_s, jacobian, jacobian).wrench_W;
        wrench.force += added.force;
        wrench.torque += added.torque;
    }

  private:
    [[nodiscard]] MovingFrame compute_object(double time_s) const noexcept {
        return move_evenly(object_, time_s - object_time_s_);
    }

    const Sampling* sampling_;
    MovingFrame object_{};
    double object_time_s_ = 0.0;
};

}  // namespace fulcrum
