// A peg of 288 triangles and a hole of 280, a thousandth wider: in, turned, trembling, out; by a simulated hand in closed loop at 1 kHz, or by a hand that
// nothing moves off its course.
#pragma once

#include "haptics/device/simulated/simulated_hand.h"
#include "haptics/math/rotation.h"
#include "tests/support/edited_meshes.h"
#include "tests/support/god_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fulcrum::test {

class PegTrial {
  public:
    static constexpr double kRadius_m = 0.01;
    static constexpr double kClearance = 1.001;
    static constexpr double kLength_m = 0.04;
    static constexpr double kBlock_m = 0.03;  // how long the hole is
    static constexpr double kAbove_m = 0.5 * (kLength_m + kBlock_m);
    static constexpr double kMass_kg = 0.05;
    static constexpr double kCourse_s = 3.7;  // at speed 1
    static constexpr double kRest_s = 0.5;    // behind it, whatever the speed

    /// What was seen.
    struct Found {
        double most_N = 0.0, most_step_N = 0.0;  ///< of the force, and of its change in a tick
        double most_Nm = 0.0, most_step_Nm = 0.0;
        double fastest_m_per_s = 0.0;                                ///< of the hand
        double deepest_m = std::numeric_limits<double>::infinity();  ///< above the block's middle
        double most_turn_rad = 0.0;
        double end_m = 0.0;
        int n_steps = 0;
        int n_crossing = 0;
        int n_unsettled = 0;  ///< steps that went on in the next one
        [[nodiscard]] double share() const { return most_step_N / most_N; }
    };

    PegTrial() : god_(make_god_tool(peg, {block}, make_god_settings(make_inertia()))) {}

    /// By the defaults of the simulated hand, or exactly along the course; so many times as fast.
    [[nodiscard]] Found run(double speed, bool by_hand) {
        LatestValue<HandTarget> target;
        SimulatedHandSettings settings;
        settings.start_pose_D = find_course(0.0);
        SimulatedHand hand(settings, target);
        god_.place(settings.start_pose_D);
        Found found;
        Wrench last_W{};
        Pose before = settings.start_pose_D;
        found.n_steps = static_cast<int>(std::lround((kCourse_s / speed + kRest_s) / kGodDt_s));
        for (int i = 0; i < found.n_steps; ++i) {
            const double now_s = i * kGodDt_s;
            Pose handle = find_course(speed * now_s);
            if (by_hand) {
                target.publish({handle, Vector3::Zero(), 0});
                DeviceReading reading;
                (void)hand.read(now_s, reading);
                handle = reading.pose_D;
            }
            const MovingFrame held{};
            const ToolFelt felt = god_.move({handle, {}}, {&held, 1}, now_s, kGodDt_s);
            (void)hand.write(now_s, felt.felt_W);
            look(felt.felt_W, last_W, found);
            found.fastest_m_per_s = std::max(found.fastest_m_per_s,
                                             (handle.position - before.position).norm() / kGodDt_s);
            last_W = felt.felt_W;
            before = handle;
        }
        found.end_m = god_.centre_W().z();
        return found;
    }

    const TriangleMesh peg = make_peg();
    const TriangleMesh block = make_block_with_hole(35, kRadius_m* kClearance, 0.03, kBlock_m);

  private:
    // make_cylinder stands along y; the hole goes along z.
    static TriangleMesh make_peg() {
        return move_corners(make_cylinder(kRadius_m, kLength_m, 72).value(),
                            [](const Vector3& v) { return Vector3(v.x(), -v.z(), v.y()); });
    }
    static Inertia make_inertia() {
        const double across =
            kMass_kg * (3.0 * kRadius_m * kRadius_m + kLength_m * kLength_m) / 12.0;
        return {kMass_kg, {across, across, 0.5 * kMass_kg * kRadius_m * kRadius_m}};
    }
    // From 0 to 1, without a jump of the speed.
    static double ease(double x) {
        const double t = std::clamp(x, 0.0, 1.0);
        return t * t * (3.0 - 2.0 * t);
    }
    // Down onto the rim beside the hole and askew, over it, down, turned and trembling; out again. Not pressed aside any more where it leaves the hole:
    // what nothing is near is not felt.
    static Pose find_course(double t_s) {
        const double aside = 1.0 - ease(2.0 * (t_s - 0.5));
        const double down =
            0.0046 * ease(2.0 * t_s) + 0.0254 * ease(t_s - 1.1) - 0.03 * ease(t_s - 2.8);
        const double trembling = 0.003 * (ease(2.0 * (t_s - 1.6)) - ease(2.5 * (t_s - 2.8)));
        const double turn_rad = 1.5 * ease(t_s - 1.6);
        return {
            Vector3(0.001 * aside + trembling * std::sin(8.0 * t_s),
                    -0.0007 * aside + trembling * std::cos(6.5 * t_s), kAbove_m + 0.004 - down),
            compute_exp(Vector3(0.01 * aside + 6.0 * trembling * std::sin(5.0 * t_s), 0.0, 0.0)) *
                compute_exp(Vector3(0.0, 0.0, turn_rad))};
    }
    void look(const Wrench& felt_W, const Wrench& last_W, Found& found) const {
        found.most_N = std::max(found.most_N, felt_W.force.norm());
        found.most_step_N = std::max(found.most_step_N, (felt_W.force - last_W.force).norm());
        found.most_Nm = std::max(found.most_Nm, felt_W.torque.norm());
        found.most_step_Nm = std::max(found.most_step_Nm, (felt_W.torque - last_W.torque).norm());
        found.deepest_m = std::min(found.deepest_m, god_.centre_W().z());
        found.most_turn_rad =
            std::max(found.most_turn_rad, compute_log(god_.pose_W().orientation).norm());
        found.n_crossing += do_enter(block, {}, peg, god_.pose_W()) ? 1 : 0;
        found.n_unsettled += god_.last_step().settled ? 0 : 1;
    }

    GodObjectTool god_;
};

}  // namespace fulcrum::test
