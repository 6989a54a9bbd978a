// A tool held out by clusters of contact (implicit_penalty.h), led step by step, and what must hold after each of them whatever the hand
// and the objects do:
//
//   finite   force, torque and the tool's place are numbers, and every step with good input is made
//   limits   |F| <= the coupling's clamp, |tau| <= the clamp of its turn
//   energy   what the hand was given so far, sum of F dx + tau dtheta, no more than it has put in
//   free     0 N, to the bit, where nothing is near
#pragma once

#include "haptics/geometry/shape.h"
#include "haptics/math/rotation.h"
#include "tests/stability/cases/stability_case.h"
#include "tests/support/tool_scene.h"

#include <cmath>
#include <memory>
#include <span>
#include <vector>

namespace fulcrum::stability {

inline constexpr double kPenaltyDt_s = 0.001;
inline constexpr double kPenaltyMost_N = 5.0;
inline constexpr double kPenaltyCoupling_N_per_m = 500.0;

/// A tool about its own middle among objects, found by fields with cells of `voxel_m` or by levels; twice that counts as near.
struct PenaltyScene {
    TriangleMesh tool;
    Inertia inertia{};
    double voxel_m = 0.002;
    std::vector<TriangleMesh> objects;
    double most_N = kPenaltyMost_N;
    double turn_Nm_per_rad = 0.2;
    int n_points = 3000;
    ContactFinding contact = ContactFinding::fields;
};

inline ToolPlan plan_penalty(const PenaltyScene& scene) {
    test::ToolScene made{.tool = scene.tool,
                         .inertia = scene.inertia,
                         .method = ToolMethod::implicit_penalty,
                         .voxel_m = scene.voxel_m,
                         .n_points = scene.n_points,
                         .most_force_N = scene.most_N,
                         .contact = scene.contact};
    made.settings.coupling.shift.stiffness_N_per_m = kPenaltyCoupling_N_per_m;
    made.settings.coupling.turn.stiffness_Nm_per_rad = scene.turn_Nm_per_rad;
    return *test::make_tool_of(made, scene.objects);
}

/// The handle of a cube over a ball of 40 mm, `round` it and turned with it; `down` is 0 far away and 1 deep in it.
inline Pose hold_over_ball(double down, double round) {
    return {(0.09 - 0.04 * down) *
                Vector3(std::sin(round), std::cos(round), 0.3 * std::sin(3.0 * round)).normalized(),
            compute_exp(Vector3(0.0, 0.0, -round))};
}

class PenaltyWatch {
  public:
    explicit PenaltyWatch(const PenaltyScene& scene)
        : plan_(plan_penalty(scene)),
          tool_(ImplicitPenaltyTool::build(make_implicit_penalty_plan(plan_)).value()),
          objects(scene.objects.size()) {}

    void place(const Pose& handle) {
        tool_.place(handle);
        handle_ = handle;
        felt_ = {};
    }
    /// A step of good input.
    ToolFelt step(const MovingFrame& handle, double dt_s = kPenaltyDt_s) {
        const ToolFelt felt = move(handle, dt_s);
        n_standing_ += felt.moved ? 0 : 1;
        // As if the force had gone on evenly.
        const Vector3 way = handle.pose_W.position - handle_.position;
        const Vector3 turn =
            compute_log(handle.pose_W.orientation * handle_.orientation.conjugate());
        given_J_ += 0.5 * (felt_.force + felt.felt_W.force).dot(way) +
                    0.5 * (felt_.torque + felt.felt_W.torque).dot(turn);
        most_given_J_ = worse(most_given_J_, given_J_);
        step_N_ = worse(step_N_, (felt.felt_W.force - felt_.force).norm());
        handle_ = handle.pose_W;
        felt_ = felt.felt_W;
        return felt;
    }
    /// The hand's next place, its speed as the loop finds it.
    ToolFelt step(const Pose& handle, double dt_s = kPenaltyDt_s) {
        const Twist going{(handle.position - handle_.position) / dt_s,
                          compute_log(handle.orientation * handle_.orientation.conjugate()) / dt_s};
        return step(MovingFrame{handle, going}, dt_s);
    }
    /// A step of any input: what is no number is refused, and the rest keeps within the limits.
    ToolFelt move(const MovingFrame& handle, double dt_s = kPenaltyDt_s) {
        now_s_ += dt_s;
        const ToolFelt felt = tool_.move(handle, objects, now_s_, dt_s);
        const bool good = felt.felt_W.force.allFinite() && felt.felt_W.torque.allFinite() &&
                          is_finite(tool_.state().pose_W) &&
                          tool_.state().velocity_W.linear.allFinite() &&
                          tool_.state().velocity_W.angular.allFinite();
        n_bad_ += good ? 0 : 1;
        ++n_steps_;
        most_N_ = worse(most_N_, felt.felt_W.force.norm());
        most_Nm_ = worse(most_Nm_, felt.felt_W.torque.norm());
        n_touching_ += felt.felt_W.force != Vector3::Zero() ? 1 : 0;
        return felt;
    }
    void demand(double share) { worst_ = worse(worst_, share); }
    void demand(bool holds) { demand(holds ? 0.0 : 100.0); }
    /// From now on the hand starts anew.
    void forget_energy() { given_J_ = most_given_J_ = 0.0; }

    [[nodiscard]] ImplicitPenaltyTool& tool() { return tool_; }
    [[nodiscard]] double speed_m_per_s() const { return tool_.state().velocity_W.linear.norm(); }
    [[nodiscard]] int n_touching() const { return n_touching_; }
    [[nodiscard]] double most_given_J() const { return most_given_J_; }
    [[nodiscard]] double largest_step_N() const { return step_N_; }
    [[nodiscard]] double most_Nm() const { return most_Nm_; }

    /// Of all demands the worst, with the four laws above; `energy_J`: as much as the tool may bring along from free space.
    [[nodiscard]] Finding judge(double energy_J) const {
        const ToolCouplingSettings& coupling = tool_.settings().coupling;
        const double clamp_N = coupling.clamp_m * coupling.shift.stiffness_N_per_m;
        const double clamp_Nm = coupling.clamp_rad * coupling.turn.stiffness_Nm_per_rad;
        constexpr double kRounding = 1.0001;
        double worst = worse(worst_, n_standing_ == 0 && n_bad_ == 0 ? 0.0 : 100.0);
        worst = worse(worst, most_N_ / (kRounding * clamp_N));
        worst = worse(worst, most_Nm_ / (kRounding * clamp_Nm));
        worst = worse(worst, most_given_J_ / energy_J);
        return {
            worst, 1.0,
            describe("felt in %d of %d steps, at most %.3g N, steps of %.2g N, %.2g mJ given, %.2g "
                     "of what is allowed",
                     n_touching_, n_steps_, most_N_, step_N_, 1.0e3 * most_given_J_, worst_)};
    }

  private:
    ToolPlan plan_;
    ImplicitPenaltyTool tool_;

  public:
    std::vector<MovingFrame> objects;

  private:
    Pose handle_{};
    Wrench felt_{};
    double now_s_ = 0.0;
    double given_J_ = 0.0;
    double most_given_J_ = 0.0;
    double most_N_ = 0.0;
    double most_Nm_ = 0.0;
    double step_N_ = 0.0;
    double worst_ = 0.0;
    int n_steps_ = 0;
    int n_bad_ = 0;
    int n_standing_ = 0;
    int n_touching_ = 0;
};

inline constexpr const char* kPenaltyMeasured =
    "worst of: what the case asks, force and torque in their clamps, energy given to the hand in "
    "what its tool may bring along; 100: something was no number, or a good step was not made";

}  // namespace fulcrum::stability
