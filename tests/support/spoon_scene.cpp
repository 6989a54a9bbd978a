#include "tests/support/spoon_scene.h"

#include "haptics/dynamics/loads.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fulcrum::test {
namespace {

const Vector3 kSpoon_m{0.012, 0.003, 0.14};  // the stem lies along z
const Vector3 kGrip_B{0.0, 0.0, -0.06};
const Vector3 kTip_B{0.0, 0.0, 0.07};
constexpr double kStation_m = 0.005;  // of the touching corners, on both sides of the middle
constexpr double kRingHalfWidth_m = 0.008;
constexpr double kRingHalfHeight_m = 0.005;
constexpr double kWall_m = 0.095;  // before the tip, which starts at 0.07

// Minimum jerk: from 0 to 1 while s goes from 0 to 1, with no speed and no acceleration at the ends.
struct Course {
    double way;
    double speed;
};
Course compute_course(double time_s, double from_s, double to_s) {
    const double s = std::clamp((time_s - from_s) / (to_s - from_s), 0.0, 1.0);
    return {s * s * s * (10.0 + s * (6.0 * s - 15.0)),
            30.0 * s * s * (1.0 - s) * (1.0 - s) / (to_s - from_s)};
}

MovingFrame compute_hand(double time_s) {
    const Course forward = compute_course(time_s, 0.0, 0.12);
    const Course pressed = compute_course(time_s, 0.12, 0.30);
    const Course across = compute_course(time_s, 0.45, 0.60);
    const Vector3 way_forward(0.0, 0.0, 0.02);
    const Vector3 way_pressed(0.010, 0.012, 0.0);
    const Vector3 way_across(-0.006, 0.0, 0.0);
    const Vector3 turn(0.0, 0.0, 0.15);
    MovingFrame hand;
    hand.pose_W.position =
        kGrip_B + forward.way * way_forward + pressed.way * way_pressed + across.way * way_across;
    hand.pose_W.orientation = compute_exp(pressed.way * turn);
    hand.velocity_W.linear =
        forward.speed * way_forward + pressed.speed * way_pressed + across.speed * way_across;
    hand.velocity_W.angular = pressed.speed * turn;
    return hand;
}

std::vector<PlaneContact> make_cup(const SpoonSettings& settings) {
    std::vector<PlaneContact> contacts;
    const auto touch = [&](const Vector3& point_B, const Vector3& plane_point_W,
                           const Vector3& normal_W) {
        contacts.push_back({.point_B = point_B,
                            .plane_point_W = plane_point_W,
                            .normal_W = normal_W,
                            .stiffness_N_per_m = settings.contact_stiffness_N_per_m,
                            .damping_Ns_per_m = settings.contact_damping_Ns_per_m});
    };
    for (const double x : {-1.0, 1.0}) {
        for (const double y : {-1.0, 1.0}) {
            for (const double z : {-1.0, 1.0}) {
                const Vector3 corner_B(0.5 * x * kSpoon_m.x(), 0.5 * y * kSpoon_m.y(),
                                       z * kStation_m);
                for (const double side : {-1.0, 1.0}) {
                    touch(corner_B, {side * kRingHalfWidth_m, 0.0, 0.0}, {-side, 0.0, 0.0});
                    touch(corner_B, {0.0, side * kRingHalfHeight_m, 0.0}, {0.0, -side, 0.0});
                }
            }
        }
    }
    touch(kTip_B, {0.0, 0.0, kWall_m}, {0.0, 0.0, -1.0});
    return contacts;
}

}  // namespace

std::vector<SpoonSample> run_spoon(const SpoonSettings& settings) {
    const Inertia inertia = make_box_inertia(settings.mass_kg, kSpoon_m);
    const std::vector<PlaneContact> contacts = make_cup(settings);
    const PlaneContactsLoad cup(contacts);
    ToolCouplingLoad coupling(make_critically_damped({}, settings.mass_kg, inertia.moments_kg_m2),
                              kGrip_B);
    const Loads all(coupling, cup);
    IntegratorSettings integrator;
    integrator.integrator = settings.integrator;
    integrator.newton_iterations = settings.newton_iterations;
    RigidState state;
    std::vector<SpoonSample> samples;
    const int n_steps = static_cast<int>(std::lround(kSpoonCourse_s / settings.dt_s));
    for (int i = 1; i <= n_steps; ++i) {
        // The hand is measured at the end of the step, as the paper's haptic thread does.
        const double now_s = i * settings.dt_s;
        const MovingFrame hand = compute_hand(now_s);
        coupling.set_handle(hand, now_s);
        SpoonSample sample{};
        sample.step =
            step_rigid_body(integrator, inertia, all, now_s - settings.dt_s, settings.dt_s, state);
        sample.time_s = now_s;
        sample.coupling_deviation_m = (hand.pose_W.position - state.pose_W * kGrip_B).norm();
        sample.felt_force_N = coupling.compute_felt_wrench(state, now_s).force.norm();
        sample.kinetic_energy_J = compute_kinetic_energy_J(inertia, state);
        for (const PlaneContact& contact : contacts) {
            const double depth_m = compute_depth_m(contact, state.pose_W);
            sample.penetration_m = std::max(sample.penetration_m, depth_m);
            sample.n_touching += depth_m > 0.0 ? 1 : 0;
        }
        Wrench push;
        cup.add_wrench(state, now_s, push);
        sample.contact_force_N = push.force.norm();
        samples.push_back(sample);
    }
    return samples;
}

bool comes_to_rest(const std::vector<SpoonSample>& samples) {
    constexpr double kStill_J = 1.0e-6;
    return std::all_of(samples.begin(), samples.end(), [](const SpoonSample& sample) {
        const bool still = sample.time_s >= 0.40 && sample.time_s <= 0.45;
        return sample.step.moved() && (!still || sample.kinetic_energy_J < kStill_J);
    });
}

}  // namespace fulcrum::test
