// All objects that a tool may touch as one load, and how those that brake at once share.
//
// Each of n objects that brake brakes by an n-th of what it would alone, for together they must not take more motion than there is; n
// is counted at the very pose and motion that is asked about. The solver's looks share the step's time.
//
// Thread: that of the step. Cost: that of the samplings; no allocation.
#pragma once

#include "haptics/tool/sampling_load.h"
#include "haptics/tool/step_time.h"
#include "haptics/tool/voxel_sampling/voxel_sampling.h"

#include <span>

namespace fulcrum {

/// How many objects brake, and what is too much of their sum.
class SharedBrakes {
  public:
    /// One object's brakes, were it alone.
    void add(const Wrench& brakes_W) noexcept {
        const bool brakes = brakes_W.force != Vector3::Zero() || brakes_W.torque != Vector3::Zero();
        n_ += brakes ? 1 : 0;
    }
    [[nodiscard]] int n() const noexcept { return n_; }
    /// 1 / n, or 1 where none brakes.
    [[nodiscard]] double share() const noexcept { return n_ > 1 ? 1.0 / n_ : 1.0; }
    /// Of a wrench that has these brakes in full.
    void take_from(Wrench& wrench, const Wrench& brakes_W) const noexcept {
        wrench.force -= (1.0 - share()) * brakes_W.force;
        wrench.torque -= (1.0 - share()) * brakes_W.torque;
    }

  private:
    int n_ = 0;
};

/// Refers to the objects' loads and to the step's time.
template <class Sampling>
// NOLINTNEXTLINE(cppcoreguidelines-virtual-class-destructor): never deleted as a Load
class ObjectsLoad final : public Load {
  public:
    ObjectsLoad(std::span<const SamplingLoad<Sampling>> objects, StepTime& time) noexcept
        : objects_(objects), time_(&time) {}

    void add_wrench(const RigidState& state, double time_s,
                    Wrench& wrench) const noexcept override {
        time_->begin_look();
        Sum sum;
        for (const SamplingLoad<Sampling>& object : objects_) {
            sum.add(object.compute_contact(state, time_s), wrench);
        }
        sum.shared.take_from(wrench, sum.brakes_W);
        time_->end_look();
    }
    void add_linearised_wrench(const RigidState& state, double time_s, Wrench& wrench,
                               WrenchJacobian& jacobian) const noexcept override {
        time_->begin_look();
        Sum sum;
        WrenchJacobian brakes_by;
        for (const SamplingLoad<Sampling>& object : objects_) {
            sum.add(object.compute_linearised_contact(state, time_s, jacobian, brakes_by), wrench);
        }
        sum.shared.take_from(wrench, sum.brakes_W);
        if (sum.shared.n() > 0) {
            jacobian.pose += sum.shared.share() * brakes_by.pose;
            jacobian.velocity += sum.shared.share() * brakes_by.velocity;
        }
        time_->end_look();
    }
    [[nodiscard]] bool has_time() const noexcept override { return time_->has_time(); }

  private:
    struct Sum {
        SharedBrakes shared;
        Wrench brakes_W{};

        void add(const VoxelContact& one, Wrench& wrench) noexcept {
            shared.add(one.brakes_W);
            brakes_W.force += one.brakes_W.force;
            brakes_W.torque += one.brakes_W.torque;
            wrench.force += one.wrench_W.force;
            wrench.torque += one.wrench_W.torque;
        }
    };

    std::span<const SamplingLoad<Sampling>> objects_;
    StepTime* time_;
};

}  // namespace fulcrum
