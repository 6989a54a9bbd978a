// Thin plates at speed through the whole haptic loop: the force that reaches the device points out of the side the hand
// came from, whatever it crosses.
#include "haptics/geometry/shape.h"
#include "haptics/loop/haptic_loop.h"
#include "tests/stability/cases/stability_case.h"
#include "tests/support/box_place.h"
#include "tests/support/scripted_device.h"
#include "tests/support/touchable.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace fulcrum::stability {
namespace {

constexpr double kTick_s = 1.0e-3;
constexpr double kSpeed_m_per_s = 5.0;
constexpr double kThickness_m = 1.0e-3;
constexpr int kCrossings = 20;
constexpr int kTicks = 60;         // there, and as many back
constexpr int kTicksBetween = 20;  // at rest, for the force to fall

// A loop that touches one plate of 1 mm by 1 m by 1 m.
struct Touch {
    static HapticPlan plan() {
        HapticPlan plan;
        plan.expects_lesson = false;
        plan.expects_world = true;
        plan.solids = only_solid(touchable(make_box(kSize_m)));
        return plan;
    }
    // One round with the hand and the plate there; the last force, of the coupling and at the device.
    void step(const Vector3& hand_W, const Vector3& plate_W) {
        now_s += kTick_s;
        device.pose_D.position = hand_W;
        frame.stamp_s = now_s;
        frame.solid_poses_W[0] = Pose::at(plate_W);
        channels->world.publish(frame);
        loop.step(now_s);
    }

    static inline const Vector3 kSize_m{1.0, kThickness_m, 1.0};
    ScriptedDevice device;
    std::unique_ptr<HapticChannels> channels = std::make_unique<HapticChannels>();
    WorldFrame frame;
    double now_s = 0.0;
    HapticLoop loop{plan(), device, *channels};
};

// Hand (or plate) goes to and fro across the other; worst is the largest part of a force that pulls into the side touched.
Finding cross(bool plate_moves) {
    Touch touch;
    const Vector3 side_W(0.03, 1.0, -0.02);
    const Vector3 begin_W(0.0, 0.1, 0.0);
    const auto step_to = [&](double way_m) {
        const Vector3 hand_W = begin_W - way_m * side_W;
        plate_moves ? touch.step(begin_W, way_m * side_W) : touch.step(hand_W, Vector3::Zero());
        return Vector3(plate_moves ? begin_W - way_m * side_W : hand_W);
    };
    for (int i = 0; i < 3000; ++i) {
        step_to(0.0);
    }
    double worst_N = 0.0;
    double largest_N = 0.0;
    int n_touching = 0;
    for (int crossing = 0; crossing < kCrossings; ++crossing) {
        BoxPlace place(Touch::kSize_m, begin_W);
        for (int i = 1; i <= 2 * kTicks + kTicksBetween; ++i) {
            const int there = std::max(0, std::min(i, 2 * kTicks - i));
            // A little slower each time, so that it meets the plate elsewhere between two ticks.
            const double speed = kSpeed_m_per_s * (1.0 - 0.013 * crossing);
            place.step(step_to(speed * kTick_s * there));
            for (const Wrench& wrench :
                 {touch.loop.state().commanded_W, touch.loop.state().applied_W}) {
                worst_N =
                    worse(worst_N, place.is_touching() ? -wrench.force.dot(place.normal_B()) : 0.0);
                largest_N = std::max(largest_N, wrench.force.norm());
            }
            n_touching += place.is_touching() ? 1 : 0;
        }
    }
    const bool meant = n_touching > kCrossings * kTicks / 2 && largest_N > 1.0;
    return {meant ? worst_N : HUGE_VAL, 0.0, "touched at " + std::to_string(n_touching) + " ticks"};
}

constexpr const char* kMeasured = "force that pulls further in";

const HardCase kHand{{"the loop at a plate of 1 mm at 5 m/s",
                      "the hand shoots through and comes back, 20 times", kMeasured, "N",
                      [] { return cross(false); }}};
const HardCase kPlate{{"the loop when a plate of 1 mm flies at 5 m/s",
                       "the plate flies through a still hand and back, 20 times", kMeasured, "N",
                       [] { return cross(true); }}};

}  // namespace
}  // namespace fulcrum::stability
