// Turns the plan's solids about their axles by what the hand presses.
//
//   r = contact - pivot,  tau = axis . (r x F),  F that of the hand on this solid (solid_push.h)
// The solid's pose for this round's proxy is that at the end of the last round; so the surface under the proxy moves with the body,
// and its friction takes it along.
//
// A tool in six degrees of freedom presses with a force at a place and a couple (tool_stage.h): tau = axis . (r x F + M), limited alike.
//
// A body that is put on another pivot has its inertia about that (axle.h), and no less than kLeastRimMass_kg asks for.
//
// Thread: haptic loop. Cost: 60 ns an axle and round, and the copy of the report. No allocation in a step.
#pragma once

#include "haptics/handover/axle_messages.h"
#include "haptics/loop/haptic_plan.h"
#include "haptics/loop/solid_push.h"
#include "haptics/point/proxy.h"

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace fulcrum {

class AxleStage {
  public:
    /// Takes a plan that `validate` accepted. `channels` may be null: then nothing is ordered or told.
    AxleStage(const HapticPlan& plan, AxleChannels* channels);

    /// First in a round: takes the lesson's orders, and gives the poses of all solids with those on axles turned. Valid until
    /// the next call.
    [[nodiscard]] std::span<const Pose> turn(std::span<const Pose> poses_W) noexcept;
    /// Bit i: an order has put solid i elsewhere at once, in the last `turn`.
    [[nodiscard]] std::uint32_t put() const noexcept { return put_; }
    /// Then, when the forces are known. Moves all axles on and tells of them.
    void push(const ProxyContact& contact, const HandPush& hand, double dt_s) noexcept;
    /// The same of a tool: one push a solid of the plan; none is given more than `most`.
    void push_by_tool(std::span<const SolidPush> pushes, const MostFelt& most,
                      double dt_s) noexcept;

    [[nodiscard]] std::size_t memory_bytes() const noexcept;

  private:
    struct Axle {
        std::size_t solid = 0;
        AxlePlan plan{};
        AxleSettings settings{};  // on the pivot where it is now
        AxleState state{};
        std::uint32_t n_angles = 0;
        std::uint32_t n_spins = 0;
        Pose rest_W{};  // of the body at angle 0, in this round
    };
    void move_on(std::size_t i, SolidPush push, const MostFelt& most, double dt_s) noexcept;
    void tell() noexcept;
    static bool take_order(const AxleOrder& order, Axle& axle) noexcept;

    AxleChannels* channels_;
    double cursor_m_;  // from the proxy to where it touches
    std::vector<Axle> axles_;
    std::array<Pose, kMaxSolids> poses_W_{};
    std::uint32_t put_ = 0;
    AxleFrame frame_{};
};

/// Refuses axles of solids that there are not, two of one solid, settings out of range, and a body so light that a hand's
/// coupling would shake it (kLeastRimMass_kg).
[[nodiscard]] Expected<void> validate_axles(const HapticPlan& plan);

/// Null where nothing turns.
[[nodiscard]] std::unique_ptr<AxleStage> make_axle_stage(const HapticPlan& plan,
                                                         AxleChannels* channels);

}  // namespace fulcrum
