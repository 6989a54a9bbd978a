// An implicit penalty tool (implicit_penalty.h) in hands and scenes that are hard: a device that reports garbage, steps of any length, a hand that
// wanders, scenes of any size and 10 km away, plates that fly at it.
//
// A plate is met where it comes no faster than it is found, by `within_m` a round of contact, here 1 mm a millisecond. What is faster may be
// in the tool before it is known, and then pushes it out, as fast as planes rise, or passes through; the force keeps within its limits.
#include "tests/stability/cases/penalty_watch.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/wander.h"

#include <algorithm>

namespace fulcrum::stability {
namespace {

constexpr double kAlong_J = 2.0e-4;  // 50 g at 9 cm/s
const Vector3 kBlock_m(0.04, 0.02, 0.04);
const Vector3 kSlab_m(0.2, 0.04, 0.2);
constexpr double kOnSlab_m = 0.03;  // of the block's middle

PenaltyScene make_block_on_slab(double size = 1.0) {
    return {.tool = make_box(size * kBlock_m).value(),
            .inertia = make_box_inertia(0.02, size * kBlock_m),
            .voxel_m = 0.002 * size,
            .objects = {make_box(size * kSlab_m).value()},
            .most_N = kPenaltyMost_N * size,
            .turn_Nm_per_rad = 0.2 * size * size};
}

// Down on the slab by 6 mm within half a second, and to and fro along it.
MovingFrame rub_at(double t_s) {
    const double down = std::min(1.0, 2.0 * t_s);
    const double w = 5.0;
    MovingFrame hand{Pose::at({0.03 * std::sin(w * t_s), kOnSlab_m + 0.006 - 0.012 * down, 0.0}),
                     {}};
    hand.velocity_W.linear = {0.03 * w * std::cos(w * t_s), down < 1.0 ? -0.024 : 0.0, 0.0};
    return hand;
}

// What a device may report in place of a hand.
MovingFrame spoil(int kind, const MovingFrame& hand) {
    MovingFrame spoiled = hand;
    switch (kind) {
        case 0:
            spoiled.pose_W.position.x() = kNan;
            break;
        case 1:
            spoiled.velocity_W.angular.z() = kInfinity;
            break;
        case 2:
            spoiled.pose_W.orientation.coeffs().setConstant(kNan);
            break;
        case 3:
            spoiled.pose_W.position += Vector3(1.0, -2.0, 0.5);
            break;
        case 4:
            spoiled.pose_W.orientation = compute_exp(Vector3(0.0, 0.0, 3.0));
            break;
        default:
            spoiled.velocity_W.linear = {20.0, -20.0, 5.0};
            break;
    }
    return spoiled;
}

// A block is pressed and rubbed; each ninth report is garbage, each fourth is the one before. Then the hand is still, and all is as it
// would have been.
Finding hear_garbage() {
    PenaltyWatch watch(make_block_on_slab());
    watch.place(rub_at(0.0).pose_W);
    MovingFrame last = rub_at(0.0);
    ToolFelt felt;
    int n_refused = 0;
    constexpr int kSteps = 3000;
    for (int i = 1; i <= kSteps; ++i) {
        const MovingFrame hand = rub_at(1.0e-3 * std::min(i, 2000));
        const int kind = i / 9 % 6;
        if (i < 2000 && i % 9 == 0) {
            n_refused += watch.move(spoil(kind, hand)).moved ? 0 : 1;
            continue;
        }
        last = i < 2000 && i % 4 == 0 ? last : hand;
        last.velocity_W = i < 2000 ? last.velocity_W : Twist{};
        felt = watch.move(last);
        watch.demand(felt.moved);
    }
    // No number: three kinds of six.
    watch.demand(n_refused == 2000 / 9 / 2);
    watch.demand(watch.speed_m_per_s() / 1.0e-3);
    const double wanted_N =
        kPenaltyCoupling_N_per_m * (watch.tool().centre_W().y() - rub_at(2.0).pose_W.position.y());
    watch.demand(std::abs(felt.felt_W.force.y() - wanted_N) / 1.0e-3);
    watch.demand(std::abs(watch.tool().centre_W().y() - kOnSlab_m) / 5.0e-4);
    return watch.judge(kAlong_J);
}

// Steps of 0.1 to 10 ms, and none now and then.
Finding step_raggedly() {
    PenaltyWatch watch(make_block_on_slab());
    watch.place(rub_at(0.0).pose_W);
    Random random(11);
    double t_s = 0.0;
    double least_N = HUGE_VAL;
    double most_N = 0.0;
    for (int i = 0; i < 4000; ++i) {
        const double dt_s = i % 50 == 7 ? 0.0 : 1.0e-3 * std::pow(10.0, random.uniform());
        t_s += dt_s;
        MovingFrame hand = rub_at(std::min(t_s, 4.0));
        hand.velocity_W = t_s < 4.0 ? hand.velocity_W : Twist{};
        const ToolFelt felt = watch.step(hand, dt_s);
        if (i > 3500) {
            least_N = std::min(least_N, felt.felt_W.force.y());
            most_N = worse(most_N, felt.felt_W.force.y());
        }
    }
    watch.demand(watch.speed_m_per_s() / 1.0e-3);
    watch.demand((most_N - least_N) / 0.05);
    watch.demand(least_N > 2.0);
    return watch.judge(kAlong_J);
}

// Over a bumpy ball by chance, in and out.
Finding wander_over_ball() {
    const Vector3 size(0.02, 0.02, 0.02);
    PenaltyWatch watch({make_box(size).value(),
                        make_box_inertia(0.02, size),
                        0.002,
                        {make_bumpy_sphere(0.04, 8, 0.1, 60.0).value()}});
    Wanderer place(21);
    Wanderer axis(22);
    watch.place(Pose::at(0.08 * place.next()));
    int n_free = 0;
    for (int i = 1; i <= 8000; ++i) {
        const double radius_m = 0.062 + 0.018 * std::cos(0.003 * i);
        const ToolFelt felt =
            watch.step(Pose{radius_m * place.next(), compute_exp(0.001 * i * axis.next())});
        n_free += felt.felt_W.force == Vector3::Zero() ? 1 : 0;
        watch.demand(watch.tool().centre_W().norm() > 0.042);
    }
    watch.demand(n_free > 500 && watch.n_touching() > 3000);
    return watch.judge(kAlong_J);
}

// All lengths times `size`, the scene at `origin`: what is felt at rest, over the size.
struct Pressed {
    double felt = 0.0;
    double deep = 0.0;
    Finding finding;
};

Pressed press_scene(double size, const Vector3& origin) {
    PenaltyWatch watch(make_block_on_slab(size));
    watch.objects[0].pose_W = Pose::at(origin);
    const auto at = [&](int i) {
        const double down = std::clamp(i / 500.0, 0.0, 1.0) - std::clamp(i / 500.0 - 4.0, 0.0, 1.0);
        const double along = 0.02 * std::clamp(i / 500.0 - 1.0, 0.0, 1.0);
        return Pose::at(origin + size * Vector3(along, kOnSlab_m + 0.006 - 0.012 * down, 0.0));
    };
    watch.place(at(0));
    Pressed pressed;
    for (int i = 1; i <= 2500; ++i) {
        const ToolFelt felt = watch.step(at(i));
        if (i == 1990) {
            pressed.felt = felt.felt_W.force.y() / size;
            pressed.deep = kOnSlab_m - (watch.tool().centre_W() - origin).y() / size;
            watch.demand(watch.speed_m_per_s() / (1.0e-3 * size));
        }
        if (i == 2500) {
            watch.demand(felt.felt_W.force == Vector3::Zero());
        }
    }
    pressed.finding = watch.judge(kAlong_J * size * size);
    return pressed;
}

// As deep and as hard as the same at the origin, of size 1.
Finding compare_scenes(const std::vector<std::pair<double, Vector3>>& scenes, double most_off) {
    const Pressed here = press_scene(1.0, Vector3::Zero());
    // A coupling 6 mm long but for what lies deep.
    double worst =
        std::abs(here.felt / (kPenaltyCoupling_N_per_m * (0.006 - here.deep)) - 1.0) / 1.0e-6;
    worst = worse(worst, here.finding.worst);
    double off = 0.0;
    for (const auto& [size, origin] : scenes) {
        const Pressed there = press_scene(size, origin);
        off = worse(off, std::abs(there.felt / here.felt - 1.0));
        worst = worse(worst, there.finding.worst);
    }
    return {worse(worst, off / most_off), 1.0,
            describe("%.4g N; there off by %.2g of it", here.felt, off)};
}

// A plate of 10 mm comes down on a tool that is held still, at `speed`, pushes it 10 mm before it and goes back.
Finding meet_plate(double speed_m_per_s, bool must_hold) {
    const Vector3 size(0.02, 0.02, 0.02);
    PenaltyWatch watch({make_box(size).value(),
                        make_box_inertia(0.02, size),
                        0.002,
                        {make_box({0.1, 0.01, 0.1}).value()}});
    watch.place(Pose{});
    constexpr double kFrom_m = 0.04;
    constexpr double kTo_m =
        0.005;  // of the plate's middle: its face lies 10 mm below where the tool's was
    MovingFrame& plate = watch.objects[0];
    double y_m = kFrom_m;
    ToolFelt felt;
    for (int i = 0; i < 400; ++i) {
        const double next_m = i < 200 ? std::max(kTo_m, y_m - speed_m_per_s * kPenaltyDt_s)
                                      : std::min(kFrom_m, y_m + speed_m_per_s * kPenaltyDt_s);
        plate = {Pose::at({0.0, next_m, 0.0}), {}};
        plate.velocity_W.linear.y() = (next_m - y_m) / kPenaltyDt_s;
        y_m = next_m;
        felt = watch.step(Pose{});
        if (must_hold) {
            watch.demand(watch.tool().centre_W().y() + 0.01 < y_m - 0.005 + 5.0e-4);
        }
    }
    watch.demand(felt.felt_W.force == Vector3::Zero());
    watch.demand(watch.tool().centre_W().norm() / 1.0e-4);
    watch.demand(watch.n_touching() > 0);
    return watch.judge(kAlong_J);
}

Finding meet_plates() {
    Finding all{0.0, 1.0, {}};
    for (const double speed : {0.2, 0.5, 0.8, 2.0, 5.0}) {
        const Finding one = meet_plate(speed, speed < 1.0);
        all = {worse(all.worst, one.worst), 1.0,
               all.note + describe("%.1f m/s: worst %.2g; ", speed, one.worst)};
    }
    return all;
}

const HardCase kGarbage{{"penalty tool and garbage from the device",
                         "no numbers, jumps of 2 m and 3 rad, 28 m/s from nowhere, doubled reports",
                         kPenaltyMeasured, "", hear_garbage}};
const HardCase kRagged{{"penalty tool in ragged time", "steps of 0.1 to 10 ms, and none",
                        kPenaltyMeasured, "", step_raggedly}};
const HardCase kWanders{{"penalty tool in a hand that wanders", "over a bumpy ball, in and out",
                         kPenaltyMeasured, "", wander_over_ball}};
const HardCase kAllSizes{
    {"penalty tool in scenes scaled by 1e-2 to 1e1", "as hard as at size 1, to a hundredth",
     kPenaltyMeasured, "", [] {
         const Vector3 here = Vector3::Zero();
         return compare_scenes({{1.0e-2, here}, {1.0e-1, here}, {1.0e1, here}}, 0.01);
     }}};
const HardCase kFarAway{{"penalty tool 10 km from the origin", "as hard as at the origin, to 1e-6",
                         kPenaltyMeasured, "", [] {
                             return compare_scenes({{1.0, {1.0e4, -3.0e3, 2.0e3}}}, 1.0e-6);
                         }}};
const HardCase kPlates{{"penalty tool met by fast plates",
                        "0.2 to 0.8 m/s: pushed before them; 2 and 5 m/s: within limits, and free "
                        "again",
                        kPenaltyMeasured, "", meet_plates}};

}  // namespace
}  // namespace fulcrum::stability
