// How the stiffnesses of two materials are mixed where a hand presses both at once, in the corner of a floor and a wall: force, what is
// stable, and whether the force leaps where one of them is left.
//
//   truth      each surface a spring of its own:  F = K_1 d_1 n_1 + K_2 d_2 n_2
//   mixed      F = K s n along the stretch s of the coupling, s = |(d_1, d_2)|; K by
//     share    (d_1 K_1 + d_2 K_2) / (d_1 + d_2)      as it ships (haptics/loop/contact_stage.h)
//     mean     (K_1 + K_2) / 2
//     least    min(K_1, K_2)
//     series   K_1 K_2 / (K_1 + K_2)                  one behind the other
#include "haptics/geometry/shape.h"
#include "haptics/surface/materials.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/sent_force.h"
#include "tests/support/touchable.h"
#include "tests/support/wall_trial.h"

namespace fulcrum::bench {
namespace {

constexpr double kFloor_N_per_m = 300.0;
constexpr double kStretch_m = 0.002;

// In the corner: (into the floor, into the wall), metres and newtons.
struct Pair {
    double floor = 0.0;
    double wall = 0.0;
};

struct Law {
    const char* name;
    double (*mix)(double floor_N_per_m, double wall_N_per_m, double floor_share);
};
constexpr Law kLaws[] = {
    {"by share of the push",
     [](double f, double w, double share) { return share * f + (1.0 - share) * w; }},
    {"mean", [](double f, double w, double) { return 0.5 * (f + w); }},
    {"least", [](double f, double w, double) { return std::min(f, w); }},
    {"series", [](double f, double w, double) { return f * w / (f + w); }}};

// Of one surface alone each law has its own stiffness.
Pair press(const Law& law, double wall_N_per_m, const Pair& depth) {
    const double K = depth.wall <= 0.0    ? kFloor_N_per_m
                     : depth.floor <= 0.0 ? wall_N_per_m
                                          : law.mix(kFloor_N_per_m, wall_N_per_m,
                                                    depth.floor / (depth.floor + depth.wall));
    return {K * std::max(depth.floor, 0.0), K * std::max(depth.wall, 0.0)};
}

// What the program sends there: a floor below, a wall to the left, in a lesson; undamped.
class Corner {
  public:
    explicit Corner(double wall_N_per_m)
        : loop_(make_lesson(), touchable(must(make_box(Vector3::Constant(0.2)))),
                [&](HapticPlan& plan) {
                    plan.solids[0].coupling->stiffness_N_per_m = kFloor_N_per_m;
                    plan.solids[1].coupling->stiffness_N_per_m = wall_N_per_m;
                }) {
        loop_.open_gate({kAway_m, kAway_m, 0.0});
    }
    Pair press(const Pair& depth) {
        Vector3 force_N;
        for (double way = 0.0; way < 1.0; way += 0.005) {
            force_N = loop_.step(
                {std::lerp(kAway_m, -depth.wall, way), std::lerp(kAway_m, -depth.floor, way), 0.0});
        }
        for (int i = 0; i < 100; ++i) {
            force_N = loop_.step({-depth.wall, -depth.floor, 0.0});
        }
        loop_.open_gate({kAway_m, kAway_m, 0.0});
        return {force_N.y(), force_N.x()};
    }

  private:
    static constexpr double kAway_m = 0.002;
    static runtime::LessonDescription make_lesson() {
        Material material = *find_material("metal");
        material.friction = {};
        material.texture = {};
        material.transient = {};
        material.coupling = {.stiffness_N_per_m = kFloor_N_per_m, .damping_Ns_per_m = 0.0};
        runtime::LessonDescription lesson = test::make_touch_lesson(material, false, "box");
        lesson.bodies.push_back(lesson.bodies.front());
        lesson.bodies[0].position_W = {0.0, -0.1, 0.0};
        lesson.bodies[1].position_W = {-0.1, 0.0, 0.0};
        lesson.bodies[1].name = lesson.bodies[1].noun = "wall";
        return lesson;
    }
    test::SentForce loop_;
};

// The steepest that the force changes with the way, N/m, over all directions of the press; across what leaps it is no slope.
template <class Press>
double find_steepest_N_per_m(const Press& at) {
    constexpr double kStep_m = 1.0e-5;
    double steepest = 0.0;
    for (double angle_deg = 5.0; angle_deg < 90.0; angle_deg += 10.0) {
        const double angle = angle_deg * std::numbers::pi / 180.0;
        const Pair depth{kStretch_m * std::cos(angle), kStretch_m * std::sin(angle)};
        const Pair here = at(depth);
        const Pair by_floor = at({depth.floor + kStep_m, depth.wall});
        const Pair by_wall = at({depth.floor, depth.wall + kStep_m});
        const double a = (by_floor.floor - here.floor) / kStep_m;
        const double b = (by_wall.floor - here.floor) / kStep_m;
        const double c = (by_floor.wall - here.wall) / kStep_m;
        const double d = (by_wall.wall - here.wall) / kStep_m;
        // The larger singular value.
        const double sum = a * a + b * b + c * c + d * d;
        const double det = a * d - b * c;
        steepest = std::max(
            steepest,
            std::sqrt(0.5 * (sum + std::sqrt(std::max(sum * sum - 4.0 * det * det, 0.0)))));
    }
    return steepest;
}

double between_N(const Pair& a, const Pair& b) {
    return std::hypot(a.floor - b.floor, a.wall - b.wall);
}

LineChart begin_chart(const std::string& name, const std::string& title) {
    LineChart chart;
    chart.name = name;
    chart.title = title;
    chart.work =
        "A hand presses the corner of a floor of 300 N/m and a stiffer wall, both undamped, so "
        "that the coupling is stretched by 2 mm.";
    return chart;
}

LineChart draw_force(const Run& run) {
    constexpr double kWall_N_per_m = 1200.0;
    LineChart chart = begin_chart("stiffness-mixing", "How far off a mixed stiffness is");
    chart.reference =
        "each surface a spring of its own, along its own normal; the wall has 1200 N/m";
    chart.advice =
        "As it ships, by share of the push: right where one is pressed alone and without a leap; "
        "half off where both are pressed alike. Who wants a corner of two materials true makes it "
        "one body.";
    chart.x = {"direction of the press, from floor to wall", "°", false};
    chart.y = {"error of the force", "N", false};
    const auto angles_deg = run.pick<std::vector<double>>(
        {0, 1, 5, 10, 20, 30, 45, 60, 70, 80, 85, 89, 90}, {0, 45, 90});
    const auto error_N = [&](double angle_deg, const std::function<Pair(const Pair&)>& at) {
        const double angle = angle_deg * std::numbers::pi / 180.0;
        // At the ends one surface alone, to the bit.
        const Pair depth{angle_deg < 90.0 ? kStretch_m * std::cos(angle) : 0.0,
                         kStretch_m * std::sin(angle)};
        return between_N(at(depth), {kFloor_N_per_m * depth.floor, kWall_N_per_m * depth.wall});
    };
    Corner corner(kWall_N_per_m);
    chart.trace("as it ships, sent", LineStyle::measured, angles_deg, [&](double angle_deg) {
        return error_N(angle_deg, [&](const Pair& depth) { return corner.press(depth); });
    });
    for (const Law& law : kLaws) {
        chart.trace(law.name, LineStyle::theory, angles_deg, [&](double angle_deg) {
            return error_N(angle_deg,
                           [&](const Pair& depth) { return press(law, kWall_N_per_m, depth); });
        });
    }
    return chart;
}

LineChart draw_margin(const Run& run) {
    LineChart chart = begin_chart("stiffness-mixing-margin",
                                  "How stable a corner of mixed stiffness is, over the wall's");
    z_width::WallTrial trial = z_width::make_tap(kFingertip);
    const double stable_N_per_m = z_width::find_largest_stiffness(trial).value_or(kNone);
    chart.reference = "the stiffest undamped wall that a fingertip holds, " +
                      to_text(std::round(stable_N_per_m)) +
                      " N/m, over the steepest slope of the force in the corner";
    chart.advice =
        "As it ships, by share of the push: beside a floor of 300 N/m a corner is steeper than its "
        "wall alone, by a third at 1200 N/m and more; what leaps is more stable in between, and "
        "shakes where it leaps.";
    chart.x = {"stiffness of the wall", "N/m", true};
    chart.y = {"stable over steepest", "", true};
    const auto walls_N_per_m =
        run.pick<std::vector<double>>({300, 450, 600, 900, 1200, 1800, 2400}, {600, 1200});
    const auto margin = [&](const auto& at) { return stable_N_per_m / find_steepest_N_per_m(at); };
    chart.trace("as it ships, sent", LineStyle::measured, walls_N_per_m, [&](double wall_N_per_m) {
        Corner corner(wall_N_per_m);
        return margin([&](const Pair& depth) { return corner.press(depth); });
    });
    for (const Law& law : kLaws) {
        chart.trace(law.name, LineStyle::theory, walls_N_per_m, [&](double wall_N_per_m) {
            return margin([&](const Pair& depth) { return press(law, wall_N_per_m, depth); });
        });
    }
    chart.trace("each a spring of its own", LineStyle::theory, walls_N_per_m,
                [&](double wall_N_per_m) {
                    return stable_N_per_m / std::max(kFloor_N_per_m, wall_N_per_m);
                });
    return chart;
}

LineChart draw_leap(const Run& run) {
    LineChart chart =
        begin_chart("stiffness-mixing-leap",
                    "How much the force leaps where the floor is left, over the wall's");
    chart.reference = "none: the force of the wall alone";
    chart.advice =
        "As it ships, by share of the push, the only one of them that never leaps: whose share is "
        "nothing counts for nothing.";
    chart.x = {"stiffness of the wall", "N/m", true};
    chart.y = {"leap of the force", "N", false};
    constexpr double kHardly_m = 1.0e-6;
    const auto walls_N_per_m =
        run.pick<std::vector<double>>({300, 450, 600, 900, 1200, 1800, 2400}, {600, 1200});
    const auto leap_N = [&](const auto& at) {
        return between_N(at(Pair{kHardly_m, kStretch_m}), at(Pair{-kHardly_m, kStretch_m}));
    };
    chart.trace("as it ships, sent", LineStyle::measured, walls_N_per_m, [&](double wall_N_per_m) {
        Corner corner(wall_N_per_m);
        return leap_N([&](const Pair& depth) { return corner.press(depth); });
    });
    for (const Law& law : kLaws) {
        chart.trace(law.name, LineStyle::theory, walls_N_per_m, [&](double wall_N_per_m) {
            return leap_N([&](const Pair& depth) { return press(law, wall_N_per_m, depth); });
        });
    }
    return chart;
}

Report run_stiffness_mixing(Run& run) {
    Report report;
    run.progress(0.0, "force");
    report.emplace_back(draw_force(run));
    run.progress(0.2, "margin");
    report.emplace_back(draw_margin(run));
    run.progress(0.8, "leap");
    report.emplace_back(draw_leap(run));
    return report;
}

const Registration kStiffnessMixing{{"stiffness-mixing",
                                     "how the stiffnesses of two materials are mixed in a corner",
                                     run_stiffness_mixing}};

}  // namespace
}  // namespace fulcrum::bench
