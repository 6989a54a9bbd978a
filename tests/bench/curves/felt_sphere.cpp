// What is sent to a hand that strokes a ball, behind the last gate: how far it is from the true normal, how much it jumps, what it gives.
//
// The plan is what a lesson with that ball of metal gets, without friction: damper, passivity and gate as they ship.
#include "tests/bench/curves/felt_sphere.h"

#include "haptics/geometry/shape.h"
#include "haptics/surface/materials.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/sent_force.h"
#include "tests/support/touchable.h"

namespace fulcrum::bench {
namespace {

constexpr double kDt_s = 0.001;
constexpr double kAway_m = 0.002;  // where the hand comes from

// A tilted circle, so that no mesh's symmetry helps.
Vector3 direction_at(double angle) {
    static const Vector3 kAlong = Vector3(0.8, 0.1, -0.59).normalized();
    static const Vector3 kAcross = kAlong.cross(Vector3(0.2, 1.0, 0.4)).normalized();
    return std::cos(angle) * kAlong + std::sin(angle) * kAcross;
}

Material make_smooth_metal(double damping_share) {
    Material metal = *find_material("metal");
    metal.friction = {};
    metal.coupling.damping_Ns_per_m *= damping_share;
    return metal;
}

// With the shipped plan and `damping_share` of the shipped damper; its cost where it is asked for.
SentStroke stroke_ours(const MeshShape& mesh, bool rounded, double damping_share,
                       Cost* cost = nullptr) {
    const Material metal = make_smooth_metal(damping_share);
    test::SentForce loop(test::make_touch_lesson(metal, rounded), mesh);
    loop.open_gate((kStrokedBall_m + kAway_m) * direction_at(0.0));
    const double depth_m = kStrokePush_N / metal.coupling.stiffness_N_per_m;
    const auto send = [&](const Vector3& hand_W) { return loop.step(hand_W); };
    const SentStroke sent = stroke_ball(send, depth_m);
    if (cost != nullptr) {
        *cost = measure_stroke(send, depth_m);
    }
    return sent;
}

}  // namespace

std::vector<int> stroked_balls(bool quick) {
    return quick ? std::vector<int>{4, 22} : std::vector<int>{4, 7, 12, 22, 40, 71, 126, 224};
}

SentStroke stroke_ball(const Send& send, double depth_m) {
    const double radius_m = kStrokedBall_m - depth_m;
    const double step_rad = kDt_s * kStrokeSpeed_m_per_s / radius_m;
    const int n = static_cast<int>(std::ceil(2.0 * std::numbers::pi / step_rad));
    // In from outside, at 1 cm/s.
    const Vector3 start = direction_at(0.0);
    for (double r_m = kStrokedBall_m + kAway_m; r_m > radius_m; r_m -= 1.0e-5) {
        (void)send(r_m * start);
    }
    std::vector<double> jumps_N;
    double sideways = 0.0;
    double angle = 0.0;
    double push_N = 0.0;
    double energy_J = 0.0;
    Vector3 before_N = Vector3::Zero();
    Vector3 hand_before_W = radius_m * start;
    for (int i = 0; i < 2 * n; ++i) {
        const Vector3 normal = direction_at(step_rad * i);
        const Vector3 hand_W = radius_m * normal;
        const Vector3 force_N = send(hand_W);
        if (i >= n) {
            const double along_N = force_N.dot(normal);
            const double side_N = (force_N - along_N * normal).norm();
            sideways += side_N * side_N;
            angle += std::pow(std::atan2(side_N, along_N), 2);
            push_N += along_N;
            energy_J += before_N.dot(hand_W - hand_before_W);
            jumps_N.push_back((force_N - before_N).norm());
        }
        before_N = force_N;
        hand_before_W = hand_W;
    }
    std::ranges::sort(jumps_N);
    const double count = n;
    return {std::sqrt(sideways / count), std::sqrt(angle / count) * 180.0 / std::numbers::pi,
            jumps_N[static_cast<std::size_t>(0.99 * count)], 1000.0 * energy_J, push_N / count};
}

Cost measure_stroke(const Send& send, double depth_m) {
    const double radius_m = kStrokedBall_m - depth_m;
    double angle = 0.0;
    return measure_cost([&] {
        angle += kDt_s * kStrokeSpeed_m_per_s / radius_m;
        keep(send(radius_m * direction_at(angle)));
    });
}

CostPoint to_point(const std::string& series, double n_triangles, const SentStroke& sent,
                   const Cost& cost) {
    return {series,
            n_triangles,
            sent.sideways_N,
            cost,
            {sent.angle_deg, sent.jump_N, sent.energy_mJ, sent.mean_N}};
}

namespace {

Report run_felt_sphere(Run& run) {
    CostCurve curve;
    curve.name = "felt-sphere";
    curve.title = "What a stroke over a ball sends to the hand";
    curve.work =
        "A hand strokes a ball of 10 cm at 0.2 m/s, pressed with 2 N, along a circle: metal "
        "without "
        "friction, with the plan and the gate of a lesson; the second time round.";
    curve.reference = "analytic: the true ball's normal";
    curve.advice =
        "Round what is meant to be round: some thousand triangles are then as even as a million.";
    curve.knob = {"triangles", "", true};
    curve.error = {"force along the surface", "N", true};
    curve.extras = {{"angle to the true normal", "degrees", true},
                    {"change in a millisecond at 99 %", "N", true},
                    {"energy given in a circle", "mJ", false},
                    {"force along the normal", "N", false}};
    curve.default_series = "rounded";
    for (const int frequency : stroked_balls(run.quick())) {
        const auto mesh = touchable(must(make_sphere(kStrokedBall_m, frequency)));
        const double n_triangles = 20.0 * frequency * frequency;
        const auto add = [&](const std::string& series, bool rounded, double damping_share) {
            Cost cost;
            const SentStroke sent = stroke_ours(mesh, rounded, damping_share, &cost);
            curve.points.push_back(to_point(series, n_triangles, sent, cost));
        };
        add("facets", false, 1.0);
        add("facets without damper", false, 0.0);
        add("rounded", true, 1.0);
        add("rounded without damper", true, 0.0);
        if (frequency == 22) {
            curve.default_knob = n_triangles;
        }
    }
    return {curve};
}

Report run_contact_damping(Run& run) {
    LineChart chart;
    chart.name = "contact-damping";
    chart.title = "What a contact's damper does to a stroke";
    chart.work =
        "The stroke of felt-sphere over the ball of 9680 triangles, with more and less than "
        "metal's damper.";
    chart.reference = "the true ball's normal";
    chart.advice =
        "The damper acts along the normals alone, so that it costs nothing along the surface; on "
        "facets it makes "
        "their edges felt more, where they are rounded it does not.";
    chart.x = {"share of metal's damper", "", false};
    chart.y = {"force", "N", true};
    const auto mesh = touchable(must(make_sphere(kStrokedBall_m, 22)));
    for (const bool rounded : {false, true}) {
        const std::string of = rounded ? "rounded: " : "facets: ";
        Line sideways{of + "along the surface"};
        Line jump{of + "change in a millisecond at 99 %"};
        for (const double share :
             run.pick<std::vector<double>>({0.0, 0.25, 0.5, 1.0, 1.5, 2.0}, {0.0, 1.0})) {
            const SentStroke sent = stroke_ours(mesh, rounded, share);
            sideways.add(share, sent.sideways_N);
            jump.add(share, sent.jump_N);
        }
        chart.lines.push_back(sideways);
        chart.lines.push_back(jump);
    }
    return {chart};
}

const Registration kFeltSphere{{"felt-sphere",
                                "what is sent to a hand that strokes a ball, over mesh resolution",
                                run_felt_sphere}};
const Registration kContactDamping{
    {"contact-damping", "what a contact's damper does to a stroke", run_contact_damping}};

}  // namespace
}  // namespace fulcrum::bench
