#include "haptics/geometry/shape.h"
#include "haptics/point/god_object.h"
#include "tests/stability/cases/stability_case.h"
#include "tests/support/box_place.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace fulcrum::stability {
namespace {

constexpr const char* kMeasured = "distance from the exact place";

// Where a proxy stands is the geometry's place, held 1e-10 of the solid's radius above each touched face; ten times that
// leaves room for three faces and for rounding.
constexpr double kLimit = 1.0e-9;
constexpr int kSteps = 20000;
constexpr double kHalf_m = 0.5;
constexpr int kStepsInside = 4000;

// A hand that wanders by `step_m` within 0.2 m of a place at the surface of a cube of one metre, in and out of it.
Finding wander_about(const Vector3& centre_W, double step_m) {
    const Vector3 size_m = Vector3::Ones();
    GodObject proxy(only_solid(touchable(make_box(size_m))));
    Random random(31);
    Vector3 hand_W = 1.5 * centre_W;
    proxy.reset(hand_W);
    BoxPlace place(size_m, hand_W);
    double worst_m = 0.0;
    int n_touching = 0;
    int n_touches = 0;
    for (int i = 0; i < kSteps; ++i) {
        const bool touched = place.is_touching();
        hand_W += step_m * random.vector();
        const double away_m = (hand_W - centre_W).norm();
        hand_W = away_m > 0.2 ? Vector3(centre_W + (hand_W - centre_W) * (0.2 / away_m)) : hand_W;
        const Vector3 place_W = place.step(hand_W);
        worst_m = worse(worst_m, (proxy.step(hand_W, {}).position_W - place_W).norm());
        n_touching += place.is_touching() ? 1 : 0;
        n_touches += place.is_touching() && !touched ? 1 : 0;
    }
    return {worst_m, kLimit,
            std::to_string(n_touches) + " touches, " + std::to_string(100 * n_touching / kSteps) +
                " % of the time"};
}

// A hand that starts in the middle of a box of one metre and circles with its centre at `pressed_W`: the proxy belongs
// where the hand's coordinates are cut off at the walls.
Finding press_from_inside(const Vector3& pressed_W, double circle_m) {
    GodObject proxy(only_solid(touchable(make_box(Vector3::Constant(2.0 * kHalf_m)))));
    proxy.reset(Vector3::Zero());
    double worst_m = 0.0;
    for (int i = 0; i < kStepsInside; ++i) {
        const double turn = 0.01 * i;
        const double way_there = std::min(1.0, i / 200.0);
        const Vector3 hand_W =
            way_there * (pressed_W + circle_m * Vector3(std::sin(turn), std::sin(1.3 * turn),
                                                        std::cos(0.7 * turn)));
        const Vector3 place_W = hand_W.cwiseMax(-kHalf_m).cwiseMin(kHalf_m);
        const Vector3 proxy_W = proxy.step(hand_W, {}).position_W;
        worst_m = worse(worst_m, (proxy_W - place_W).norm());
    }
    return {worst_m, kLimit, "at any of 4000 steps"};
}

const HardCase kEdge{
    {"a convex edge", "the hand goes in and out across the edge of a cube", kMeasured, "m", [] {
         return wander_about({0.5, 0.5, 0.1}, 0.02);
     }}};
const HardCase kCorner{
    {"a convex corner", "the hand goes in and out about the corner of a cube", kMeasured, "m", [] {
         return wander_about({0.5, 0.5, 0.5}, 0.02);
     }}};
const HardCase kJumps{{"a convex corner with a hand that jumps",
                       "the hand jumps by some 0.2 m a tick about the corner of a cube", kMeasured,
                       "m", [] {
                           return wander_about({0.5, 0.5, 0.5}, 0.3);
                       }}};
const HardCase kWall{
    {"a wall from inside a box", "the hand circles behind one wall", kMeasured, "m", [] {
         return press_from_inside({0.7, 0.0, 0.0}, 0.15);
     }}};
const HardCase kConcave{{"a concave edge", "the hand circles behind two walls", kMeasured, "m", [] {
                             return press_from_inside({0.7, 0.65, 0.0}, 0.1);
                         }}};
const HardCase kThree{
    {"a corner of three planes", "the hand circles behind three walls", kMeasured, "m", [] {
         return press_from_inside({0.7, 0.65, 0.72}, 0.1);
     }}};
const HardCase kInAndOut{{"in and out of a corner",
                          "the hand goes behind one, two, three walls and back", kMeasured, "m",
                          [] {
                              return press_from_inside({0.5, 0.5, 0.5}, 0.2);
                          }}};

constexpr double kFastest_m_per_s = 5.0;
constexpr double kTick_s = 1.0e-3;
constexpr double kSide_m = 0.2;
constexpr int kPasses = 400;
constexpr int kTicks = 200;  // there and back

Vector3 size_of_plate(double thickness_m) {
    return {kSide_m, thickness_m, kSide_m};
}

Vector3 somewhere_in(const Vector3& size_m, Random& random) {
    return 0.5 * size_m.cwiseProduct(random.in_cube());
}

struct Passes {
    double worst_m = 0.0;
    int n_met = 0;
    [[nodiscard]] Finding finding() const {
        return {worst_m, kLimit,
                std::to_string(n_met) + " of " + std::to_string(kPasses) + " passes met the plate"};
    }
};

// From anywhere around, straight at a place in the plate, on beyond it, then back.
Finding shoot_through(double thickness_m) {
    const Vector3 size_m = size_of_plate(thickness_m);
    const auto mesh = touchable(make_box(size_m));
    Random random(51);
    Passes passes;
    for (int pass = 0; pass < kPasses; ++pass) {
        const Vector3 from_W = 0.25 * random.direction();
        const Vector3 way = (somewhere_in(size_m, random) - from_W).normalized();
        GodObject proxy(only_solid(mesh));
        proxy.reset(from_W);
        BoxPlace place(size_m, from_W);
        bool met = false;
        for (int i = 1; i <= kTicks; ++i) {
            const double way_m = kFastest_m_per_s * kTick_s * std::min(i, kTicks - i);
            const Vector3 hand_W = from_W + way_m * way;
            const Vector3 place_W = place.step(hand_W);
            passes.worst_m =
                worse(passes.worst_m, (proxy.step(hand_W, {}).position_W - place_W).norm());
            met = met || place.is_touching();
        }
        passes.n_met += met ? 1 : 0;
    }
    return passes.finding();
}

// A plate that flies and turns so that a place in it meets the still hand half way.
class Flight {
  public:
    Flight(const Vector3& size_m, double speed_m_per_s, double turn_rad_per_s, Random& random)
        : hand_W_(random.in_cube()),
          velocity_W_(speed_m_per_s * random.direction()),
          axis_(random.direction()),
          turn_rad_per_s_(turn_rad_per_s),
          meeting_turn_(random.turn(3.0)),
          met_W_(meeting_turn_ * somewhere_in(size_m, random)) {}

    [[nodiscard]] const Vector3& hand_W() const { return hand_W_; }
    [[nodiscard]] Pose pose_at(int tick) const {
        const double t_s = kTick_s * (tick - 0.5 * kTicks);
        const Quaternion turn(AngleAxis(turn_rad_per_s_ * t_s, axis_));
        return {hand_W_ - met_W_ + velocity_W_ * t_s, turn * meeting_turn_};
    }
    [[nodiscard]] bool begins_outside(const Vector3& size_m) const {
        const Vector3 hand_B = pose_at(0).inverse() * hand_W_;
        return !all_at_most(hand_B.cwiseAbs(), 0.5 * size_m);
    }

  private:
    Vector3 hand_W_;
    Vector3 velocity_W_;
    Vector3 axis_;
    double turn_rad_per_s_;
    Quaternion meeting_turn_;
    Vector3 met_W_;
};

// A new pose comes every `ticks_a_pose`.
Finding fly_through(double thickness_m, double speed_m_per_s, double turn_rad_per_s,
                    int ticks_a_pose) {
    const Vector3 size_m = size_of_plate(thickness_m);
    const auto mesh = touchable(make_box(size_m));
    Random random(52);
    Passes passes;
    for (int pass = 0; pass < kPasses;) {
        const Flight flight(size_m, speed_m_per_s, turn_rad_per_s, random);
        if (!flight.begins_outside(size_m)) {
            continue;
        }
        ++pass;
        Pose pose_W = flight.pose_at(0);
        GodObject proxy(only_solid(mesh, pose_W));
        proxy.reset(flight.hand_W());
        BoxPlace place(size_m, pose_W.inverse() * flight.hand_W());
        bool met = false;
        for (int i = 1; i <= kTicks; ++i) {
            pose_W = i % ticks_a_pose == 0 ? flight.pose_at(i) : pose_W;
            const Vector3 place_W = pose_W * place.step(pose_W.inverse() * flight.hand_W());
            const ProxyContact& contact = proxy.step(flight.hand_W(), std::span(&pose_W, 1));
            passes.worst_m = worse(passes.worst_m, (contact.position_W - place_W).norm());
            met = met || place.is_touching();
        }
        passes.n_met += met ? 1 : 0;
    }
    return passes.finding();
}

const HardCase kThin{{"a plate of 1 mm at 5 m/s", "the hand shoots through it from any side",
                      kMeasured, "m", [] { return shoot_through(1.0e-3); }}};
const HardCase kThinner{{"a plate of 0.1 mm at 5 m/s", "the hand shoots through it from any side",
                         kMeasured, "m", [] { return shoot_through(1.0e-4); }}};
const HardCase kFlying{{"a plate of 1 mm flies through a still hand",
                        "at 5 m/s from any side, turned in any way", kMeasured, "m",
                        [] { return fly_through(1.0e-3, kFastest_m_per_s, 0.0, 1); }}};
const HardCase kFlyingThin{{"a plate of 0.1 mm flies through a still hand",
                            "at 5 m/s from any side, turned in any way", kMeasured, "m",
                            [] { return fly_through(1.0e-4, kFastest_m_per_s, 0.0, 1); }}};
const HardCase kFlyingSlowly{{"a plate of 0.1 mm drifts through a still hand",
                              "at 0.5 m/s from any side, turned in any way", kMeasured, "m",
                              [] { return fly_through(1.0e-4, 0.5, 0.0, 1); }}};
const HardCase kFlyingInLeaps{{"a plate of 1 mm at 5 m/s in leaps of 50 mm",
                               "through a still hand, its poses told 100 times a second", kMeasured,
                               "m", [] { return fly_through(1.0e-3, kFastest_m_per_s, 0.0, 10); }}};
const HardCase kTumbling{{"a plate of 1 mm tumbles through a still hand",
                          "at 5 m/s, eight turns a second about any axis", kMeasured, "m",
                          [] { return fly_through(1.0e-3, kFastest_m_per_s, 50.0, 1); }}};
const HardCase kTumblingThin{{"a plate of 0.1 mm tumbles through a still hand",
                              "at 5 m/s, eight turns a second about any axis", kMeasured, "m",
                              [] { return fly_through(1.0e-4, kFastest_m_per_s, 50.0, 1); }}};
const HardCase kTurning{{"a body turns over a still hand",
                         "a block of 0.2 m, eight turns a second about any axis", kMeasured, "m",
                         [] { return fly_through(0.2, 0.0, 50.0, 1); }}};

}  // namespace

}  // namespace fulcrum::stability
