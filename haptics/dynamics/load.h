// What acts on a rigid body: the one interface between integrators and forces.
//
// A load answers two questions: its wrench at a state and a time, and the same with its derivatives by pose and velocity
// (wrench_jacobian.h says which perturbation). Explicit integrators ask the first, backward Euler the second, and that as often as
// there is time. Both *add*, so that several loads act together. A load is set before a step and stays as it is while the step asks, as often as it
// likes; `time_s` lies within the step.
//
// Thread: that of the step. Cost: one virtual call a load and question; `Loads` makes one of several at no further cost.
#pragma once

#include "haptics/dynamics/rigid_state.h"
#include "haptics/math/wrench_jacobian.h"

#include <tuple>

namespace fulcrum {

class Load {
  public:
    /// Adds the force (N) and the torque about the centre of mass (Nm), world frame, at `state` and `time_s`.
    virtual void add_wrench(const RigidState& state, double time_s,
                            Wrench& wrench) const noexcept = 0;
    /// The same, and adds the derivatives at that state.
    virtual void add_linearised_wrench(const RigidState& state, double time_s, Wrench& wrench,
                                       WrenchJacobian& jacobian) const noexcept = 0;
    /// Whether a solver may ask again; one that iterates ends with its best where it may not.
    [[nodiscard]] virtual bool has_time() const noexcept { return true; }

  protected:
    // Never deleted through this interface, so a step's code holds no deleting destructor.
    Load() = default;
    Load(const Load&) = default;
    Load& operator=(const Load&) = default;
    ~Load() = default;
};

/// Several loads of known types as one; refers to them, so they must live longer. `Loads<>` is none at all.
template <class... Parts>
// NOLINTNEXTLINE(cppcoreguidelines-virtual-class-destructor): never deleted as a Load
class Loads final : public Load {
  public:
    explicit Loads(const Parts&... parts) noexcept : parts_(parts...) {}

    void add_wrench(const RigidState& state, double time_s,
                    Wrench& wrench) const noexcept override {
        std::apply([&](const auto&... part) { (part.add_wrench(state, time_s, wrench), ...); },
                   parts_);
    }
    void add_linearised_wrench(const RigidState& state, double time_s, Wrench& wrench,
                               WrenchJacobian& jacobian) const noexcept override {
        std::apply(
            [&](const auto&... part) {
                (part.add_linearised_wrench(state, time_s, wrench, jacobian), ...);
            },
            parts_);
    }
    [[nodiscard]] bool has_time() const noexcept override {
        return std::apply([](const auto&... part) { return (part.has_time() && ...); }, parts_);
    }

  private:
    std::tuple<const Parts&...> parts_;
};

}  // namespace fulcrum
