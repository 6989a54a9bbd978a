// Hands among rigid bodies: pushed, squeezed, lifted and stacked in closed loop, with a world that keeps up and one that does not.
#include "tests/support/hands_in_world.h"

#include "tests/stability/cases/stability_case.h"

#include <algorithm>
#include <cmath>

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

// The world stalls to 20 Hz while two fingers hold a box up: how far it sinks or swings then.
Finding hold_while_world_starves() {
    test::BoxScene scene;
    scene.coupling = {.stiffness_N_per_m = 1000.0, .damping_Ns_per_m = 9.5};
    scene.human = {0.05, 15.0, 3000.0};
    const Vector3 side(kHalf_m + kFinger_m, 0.0, 0.0);
    const Vector3 beside(0.02, 0.0, 0.0);
    test::HandsInWorld hands(scene, {-side - beside, side + beside});
    const auto squeeze = [&](double t, double lift_m) {
        const Vector3 middle(0.0, 0.03 + lift_m, 0.0);
        const Vector3 out =
            side + beside * (1.0 - go_gently(t / 0.6)) - 0.3 * beside * go_gently(t / 0.6);
        hands.aim(0, middle - out);
        hands.aim(1, middle + out);
    };
    for (int i = 0; i < 2000; ++i) {
        squeeze(1.0e-3 * i, 0.1 * go_gently((1.0e-3 * i - 0.7) / 0.8));
        hands.step();
    }
    const Vector3 before_W = hands.box_W(0).position;
    hands.set_world_rate(kStarved_Hz, 1.0 / kStarved_Hz);
    double worst_m = 0.0;
    for (int i = 0; i < 3000; ++i) {
        squeeze(2.0, 0.1);
        hands.step();
        worst_m = worse(worst_m, (hands.box_W(0).position - before_W).norm());
    }
    return {worst_m, 1.0e-3, ""};
}

// Two fingers carry a box onto another one: how far both are from where they should stand.
Finding stack_by_hand() {
    test::BoxScene scene;
    scene.coupling = {.stiffness_N_per_m = 1000.0, .damping_Ns_per_m = 9.5};
    scene.human = {0.05, 15.0, 3000.0};
    scene.boxes.push_back({.at_W = {0.15, 0.03, 0.0}});
    const Vector3 side(kHalf_m + kFinger_m, 0.0, 0.0);
    const Vector3 beside(0.02, 0.0, 0.0);
    test::HandsInWorld hands(scene, {-side - beside, side + beside});
    for (int i = 0; i < 5500; ++i) {
        const double t = 1.0e-3 * i;
        const Vector3 middle(
            0.15 * go_gently((t - 1.8) / 1.2),
            0.03 + 0.09 * go_gently((t - 0.8) / 0.8) - 0.0285 * go_gently((t - 3.2) / 0.8), 0.0);
        const double grip = go_gently(t / 0.6) - go_gently((t - 4.3) / 0.4);
        hands.aim(0, middle - side - (1.0 - 1.3 * grip) * beside);
        hands.aim(1, middle + side + (1.0 - 1.3 * grip) * beside);
        hands.step();
    }
    return {worse((hands.box_W(0).position - Vector3(0.15, 0.09, 0.0)).norm(),
                  (hands.box_W(1).position - Vector3(0.15, 0.03, 0.0)).norm()),
            3.0e-3, ""};
}

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
