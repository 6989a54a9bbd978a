// How true what is sent to a hand is that strokes a ball with a cursor of its own shape: ball, box, capsule, hull. Plan and gate are those of a
// lesson, without friction, texture, tap and damper.
//
// Truth: with the cursor at x the ball's centre is d(x) from the cursor's surface, in closed form; pressed in, F = K (R - d) grad d.
#include "haptics/geometry/shape.h"
#include "haptics/surface/materials.h"
#include "tests/bench/curves/felt_sphere.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/sent_force.h"
#include "tests/support/touchable.h"

namespace fulcrum::bench {
namespace {

constexpr double kBall_m = 0.05;
constexpr double kDepth_m = 0.002;
constexpr double kStroke_m_per_s = 0.05;
constexpr double kStiffness_N_per_m = 500.0;
constexpr double kCursor_m = 0.008;  // radius of the round ones
constexpr double kHalfLength_m = 0.012;

// Where a point is nearest to the cursor, both about its middle.
using Nearest = std::function<Vector3(const Vector3&)>;

struct Cursor {
    const char* name;
    CursorShape shape;
    double rounding_m;  // of the core that `nearest` is about
    Nearest nearest;
};

std::vector<Cursor> list_cursors() {
    const Vector3 half(0.012, 0.006, 0.008);
    const auto on_box = [half](const Vector3& p) {
        return Vector3(p.cwiseMax(-half).cwiseMin(half));
    };
    const auto on_axis = [](const Vector3& p) {
        return Vector3(0.0, std::clamp(p.y(), -kHalfLength_m, kHalfLength_m), 0.0);
    };
    std::vector<Vector3> corners;
    for (int i = 0; i < 8; ++i) {
        corners.emplace_back((i & 1) != 0 ? half.x() : -half.x(),
                             (i & 2) != 0 ? half.y() : -half.y(),
                             (i & 4) != 0 ? half.z() : -half.z());
    }
    return {{"ball", SphereShape{kCursor_m}, kCursor_m,
             [](const Vector3&) { return Vector3(Vector3::Zero()); }},
            {"box", BoxShape{half}, 0.0, on_box},
            {"capsule", CapsuleShape{kCursor_m, kHalfLength_m}, kCursor_m, on_axis},
            {"hull of a box's corners", must(make_hull_shape(corners)), 0.0, on_box}};
}

// The way from the ball's middle to the cursor's nearest core: it points as the ball pushes.
Vector3 find_away(const Cursor& cursor, const Vector3& hand_W) {
    return hand_W + cursor.nearest(-hand_W);
}

double find_depth_m(const Cursor& cursor, const Vector3& hand_W) {
    return kBall_m + cursor.rounding_m - find_away(cursor, hand_W).norm();
}

// Along a direction, where the cursor is so deep.
Vector3 find_place(const Cursor& cursor, const Vector3& direction, double depth_m) {
    double low = 0.5 * kBall_m;
    double high = 3.0 * kBall_m;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (find_depth_m(cursor, middle * direction) > depth_m ? low : high) = middle;
    }
    return low * direction;
}

// Root mean square of what is sent beside the truth, in a round about a tilted axis, the second of two. `mesh`: none for the formula.
double find_error_N(const Cursor& cursor, const MeshShape& mesh) {
    Material material = *find_material("metal");
    material.friction = {};
    material.texture = {};
    material.transient = {};
    material.coupling = {.stiffness_N_per_m = kStiffness_N_per_m, .damping_Ns_per_m = 0.0};
    runtime::LessonDescription lesson =
        test::make_touch_lesson(material, false, mesh ? "thing" : "sphere");
    lesson.bodies.front().radius_m = kBall_m;
    lesson.hand.cursor = cursor.shape;
    test::SentForce loop(lesson, mesh);
    const Vector3 along = Vector3(0.8, 0.1, -0.59).normalized();
    const Vector3 across = along.cross(Vector3(0.2, 1.0, 0.4)).normalized();
    const double stiffness_N_per_m = loop.plan().solids.front().coupling->stiffness_N_per_m;
    const auto direction = [&](double angle) {
        return Vector3(std::cos(angle) * along + std::sin(angle) * across);
    };
    loop.open_gate(find_place(cursor, direction(0.0), -0.01));
    for (double depth_m = -0.01; depth_m < kDepth_m; depth_m += 1.0e-5) {
        (void)loop.step(find_place(cursor, direction(0.0), depth_m));
    }
    const double step_rad = kStroke_m_per_s / (loop.plan().rate_hz * kBall_m);
    const int n = static_cast<int>(2.0 * std::numbers::pi / step_rad);
    RootMeanSquare error_N;
    for (int i = 0; i < 2 * n; ++i) {
        const Vector3 hand_W = find_place(cursor, direction(step_rad * i), kDepth_m);
        const Vector3 force_N = loop.step(hand_W);
        const Vector3 true_N = stiffness_N_per_m * find_depth_m(cursor, hand_W) *
                               find_away(cursor, hand_W).normalized();
        if (i >= n) {
            error_N.add((force_N - true_N).norm());
        }
    }
    return error_N.value();
}

Report run_cursor_shapes(Run& run) {
    LineChart chart;
    chart.name = "cursor-shapes";
    chart.title = "How true a ball is felt with cursors of their own shape";
    chart.work =
        "Cursors of 2 cm stroke a ball of 5 cm 2 mm deep at 0.05 m/s, without friction and damper: "
        "what is sent, rms of the second round.";
    chart.reference =
        "analytic: the cursor's distance from the ball's middle; dashed: the ball by its formula, "
        "as it ships";
    chart.advice =
        "As it ships a ball is its formula, and each cursor as true on it; a model's facets are "
        "felt by each of them, by one with corners no more than by a ball.";
    chart.x = {"triangles of the ball", "", true};
    chart.y = {"error of the force, rms", "N", true};
    const auto frequencies = run.pick<std::vector<double>>({2, 4, 7, 12, 22, 40}, {4, 12});
    double done = 0.0;
    for (const Cursor& cursor : list_cursors()) {
        run.progress(done, cursor.name);
        done += 0.25;
        Line facets{cursor.name};
        Line formula{cursor.name + std::string(" on the formula"), LineStyle::theory};
        const double formula_N = find_error_N(cursor, nullptr);
        for (const double frequency : frequencies) {
            const double n = 20.0 * frequency * frequency;
            facets.add(
                n, find_error_N(
                       cursor, touchable(must(make_sphere(kBall_m, static_cast<int>(frequency))))));
            formula.add(n, formula_N);
        }
        chart.lines.push_back(facets);
        chart.lines.push_back(formula);
    }
    return {chart};
}

const Registration kCursorShapes{{"cursor-shapes",
                                  "how true a ball is felt with a ball, a box, a capsule, a hull",
                                  run_cursor_shapes}};

}  // namespace
}  // namespace fulcrum::bench
