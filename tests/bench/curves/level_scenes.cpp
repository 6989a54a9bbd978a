#include "tests/bench/curves/level_scenes.h"

#include "haptics/base/clock.h"
#include "haptics/geometry/shape.h"
#include "haptics/math/rotation.h"
#include "tests/bench/curves/mesh_file.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/jaws.h"

namespace fulcrum::bench {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

// Rings of corners between a first and a last point, fronts outwards where corners go round counter-clockwise as seen from the last point.
TriangleMesh make_tube(int n_along, int n_round,
                       const std::function<Vector3(double along, double round)>& find_corner) {
    std::vector<Vector3> corners{find_corner(0.0, 0.0)};
    for (int i = 1; i < n_along; ++i) {
        for (int j = 0; j < n_round; ++j) {
            corners.push_back(find_corner(static_cast<double>(i) / n_along, kTurn * j / n_round));
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
    return TriangleMesh::build(std::move(corners), std::move(triangles)).value();
}

// About the y axis: under the bottom, up the outside, over the rim, down the inside, to the middle of the bottom.
TriangleMesh make_cup(int n_along, int n_round) {
    struct Place {
        double along, radius_m, height_m;
    };
    constexpr Place kProfile[] = {{0.0, 0.0, 0.0},       {0.2, 0.028, 0.0},    {0.25, 0.03, 0.002},
                                  {0.55, 0.038, 0.07},   {0.58, 0.037, 0.072}, {0.61, 0.0355, 0.07},
                                  {0.85, 0.0275, 0.006}, {0.88, 0.025, 0.004}, {1.0, 0.0, 0.004}};
    return make_tube(n_along, n_round, [&](double along, double round) {
        const auto* next = std::ranges::find_if(
            kProfile, [along](const Place& place) { return place.along >= along; });
        const auto* last = next == std::begin(kProfile) ? next : next - 1;
        const double part =
            next == last ? 0.0 : (along - last->along) / (next->along - last->along);
        const double radius_m = std::lerp(last->radius_m, next->radius_m, part);
        return Vector3(radius_m * std::cos(round), std::lerp(last->height_m, next->height_m, part),
                       -radius_m * std::sin(round));
    });
}

// A bowl from 0 to a third of 150 mm along x, then the stem; rippled as hammered silver is.
TriangleMesh make_spoon(int n_along, int n_round) {
    return make_tube(n_along, n_round, [](double along, double round) {
        constexpr double kLength_m = 0.15;
        constexpr double kBowl = 1.0 / 3.0;
        const double bowl = std::clamp(along / kBowl, 0.0, 1.0);
        const double end =
            std::sqrt(std::clamp(4.0 * std::min(along, 1.0 - along) / 0.1, 0.0, 1.0));
        const double in_bowl = std::sin(std::numbers::pi * std::pow(bowl, 0.8));
        const double half_width_m = end * (0.0025 + 0.011 * in_bowl);
        const double half_thick_m = end * (0.0015 + 0.0003 * std::sin(110.0 * along));
        const double x_m = kLength_m * along;
        const double across_m = half_width_m * std::cos(round);
        // Hollow: its middle hangs down, its border does not.
        const double hang_m =
            0.006 * in_bowl * (1.0 - std::pow(std::cos(round), 2.0)) + 0.01 * (1.0 - bowl);
        return Vector3(x_m, half_thick_m * std::sin(round) - hang_m, -across_m);
    });
}

}  // namespace

LevelScene make_jaws_scene(int n_along, int n_round, int n_steps) {
    const TriangleMesh jaw = test::make_jaw(n_along, n_round).value();
    LevelScene scene{.name = {}, .object = jaw, .tool = jaw, .within_m = 0.5e-3, .hands = {}};
    scene.name = "jaws, " + std::to_string(jaw.triangles().size()) + " triangles each";
    for (int i = 0; i < n_steps; ++i) {
        const double t = static_cast<double>(i) / n_steps;
        const double down = std::min(4.0 * t, 1.0);
        const double u = std::max(0.0, t - 0.25);
        scene.hands.push_back(
            {{0.004 * std::sin(12.0 * u), 0.022 - 0.009 * down, 0.003 * std::sin(9.0 * u)},
             compute_exp(Vector3(0.0, 0.15 * std::sin(6.0 * u), 0.0)) *
                 compute_exp(Vector3(0.05 * std::sin(10.0 * u), 0.0, std::numbers::pi))});
    }
    return scene;
}

LevelScene make_spoon_scene(int fineness, int n_steps) {
    LevelScene scene{.name = {},
                     .object = make_cup(6 * fineness, 10 * fineness),
                     .tool = make_spoon(10 * fineness, 4 * fineness),
                     .within_m = 0.5e-3,
                     .hands = {}};
    scene.name = "spoon of " + std::to_string(scene.tool.triangles().size()) +
                 " triangles in a cup of " + std::to_string(scene.object.triangles().size());
    for (int i = 0; i < n_steps; ++i) {
        const double t = static_cast<double>(i) / n_steps;
        const double round = kTurn * t;
        // Bowl down, leaning outwards, so that the stem meets the rim and the bowl the bottom.
        const Quaternion lean(AngleAxis(round, Vector3::UnitY()) *
                              AngleAxis(std::numbers::pi / 2.0 - 0.35, Vector3::UnitZ()));
        const double outwards_m = 0.016 * std::min(5.0 * t, 1.0);
        scene.hands.push_back(
            {Vector3(outwards_m * std::cos(round), 0.012 - 0.011 * std::min(5.0 * t, 1.0),
                     -outwards_m * std::sin(round)),
             lean});
    }
    return scene;
}

LevelScene make_rolling_scene(const std::string& name, const TriangleMesh& mesh, int n_steps) {
    const TriangleMesh scaled = make_scaled(mesh, 0.2 / mesh.diagonal_m());
    LevelScene scene{
        .name = name + ", " + std::to_string(scaled.triangles().size()) + " triangles each",
        .object = scaled,
        .tool = scaled,
        .within_m = 1.0e-3,
        .hands = {}};
    const double height_m = scaled.upper_B().y() - scaled.lower_B().y();
    for (int i = 0; i < n_steps; ++i) {
        const double t = static_cast<double>(i) / n_steps;
        scene.hands.push_back(
            {{0.02 * std::sin(3.0 * t), height_m + 0.002 - 0.012 * std::min(5.0 * t, 1.0),
              0.01 * t},
             compute_exp(Vector3(0.4 * t, 0.0, 0.0)) * compute_exp(Vector3(0.0, 2.0 * t, 0.0))});
    }
    return scene;
}

SceneLevels make_scene_levels(const LevelScene& scene) {
    const ContactLevelSettings settings{.within_m = scene.within_m};
    const double began_s = monotonic_now_s();
    SceneLevels levels;
    levels.tool = ContactLevels::create(scene.tool, settings).value();
    levels.seconds = monotonic_now_s() - began_s;
    levels.object = ContactLevels::create(scene.object, settings).value();
    return levels;
}

ClusterForce::ClusterForce(double within_m, std::unique_ptr<LevelContacts> finder)
    : within_m_(within_m),
      finder_(std::move(finder)),
      near_(1 << 13),
      clusters_({.within_m = within_m, .radius_m = 0.006, .most = 10, .fade_s = 0.0}) {}

void ClusterForce::find(const Pose& X_OT) {
    near_.clear();
    finder_->find(X_OT, within_m_, near_);
}

Vector3 ClusterForce::compute_force_N(const Pose& X_OT) {
    constexpr double kStep_s = 0.001;
    clusters_.update(near_.all(), X_OT, kStep_s);
    Vector3 force = Vector3::Zero();
    for (const ContactCluster& cluster : clusters_.all()) {
        force += kStiffness_N_per_m * cluster.strength *
                 std::max(cluster.depth_m + within_m_, 0.0) * cluster.normal_O;
    }
    return force;
}

PlayedScene play_scene(const LevelScene& scene, const SceneLevels& levels,
                       const LevelPairSettings& settings) {
    constexpr double kCoupling_N_per_m = 500.0;
    constexpr int kRounds = 6;
    ClusterForce contact(scene.within_m,
                         LevelContacts::create(levels.object, levels.tool, settings).value());
    PlayedScene played;
    Vector3 place = scene.hands.front().position;
    for (const Pose& hand : scene.hands) {
        for (int i = 0; i < kRounds; ++i) {
            const Pose here{place, hand.orientation};
            played.us.push_back(time_once([&] { contact.find(here); }).own_us);
            const Vector3 force = contact.compute_force_N(here);
            // Towards the balance, no farther than half of d at a time.
            const double stiffness =
                kCoupling_N_per_m +
                ClusterForce::kStiffness_N_per_m * static_cast<double>(contact.n_clusters());
            const Vector3 step = (kCoupling_N_per_m * (hand.position - place) + force) / stiffness;
            const double most_m = 0.5 * scene.within_m;
            place += step.norm() > most_m ? Vector3(most_m * step.normalized()) : step;
            played.n_contacts += static_cast<double>(contact.n_contacts());
            played.n_pairs += contact.finder().answer().n_looked_at;
            played.n_late += contact.finder().answer().is_late ? 1.0 : 0.0;
        }
        played.felt_N.push_back(kCoupling_N_per_m * (place - hand.position));
    }
    const auto n = static_cast<double>(played.us.size());
    played.n_contacts /= n;
    played.n_pairs /= n;
    played.n_late /= n;
    played.bytes = contact.finder().memory_bytes();
    return played;
}

DeepPlay play_deep(const std::shared_ptr<const ContactLevels>& lump, int n_steps,
                   const LevelPairSettings& settings) {
    constexpr double kDeep_m = 0.01;
    ClusterForce contact(lump->settings().within_m,
                         LevelContacts::create(lump, lump, settings).value());
    DeepPlay played;
    for (int i = 0; i < n_steps; ++i) {
        const double t = 0.001 * i;
        const Pose X_OT{{0.01 * std::sin(kTurn * t), 2.0 * lump->reach_m() - kDeep_m, 0.0},
                        compute_exp(Vector3(0.2, 0.4 + 0.3 * t, 0.1))};
        played.us.push_back(time_once([&] { contact.find(X_OT); }).own_us);
        played.force_N.push_back(contact.compute_force_N(X_OT));
        const auto& answer = contact.finder().answer();
        played.n_left += static_cast<double>(answer.n_left) / n_steps;
        played.n_coarser += static_cast<double>(answer.n_coarser) / n_steps;
        played.most_left_m = std::max(played.most_left_m, answer.left_m);
    }
    return played;
}

}  // namespace fulcrum::bench
