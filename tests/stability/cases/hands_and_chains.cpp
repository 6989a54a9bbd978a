#include "haptics/dynamics/rigid_world.h"
#include "tests/stability/cases/stability_case.h"
#include "tests/support/hands_in_world.h"
#include "tests/support/rigid_worlds.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace fulcrum::stability {
namespace {

constexpr double kMostParted_m = 5.0e-5;

constexpr double kHalf_m = 0.03;  // of each box
constexpr double kFinger_m = 0.006;
constexpr double kStarved_Hz = 20.0;

double go_gently(double share) {
    const double s = std::clamp(share, 0.0, 1.0);
    return s * s * (3.0 - 2.0 * s);
}

// The worst energy that a hand was given beyond the ideal, over arms, masses and rates of the world down to 20 Hz.
double push_in_starved_world(double late_periods) {
    double worst_J = 0.0;
    for (const double rate_hz : {1000.0, 100.0, kStarved_Hz}) {
        for (const double mass_kg : {0.02, 0.2, 2.0}) {
            for (const HumanImpedance& human : {kFingertip, kArm, kPosture}) {
                test::BoxScene scene;
                scene.world_rate_hz = rate_hz;
                scene.world_late_s = late_periods / rate_hz;
                scene.boxes[0].mass_kg = mass_kg;
                scene.human = human;
                test::HandsInWorld hands(scene, {{-0.06, 0.03, 0.0}});
                for (int i = 0; i < 1500; ++i) {
                    hands.aim(0, {-0.06 + 0.12 * go_gently((i - 300) / 1000.0), 0.03, 0.0});
                    hands.step();
                }
                worst_J = worse(worst_J, hands.state(0).force_energy.peak_J);
            }
        }
    }
    return worst_J;
}

// Two fingers beside a box, which squeeze it by `grip` of 0 to 1 about a middle.
struct TwoFingers {
    explicit TwoFingers(test::BoxScene scene)
        : hands(make(std::move(scene)), {-kSide - kBeside, kSide + kBeside}) {}
    void squeeze(const Vector3& middle, double grip) {
        const Vector3 out = kSide + kBeside * (1.0 - 1.3 * grip);
        hands.aim(0, middle - out);
        hands.aim(1, middle + out);
        hands.step();
    }
    static test::BoxScene make(test::BoxScene scene) {
        scene.coupling = {.stiffness_N_per_m = 1000.0, .damping_Ns_per_m = 9.5};
        scene.human = {0.05, 15.0, 3000.0};
        return scene;
    }

    static inline const Vector3 kSide{kHalf_m + kFinger_m, 0.0, 0.0};
    static inline const Vector3 kBeside{0.02, 0.0, 0.0};
    test::HandsInWorld hands;
};

// The world stalls to 20 Hz while two fingers hold a box up: how far it sinks or swings then.
Finding hold_while_world_starves() {
    TwoFingers fingers({});
    for (int i = 0; i < 2000; ++i) {
        const double t = 1.0e-3 * i;
        fingers.squeeze({0.0, 0.03 + 0.1 * go_gently((t - 0.7) / 0.8), 0.0}, go_gently(t / 0.6));
    }
    const Vector3 before_W = fingers.hands.box_W(0).position;
    fingers.hands.set_world_rate(kStarved_Hz, 1.0 / kStarved_Hz);
    double worst_m = 0.0;
    for (int i = 0; i < 3000; ++i) {
        fingers.squeeze({0.0, 0.03 + 0.1, 0.0}, 1.0);
        worst_m = worse(worst_m, (fingers.hands.box_W(0).position - before_W).norm());
    }
    return {worst_m, 1.0e-3, ""};
}

// Two fingers carry a box onto another one: how far both are from where they should stand.
Finding stack_by_hand() {
    test::BoxScene scene;
    scene.boxes.push_back({.at_W = {0.15, 0.03, 0.0}});
    TwoFingers fingers(scene);
    for (int i = 0; i < 5500; ++i) {
        const double t = 1.0e-3 * i;
        fingers.squeeze(
            {0.15 * go_gently((t - 1.8) / 1.2),
             0.03 + 0.09 * go_gently((t - 0.8) / 0.8) - 0.0285 * go_gently((t - 3.2) / 0.8), 0.0},
            go_gently(t / 0.6) - go_gently((t - 4.3) / 0.4));
    }
    return {worse((fingers.hands.box_W(0).position - Vector3(0.15, 0.09, 0.0)).norm(),
                  (fingers.hands.box_W(1).position - Vector3(0.15, 0.03, 0.0)).norm()),
            3.0e-3, ""};
}

// A hand that stands, a spring without a damper or late mass, speaks as each step of the world begins; its body swings on it. What an
// observer of its port counts, impulse by way, is what the hand gave: never more than the spring held.
double swing_on_late_spring(double step_s, double stiffness_N_per_m, double mass_kg) {
    test::BoxScene scene;
    scene.boxes[0].mass_kg = mass_kg;
    scene.boxes[0].at_W = {0.0, 1.0, 0.0};
    RigidLoopPlan plan = scene.make_world();
    plan.world.settings.gravity_W.setZero();
    RigidChannels channels;
    RigidChannels* const hands[] = {&channels};
    const auto loop = std::move(RigidLoop::create(plan, nullptr, hands)).value();
    const Vector3 hand_W = scene.boxes[0].at_W + Vector3(0.02, 0.01, 0.0);
    const double held_J = 0.5 * stiffness_N_per_m * 5.0e-4;
    double given_J = 0.0;
    double worst = 0.0;
    for (int i = 1; i <= 2000; ++i) {
        const RigidState before = loop->world().state(1);
        HandPushes pushes;
        pushes.stamp_s = (i - 1) * step_s;
        pushes.count = 1;
        RigidPush& push = pushes.pushes[0];
        push.solid = 0;
        push.pose_W = before.pose_W;
        push.velocity_W = before.velocity_W;
        push.hold.at_W = before.pose_W.position;
        push.hold.push_W.force = stiffness_N_per_m * (hand_W - before.pose_W.position);
        push.hold.slopes.stiffness_N_per_m = stiffness_N_per_m;
        push.hold.bounds = {.most_N = 1.0e3, .most_Nm = 1.0};
        channels.pushes.publish(pushes);
        loop->step(i * step_s);
        const RigidState& after = loop->world().state(1);
        const Vector3 impulse_Ns = mass_kg * (after.velocity_W.linear - before.velocity_W.linear);
        given_J += impulse_Ns.dot(after.pose_W.position - before.pose_W.position) / step_s;
        worst = worse(worst, given_J / held_J);
    }
    return worst;
}

Finding swing_on_late_springs() {
    double worst = 0.0;
    for (const double step_s : {1.0e-3, 5.0e-3, 0.02, 0.05}) {
        for (const double stiffness_N_per_m : {100.0, 600.0, 4000.0}) {
            for (const double mass_kg : {0.02, 0.2, 2.0}) {
                worst = worse(worst, swing_on_late_spring(step_s, stiffness_N_per_m, mass_kg));
            }
        }
    }
    return {worst, 1.0, ""};
}

const HardCase kLateSpring{{"a spring as old as the step",
                            "a hand holds a body of 20 g to 2 kg by a spring without a damper, and "
                            "speaks as each step of 1 to 50 ms begins",
                            "energy that the hand gave, of what its spring held", "",
                            swing_on_late_springs}};
const HardCase kStarvedPush{{"a box pushed in a world of 20 Hz",
                             "a finger, an arm and a posture push boxes of 20 g to 2 kg while the "
                             "world steps 1000 to 20 times a second",
                             "energy that the hand was given beyond the ideal", "J", [] {
                                 return Finding{push_in_starved_world(0.0), 3.0e-3, ""};
                             }}};
const HardCase kLatePush{{"a box pushed in a world of 20 Hz that is told late",
                          "the same, where each step's computing takes until the next begins",
                          "energy that the hand was given beyond the ideal", "J", [] {
                              return Finding{push_in_starved_world(1.0), 5.0e-3, ""};
                          }}};
const HardCase kStarvedHold{
    {"a held box while the world starves",
     "two fingers hold a box in the air by friction when the world falls from 1 kHz to 20 Hz",
     "how far the box moves", "m", hold_while_world_starves}};
const HardCase kStack{
    {"two fingers stack a box",
     "two hands in closed loop squeeze a rigid box, carry it onto another and let go",
     "how far both boxes are from their places", "m", stack_by_hand}};

struct SpinningChain {
    SolidShape rod = CapsuleShape{0.005, 0.1};
    double rod_spin_rad_per_s = 0.0;  // about itself
    double off_axis_m = 0.0;          // of the joints
};

RigidWorldPlan make_spinning_chain(const SpinningChain& chain) {
    constexpr double kSpin_rad_per_s = 20.0;
    RigidWorldPlan plan;
    plan.settings.gravity_W.setZero();
    plan.settings.sleep_after_s = 0.0;
    const Vector3 spin(0.0, 0.0, kSpin_rad_per_s);
    for (const double side : {-1.0, 1.0}) {
        plan.bodies.push_back({.shape = BoxShape{Vector3::Constant(0.02)},
                               .mass_kg = 1.0,
                               .pose_W = Pose::at({side * 0.2, 0.0, 0.0}),
                               .velocity_W = {{0.0, side * 0.2 * kSpin_rad_per_s, 0.0}, spin}});
        plan.joints.push_back({.kind = JointKind::ball,
                               .body_a = side < 0.0 ? 0 : 1,
                               .body_b = 2,
                               .anchor_W = {side * 0.12, side * chain.off_axis_m, 0.0}});
    }
    plan.bodies[0].velocity_W.linear.z() = 0.02;  // out of the plane
    plan.bodies.push_back(
        {.shape = chain.rod,
         .mass_kg = 0.1,
         .pose_W = {Vector3::Zero(), Quaternion(AngleAxis(M_PI / 2, Vector3::UnitZ()))},
         .velocity_W = {Vector3::Zero(), spin + Vector3(chain.rod_spin_rad_per_s, 0.0, 0.0)}});
    return plan;
}

// Of what it began with, in 10 s.
double find_gain(const SpinningChain& chain) {
    const auto world = make_rigid_world(make_spinning_chain(chain));
    const double energy_J = world->compute_energy_J();
    double gain = 0.0;
    for (int i = 0; i < 10000; ++i) {
        world->step(1.0e-3);
        gain = worse(gain, world->compute_energy_J() / energy_J - 1.0);
    }
    return gain;
}

Finding spin_thin_chain() {
    double worst = 0.0;
    for (const SpinningChain& chain :
         {SpinningChain{}, SpinningChain{.rod = CapsuleShape{0.001, 0.1}},
          SpinningChain{.rod_spin_rad_per_s = 600.0}, SpinningChain{.rod_spin_rad_per_s = 2.0e4},
          // Three different moments, and joints that go round with the rod.
          SpinningChain{.rod = BoxShape{{0.005, 0.1, 0.02}}, .rod_spin_rad_per_s = 1000.0},
          SpinningChain{
              .rod = CapsuleShape{0.02, 0.1}, .rod_spin_rad_per_s = 600.0, .off_axis_m = 0.01}}) {
        worst = worse(worst, find_gain(chain));
    }
    return {worst, 0.01, {}};
}

constexpr int kLinks = 4;
constexpr double kLink_m = 0.1;

// Links in a row from the origin on, the first one pinned there or free.
RigidWorldPlan make_row_of_links(double spin_rad_per_s, bool is_pinned) {
    RigidWorldPlan plan;
    plan.settings.gravity_W.setZero();
    plan.settings.sleep_after_s = 0.0;
    const double middle_m = is_pinned ? 0.0 : 0.5 * kLinks * kLink_m;
    for (int i = 0; i < kLinks; ++i) {
        const double at_m = (i + 0.5) * kLink_m;
        plan.bodies.push_back(
            {.shape = CapsuleShape{0.01, 0.03},
             .mass_kg = 0.1,
             .pose_W = {{at_m, 0.0, 0.0}, Quaternion(AngleAxis(M_PI / 2, Vector3::UnitZ()))},
             .velocity_W = {{0.0, (at_m - middle_m) * spin_rad_per_s, 0.0},
                            {0.0, 0.0, spin_rad_per_s}}});
        plan.joints.push_back({.kind = JointKind::ball,
                               .body_a = i - 1,
                               .body_b = i,
                               .anchor_W = {i * kLink_m, 0.0, 0.0}});
    }
    if (!is_pinned) {
        plan.joints.erase(plan.joints.begin());
    }
    plan.bodies[0].velocity_W.linear.z() = 0.3;  // out of the plane
    return plan;
}

// How far the pins of such links part: the first one's from the world where it is pinned.
double find_parted_m(const RigidWorld& world, bool is_pinned) {
    const Vector3 half(0.0, 0.5 * kLink_m, 0.0);
    double parted_m = is_pinned ? (world.shape_pose_W(0) * half).norm() : 0.0;
    for (int i = 1; i < kLinks; ++i) {
        parted_m = worse(parted_m,
                         (world.shape_pose_W(i - 1) * -half - world.shape_pose_W(i) * half).norm());
    }
    return parted_m;
}

struct SpunLinks {
    double parted_m = 0.0;
    double changed = 0.0;  // energy, of what it was
};

SpunLinks spin_links(double spin_rad_per_s, double step_s, bool is_pinned) {
    const auto world = make_rigid_world(make_row_of_links(spin_rad_per_s, is_pinned));
    const double energy_J = world->compute_energy_J();
    SpunLinks spun;
    for (int i = 0; i < static_cast<int>(4.0 / step_s); ++i) {
        world->step(step_s);
        spun.parted_m = worse(spun.parted_m, find_parted_m(*world, is_pinned));
        spun.changed = worse(spun.changed, std::abs(world->compute_energy_J() / energy_J - 1.0));
    }
    return spun;
}

SpunLinks spin_all_links() {
    SpunLinks all;
    for (const double step_s : {1.0e-3, 1.0e-2}) {
        for (const double spin_rad_per_s : {15.0, 30.0, 100.0}) {
            for (const bool is_pinned : {false, true}) {
                const SpunLinks spun = spin_links(spin_rad_per_s, step_s, is_pinned);
                all.parted_m = worse(all.parted_m, spun.parted_m);
                all.changed = worse(all.changed, spun.changed);
            }
        }
    }
    return all;
}

// A motor swings a row of links round, with weight, and a clock of slow steps.
double drive_links() {
    RigidWorldPlan plan = make_row_of_links(0.0, true);
    plan.settings.gravity_W = {0.0, -9.81, 0.0};
    plan.settings.slow_period_s = 0.01;
    plan.joints[0].kind = JointKind::hinge;
    plan.joints[0].axis_W = Vector3::UnitZ();
    plan.joints[0].drive = {.motor_speed = 30.0, .motor_force = 20.0};
    const auto world = make_rigid_world(plan);
    double parted_m = 0.0;
    for (int i = 0; i < 4000; ++i) {
        world->step(1.0e-3);
        parted_m = worse(parted_m, find_parted_m(*world, true));
    }
    return parted_m;
}

const HardCase kPins{{"pins of a spinning chain",
                      "four links spin at 15 to 100 rad/s, free or pinned at an end, in steps of 1 "
                      "and 10 ms",
                      "how far any pin parts", "m", [] {
                          return Finding{spin_all_links().parted_m, kMostParted_m, {}};
                      }}};
const HardCase kKept{
    {"energy of a spinning chain", "the same", "energy won or lost, of all", "", [] {
         return Finding{spin_all_links().changed, 0.01, {}};
     }}};
const HardCase kDriven{
    {"pins of a driven chain",
     "a motor of 30 rad/s swings four links round against their weight, in steps "
     "of 10 ms",
     "how far any pin parts", "m", [] {
         return Finding{drive_links(), kMostParted_m, {}};
     }}};
const HardCase kThinChain{
    {"spinning thin chain",
     "two cubes of 1 kg on a thin rod of 0.1 kg spin for 10 s, the rod about itself too",
     "energy won, of all", "", spin_thin_chain}};

}  // namespace

}  // namespace fulcrum::stability
