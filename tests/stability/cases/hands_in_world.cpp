// Hands among rigid bodies: pushed, squeezed, lifted and stacked in closed loop, with a world that keeps up and one that does not.
#include "tests/support/hands_in_world.h"

#include "tests/stability/cases/stability_case.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fulcrum::stability {
namespace {

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

}  // namespace
}  // namespace fulcrum::stability
