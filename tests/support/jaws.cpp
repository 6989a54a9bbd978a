#include "tests/support/jaws.h"

#include "haptics/base/clock.h"
#include "haptics/dynamics/mesh_inertia.h"
#include "haptics/math/rotation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace fulcrum::test {
namespace {

constexpr double kArch_m = 0.025;
constexpr double kThick_m = 0.008;
constexpr double kTooth_m = 0.0025;
constexpr int kTeeth = 12;
constexpr double kDt_s = 0.001;

// Where the skin is: `along` from 0 to 1 through the arch, `round` about it.
Vector3 find_corner(double along, double round) {
    const double angle = std::numbers::pi * along;
    const Vector3 middle(kArch_m * std::cos(angle), 0.0, kArch_m * std::sin(angle));
    const Vector3 outwards(std::cos(angle), 0.0, std::sin(angle));
    // Rounded ends; teeth where the skin looks up.
    const double end = std::min({1.0, along / 0.06, (1.0 - along) / 0.06});
    const double radius_m = kThick_m * std::sqrt(std::max(0.0, end * (2.0 - end)));
    const double up = std::max(0.0, std::sin(round));
    const double tooth = std::pow(std::sin(std::numbers::pi * kTeeth * along), 2.0);
    const double bump_m = end * kTooth_m * up * up * (tooth - 0.5);
    return middle +
           (radius_m + bump_m) * (std::cos(round) * outwards + std::sin(round) * Vector3::UnitY());
}

// Down to a bite, grinding, and up.
Pose find_hand_pose(double time_s) {
    const double down =
        std::clamp(time_s / 0.2, 0.0, 1.0) - std::clamp((time_s - 0.7) / 0.2, 0.0, 1.0);
    const double u = std::clamp(time_s - 0.2, 0.0, 0.5);
    Pose hand;
    hand.position = {0.004 * std::sin(25.0 * u), 0.026 - 0.014 * down, 0.003 * std::sin(18.0 * u)};
    // Upside down, so that teeth meet teeth.
    hand.orientation = compute_exp(Vector3(0.0, 0.15 * std::sin(12.0 * u), 0.0)) *
                       compute_exp(Vector3(0.05 * std::sin(20.0 * u), 0.0, std::numbers::pi));
    return hand;
}

MovingFrame find_hand(double time_s) {
    constexpr double kApart_s = 1.0e-5;
    const Pose before = find_hand_pose(time_s - kApart_s);
    const Pose after = find_hand_pose(time_s + kApart_s);
    return {find_hand_pose(time_s),
            {(after.position - before.position) / (2.0 * kApart_s),
             compute_log(after.orientation * before.orientation.conjugate()) / (2.0 * kApart_s)}};
}

std::shared_ptr<const DistanceField> make_field(const TriangleMesh& mesh) {
    return std::make_shared<const DistanceField>(
        DistanceField::build(mesh, make_field_frame(mesh, 96).value()).value());
}

double find_deepest_m(const DistanceField& field, const Pointshell& shell, const Pose& X_OT) {
    double deepest_m = 0.0;
    for (std::size_t i = 0; i < shell.size(); ++i) {
        deepest_m = std::max(deepest_m, field.sample_depth(X_OT * shell.position_T(i)).depth_m);
    }
    return deepest_m;
}

}  // namespace

Expected<TriangleMesh> make_jaw(int n_along, int n_round) {
    std::vector<Vector3> corners{find_corner(0.0, 0.0)};
    for (int i = 1; i < n_along; ++i) {
        for (int j = 0; j < n_round; ++j) {
            corners.push_back(find_corner(static_cast<double>(i) / n_along,
                                          2.0 * std::numbers::pi * j / n_round));
        }
    }
    corners.push_back(find_corner(1.0, 0.0));
    const auto at = [n_round](int i, int j) {
        return static_cast<std::int32_t>(1 + (i - 1) * n_round + j % n_round);
    };
    const auto last = static_cast<std::int32_t>(corners.size() - 1);
    std::vector<TriangleCorners> triangles;
    for (int j = 0; j < n_round; ++j) {
        triangles.push_back({0, at(1, j + 1), at(1, j)});
        triangles.push_back({last, at(n_along - 1, j), at(n_along - 1, j + 1)});
        for (int i = 1; i + 1 < n_along; ++i) {
            triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
            triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
        }
    }
    return TriangleMesh::build(std::move(corners), std::move(triangles));
}

std::vector<JawsSample> run_jaws(const JawsSettings& settings) {
    const TriangleMesh jaw = make_jaw(settings.n_along, settings.n_round).value();
    const MeshInertia inertia =
        measure_solid(jaw)
            .and_then([](const MeasuredSolid& solid) { return fill_with_mass(solid, 0.01); })
            .value();
    const Pointshell shell =
        make_moved(make_surface_pointshell(jaw, settings.n_points).value(), inertia.X_BP.inverse());
    const auto field = make_field(jaw);
    ImplicitPenaltyPlan plan;
    plan.objects.push_back(
        {field, std::make_shared<const ShellTree>(ShellTree::build(shell).value())});
    plan.settings.inertia = inertia.inertia;
    plan.settings.grip_T = inertia.X_BP.inverse() * Vector3(Vector3::Zero());
    plan.settings.handle_turn = inertia.X_BP.orientation;
    plan.settings.coupling.shift.stiffness_N_per_m = 500.0;
    plan.settings.coupling.turn.stiffness_Nm_per_rad = 0.5;
    plan.settings.contacts.model = settings.model;
    plan.settings.contacts.stiffness_N_per_m = 5000.0;
    plan.settings.contacts.within_m = 0.5e-3;
    plan.settings.clusters.within_m = 0.5e-3;
    plan.settings.clusters.radius_m = 0.006;
    plan.settings.own_rounds = false;
    plan.settings.silent_in_free_space = false;
    auto tool = ImplicitPenaltyTool::build(plan).value();
    // The lower jaw lies with its frame in the world's.
    const MovingFrame lower;
    tool.place(find_hand(0.0).pose_W);
    std::vector<JawsSample> samples;
    double due_s = 0.0;
    for (int i = 1; i * kDt_s <= kJawsCourse_s + 1.0e-9; ++i) {
        JawsSample sample;
        sample.time_s = i * kDt_s;
        const MovingFrame hand = find_hand(sample.time_s);
        const ToolFelt felt = tool.move(hand, {&lower, 1}, sample.time_s, kDt_s);
        // What is found now is known from the next step on; a throttled thread is late besides.
        if (sample.time_s >= due_s - 1.0e-9) {
            const double began_s = monotonic_now_s();
            tool.contact_loop().step(sample.time_s);
            sample.round_us = 1.0e6 * (monotonic_now_s() - began_s);
            due_s = sample.time_s + settings.round_s;
        } else {
            sample.round_us = samples.empty() ? 0.0 : samples.back().round_us;
        }
        sample.penetration_m = find_deepest_m(*field, shell, tool.state().pose_W);
        sample.deviation_m = (hand.pose_W.position - tool.grip_W().position).norm();
        sample.felt_N = felt.felt_W.force.norm();
        sample.n_clusters = static_cast<int>(tool.model().n);
        samples.push_back(sample);
    }
    return samples;
}

}  // namespace fulcrum::test
