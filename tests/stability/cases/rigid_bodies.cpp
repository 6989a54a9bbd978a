// Bodies that rest on each other, hang in chains, begin in each other or are flung: what makes simulated worlds fall over.
#include "tests/stability/cases/stability_case.h"
#include "tests/support/rigid_worlds.h"
#include "tests/support/wander.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace fulcrum::stability {
namespace {

constexpr double kStep_s = 1.0e-3;
constexpr double kHalf_m = 0.05;

RigidWorldPlan make_ground_plan() {
    RigidWorldPlan plan;
    plan.settings.sleep_after_s = 0.0;  // what only stands because it sleeps does not stand
    plan.bodies.push_back({.role = BodyRole::ground});
    return plan;
}

RigidBodyPlan make_brick(const Vector3& half_m, const Pose& pose, double mass_kg) {
    return {.shape = BoxShape{half_m}, .mass_kg = mass_kg, .pose_W = pose};
}

// How far any body ever gets from where it began, and how deep anything overlaps, whichever is more.
Finding stand(const RigidWorldPlan& plan, double time_s, double limit_m) {
    const auto world = make_rigid_world(plan);
    double worst_m = 0.0;
    for (int i = 0; i < static_cast<int>(time_s / kStep_s); ++i) {
        world->step(kStep_s);
        worst_m = worse(worst_m, world->report().deepest_m);
        for (int body = 0; body < world->n_bodies(); ++body) {
            const Vector3& began = plan.bodies[static_cast<std::size_t>(body)].pose_W.position;
            worst_m = worse(worst_m, (world->shape_pose_W(body).position - began).norm());
        }
    }
    return {worst_m, limit_m, {}};
}

RigidWorldPlan make_stack(int n, double top_kg, double noise_m = 0.0) {
    RigidWorldPlan plan = make_ground_plan();
    Random random(3);
    double height_m = 0.0;
    for (int i = 0; i < n; ++i) {
        const Vector3 half_m = Vector3::Constant(kHalf_m) + noise_m * random.in_cube();
        plan.bodies.push_back(make_brick(half_m, Pose::at({0.0, height_m + half_m.y(), 0.0}),
                                         i + 1 == n ? top_kg : 1.0));
        height_m += 2.0 * half_m.y();
    }
    return plan;
}

Finding stand_stacks() {
    Finding worst{0.0, 5.0e-5, {}};
    for (const int n : {6, 10, 20}) {
        worst.worst = worse(worst.worst, stand(make_stack(n, 1.0), 3.0, 0.0).worst);
    }
    return worst;
}

Finding stand_heavy_top() {
    return stand(make_stack(20, 100.0), 2.0, 5.0e-5);
}

Finding stand_ratios() {
    Finding worst{0.0, 5.0e-5, {}};
    for (const double ratio : {1.0e-3, 1.0e3}) {
        worst.worst = worse(worst.worst, stand(make_stack(4, ratio), 2.0, 0.0).worst);
    }
    return worst;
}

Finding stand_noisy() {
    return stand(make_stack(10, 1.0, 1.0e-6), 3.0, 5.0e-5);
}

// Cards of 4 mm at 65 degrees.
constexpr double kLean_rad = 25.0 * M_PI / 180.0;
const Vector3 kCard_m(0.002, 0.05, 0.03);

RigidBodyPlan make_card(const Vector3& half_m, const Pose& pose) {
    RigidBodyPlan card = make_brick(half_m, pose, 0.01);
    card.static_friction = card.dynamic_friction = 1.0;
    return card;
}

// From the middle of a tent to that of its card.
Vector3 find_card_place() {
    return {kCard_m.x() * std::cos(kLean_rad) + kCard_m.y() * std::sin(kLean_rad),
            kCard_m.y() * std::cos(kLean_rad) + kCard_m.x() * std::sin(kLean_rad), 0.0};
}

// Two cards whose upper inner edges meet over the middle, and whose lower outer ones stand at this height.
void add_tent(double x_m, double y_m, RigidWorldPlan& plan) {
    for (const double side : {-1.0, 1.0}) {
        const Quaternion turn(AngleAxis(side * kLean_rad, Vector3::UnitZ()));
        const Vector3 place = find_card_place();
        plan.bodies.push_back(
            make_card(kCard_m, {Vector3(x_m + side * place.x(), y_m + place.y(), 0.0), turn}));
    }
}

RigidWorldPlan make_rough_ground_plan() {
    RigidWorldPlan plan = make_ground_plan();
    plan.bodies[0].static_friction = plan.bodies[0].dynamic_friction = 1.0;
    return plan;
}

Finding stand_cards() {
    RigidWorldPlan plan = make_rough_ground_plan();
    add_tent(0.0, 0.0, plan);
    return stand(plan, 3.0, 2.0e-4);
}

// Two tents, a card over both, and a tent on that.
Finding stand_house() {
    RigidWorldPlan plan = make_rough_ground_plan();
    const Vector3 place = find_card_place();
    add_tent(-2.0 * place.x(), 0.0, plan);
    add_tent(2.0 * place.x(), 0.0, plan);
    const Vector3 plank_m(2.0 * place.x() + 0.01, kCard_m.x(), kCard_m.z());
    plan.bodies.push_back(make_card(plank_m, Pose::at({0.0, 2.0 * place.y() + plank_m.y(), 0.0})));
    add_tent(0.0, 2.0 * (place.y() + plank_m.y()), plan);
    return stand(plan, 5.0, 5.0e-5);
}

// An arch of eleven wedges between walls of friction: each a hull, no mortar.
Finding stand_arch() {
    RigidWorldPlan plan = make_ground_plan();
    constexpr int kStones = 11;
    constexpr double kInner_m = 0.4;
    constexpr double kOuter_m = 0.55;
    const double turn_rad = M_PI / kStones;
    for (int i = 0; i < kStones; ++i) {
        const double middle_rad = (i + 0.5) * turn_rad;
        const Vector3 centre(0.475 * std::cos(middle_rad), 0.475 * std::sin(middle_rad), 0.0);
        std::vector<Vector3> corners;
        for (const double radius_m : {kInner_m, kOuter_m}) {
            for (const double edge : {-0.5, 0.5}) {
                for (const double z_m : {-0.1, 0.1}) {
                    const double angle_rad = middle_rad + edge * turn_rad;
                    corners.push_back(Vector3(radius_m * std::cos(angle_rad),
                                              radius_m * std::sin(angle_rad), z_m) -
                                      centre);
                }
            }
        }
        RigidBodyPlan stone{.shape = make_hull_shape(corners).value(),
                            .density_kg_per_m3 = 2000.0,
                            .pose_W = Pose::at(centre)};
        plan.bodies.push_back(stone);
    }
    for (RigidBodyPlan& body : plan.bodies) {
        body.static_friction = body.dynamic_friction = 0.8;
    }
    return stand(plan, 2.0, 1.0e-3);
}

// Thirty links of 10 g with 10 kg at the end, let go level: how far links part.
Finding swing_chain() {
    RigidWorldPlan plan;
    plan.settings.sleep_after_s = 0.0;
    constexpr int kLinks = 30;
    for (int i = 0; i < kLinks; ++i) {
        plan.bodies.push_back({.shape = CapsuleShape{0.005, 0.02},
                               .mass_kg = i + 1 == kLinks ? 10.0 : 0.01,
                               .pose_W = {Vector3(0.05 * i + 0.025, 0.0, 0.0),
                                          Quaternion(AngleAxis(M_PI / 2, Vector3::UnitZ()))}});
        plan.joints.push_back({.kind = JointKind::ball,
                               .body_a = i - 1,
                               .body_b = i,
                               .anchor_W = {0.05 * i, 0.0, 0.0}});
    }
    const auto world = make_rigid_world(plan);
    const double energy_J = world->compute_energy_J();
    double worst_m = 0.0;
    double gained_J = 0.0;
    for (int i = 0; i < 3000; ++i) {
        world->step(kStep_s);
        gained_J = worse(gained_J, world->compute_energy_J() - energy_J);
        for (int link = 0; link + 1 < kLinks; ++link) {
            const Vector3 end = world->shape_pose_W(link) * Vector3(0.0, -0.025, 0.0);
            const Vector3 begin = world->shape_pose_W(link + 1) * Vector3(0.0, 0.025, 0.0);
            worst_m = worse(worst_m, (end - begin).norm());
        }
    }
    const bool gains = !(gained_J < 3.0);  // 2 % of what the fall gives
    return {gains ? std::nan("") : worst_m, 1.0e-3, gains ? "energy is gained" : ""};
}

// Of ten in a row the ends are parted by nine pushes of 0.5 m/s, and each has half of them.
constexpr double kMostLeaving_m_per_s = 0.5 * 9 * 0.5;

// Ten cubes begin in one place: nobody leaves faster than what pushes apart, and no overlap stays.
Finding part_deep_overlap() {
    RigidWorldPlan plan;
    plan.settings.gravity_W.setZero();
    plan.settings.sleep_after_s = 0.0;
    Random random(5);
    for (int i = 0; i < 10; ++i) {
        plan.bodies.push_back(make_brick(Vector3::Constant(kHalf_m),
                                         {0.01 * random.in_cube(), random.turn(1.0)}, 1.0));
    }
    const auto world = make_rigid_world(plan);
    double energy_J = 0.0;
    double fastest_m_per_s = 0.0;
    for (int i = 0; i < 3000; ++i) {
        std::vector<Vector3> before;
        for (int body = 0; body < world->n_bodies(); ++body) {
            before.push_back(world->state(body).pose_W.position);
        }
        world->step(kStep_s);
        energy_J = worse(energy_J, world->compute_energy_J());
        for (int body = 0; body < world->n_bodies(); ++body) {
            const Vector3 way =
                world->state(body).pose_W.position - before[static_cast<std::size_t>(body)];
            fastest_m_per_s = worse(fastest_m_per_s, way.norm() / kStep_s);
        }
    }
    const bool leaves = !(fastest_m_per_s < kMostLeaving_m_per_s);
    return {leaves ? std::nan("") : worse(world->report().deepest_m, energy_J), 1.0e-4,
            leaves ? "one leaves faster than what pushes apart" : ""};
}

// A cube flung at 100 m/s into a wall of ten.
Finding hit_wall() {
    RigidWorldPlan plan = make_ground_plan();
    for (int i = 0; i < 10; ++i) {
        plan.bodies.push_back(make_brick(
            Vector3::Constant(kHalf_m),
            Pose::at({0.1001 * (i % 5), kHalf_m + 0.1 * std::floor(i / 5.0), 0.0}), 1.0));
    }
    RigidBodyPlan flung = make_brick(Vector3::Constant(kHalf_m), Pose::at({-5.0, 0.1, 0.02}), 1.0);
    flung.velocity_W.linear = {100.0, 0.0, 0.0};
    plan.bodies.push_back(flung);
    const auto world = make_rigid_world(plan);
    double energy_J = world->compute_energy_J();
    double gained_J = 0.0;
    double deepest_m = 0.0;
    for (int i = 0; i < 500; ++i) {
        world->step(kStep_s);
        gained_J = worse(gained_J, world->compute_energy_J() - energy_J);
        energy_J = world->compute_energy_J();
        deepest_m = worse(deepest_m, world->report().deepest_m);
    }
    // A hundred thousandth of what it brought: what lies deep is lifted as it is pushed apart.
    return {worse(deepest_m, gained_J), 0.05, {}};
}

// Seconds that a brick spins: 100, or an hour where FULCRUM_SPIN_SECONDS says 3600.
double spin_seconds() {
    const char* const asked = std::getenv("FULCRUM_SPIN_SECONDS");
    return asked != nullptr ? std::atof(asked) : 100.0;
}

// A brick with three different moments spins freely about its middle axis, which is unstable: it tumbles, and energy and momentum stay.
Finding spin_freely() {
    RigidWorldPlan plan;
    plan.settings.gravity_W.setZero();
    plan.settings.sleep_after_s = 0.0;
    RigidBodyPlan brick = make_brick({0.03, 0.05, 0.1}, Pose{}, 1.0);
    brick.velocity_W.angular = {1.0e-3, 10.0, 0.0};
    plan.bodies.push_back(brick);
    const auto world = make_rigid_world(plan);
    const double energy_J = world->compute_energy_J();
    const auto momentum = [&] {
        return compute_angular_momentum_W(world->inertia(0), world->state(0));
    };
    const Vector3 began = momentum();
    const auto n_steps = static_cast<int>(spin_seconds() / kStep_s);
    double worst = 0.0;
    for (int i = 0; i < n_steps; ++i) {
        world->step(kStep_s);
        worst = worse(worst, std::abs(world->compute_energy_J() / energy_J - 1.0));
        worst = worse(worst, (momentum() - began).norm() / began.norm());
    }
    return {worst, 1.0e-3, {}};
}

// A hand drives a wedge down between two cubes, by up to 200 N on a spring: they part, nothing sinks in, and no more energy is there
// than the hand gave.
Finding drive_wedge() {
    RigidWorldPlan plan = make_ground_plan();
    constexpr double kEdge_m = 2.0 * kHalf_m;
    const std::vector<Vector3> corners{{-0.05, 0.1, -0.05}, {0.05, 0.1, -0.05}, {0.05, 0.1, 0.05},
                                       {-0.05, 0.1, 0.05},  {0.0, -0.1, -0.05}, {0.0, -0.1, 0.05}};
    for (const double side : {-1.0, 1.0}) {
        plan.bodies.push_back(make_brick(Vector3::Constant(kHalf_m),
                                         Pose::at({side * (kHalf_m + 0.002), kHalf_m, 0.0}), 5.0));
    }
    plan.bodies.push_back({.shape = make_hull_shape(corners).value(),
                           .mass_kg = 0.5,
                           .pose_W = Pose::at({0.0, kEdge_m + 0.1, 0.0})});
    for (RigidBodyPlan& body : plan.bodies) {
        body.static_friction = body.dynamic_friction = 0.2;
    }
    const auto world = make_rigid_world(plan);
    constexpr double kMost_N = 200.0;
    constexpr double kStiffness_N_per_m = 4000.0;
    double deepest_m = 0.0;
    double given_J = world->compute_energy_J();
    double gained_J = 0.0;
    for (int i = 0; i < 2000; ++i) {
        const Vector3 before = world->state(3).pose_W.position;
        const double hand_m = kEdge_m + 0.1 - 0.1 * std::min(i * kStep_s, 1.0);
        const double push_N =
            std::clamp(kStiffness_N_per_m * (hand_m - before.y()), -kMost_N, kMost_N);
        world->push(3, {{0.0, push_N, 0.0}, {0.0, 0.0, 0.0}});
        world->step(kStep_s);
        given_J += push_N * (world->state(3).pose_W.position.y() - before.y());
        deepest_m = worse(deepest_m, world->report().deepest_m);
        gained_J = worse(gained_J, world->compute_energy_J() - given_J);
    }
    const double parted_m =
        world->shape_pose_W(2).position.x() - world->shape_pose_W(1).position.x() - kEdge_m;
    const bool stuck = !(parted_m > 0.02);
    const bool gains = !(gained_J < 0.01);
    return {stuck || gains ? std::nan("") : deepest_m, 2.0e-4,
            stuck ? "the wedge is stuck" : (gains ? "energy is gained" : "")};
}

const HardCase kStacks{{"rigid stacks",
                        "6, 10 and 20 equal cubes stand on each other for 3 s at 1 kHz",
                        "how far any gets or overlaps", "m", stand_stacks}};
const HardCase kHeavyTop{{"rigid stack under 100 kg", "20 cubes of 1 kg, the top one of 100 kg",
                          "how far any gets or overlaps", "m", stand_heavy_top}};
const HardCase kRatios{{"rigid mass ratios",
                        "a cube 1000 times heavier or lighter than the three below it",
                        "how far any gets or overlaps", "m", stand_ratios}};
const HardCase kNoisy{{"rigid stack with noise",
                       "10 boxes whose sizes differ by a millionth of a metre",
                       "how far any gets or overlaps", "m", stand_noisy}};
const HardCase kCards{{"house of cards", "two cards of 4 mm lean on each other",
                       "how far any gets or overlaps", "m", stand_cards}};
const HardCase kHouse{{"house of cards of two storeys",
                       "two tents of cards, a card over both, and a tent on it",
                       "how far any gets or overlaps", "m", stand_house}};
const HardCase kArch{{"arch", "eleven wedges without mortar stand by friction",
                      "how far any gets or overlaps", "m", stand_arch}};
const HardCase kChain{{"chain with a heavy end", "30 links of 10 g swing 10 kg",
                       "how far links part", "m", swing_chain}};
const HardCase kDeep{{"deep overlap", "ten cubes begin in one place",
                      "overlap in m or energy in J, the greater", "m", part_deep_overlap}};
const HardCase kFlung{{"body at 100 m/s", "a cube is flung at ten others",
                       "overlap in m or energy gained in J, the greater", "m", hit_wall}};
const HardCase kSpin{
    {"spinning brick",
     "a brick tumbles freely for 100 s, or for an hour with FULCRUM_SPIN_SECONDS=3600",
     "energy or momentum won or lost, of all", "", spin_freely}};
const HardCase kWedge{{"driven wedge", "a hand drives a wedge between two cubes with up to 200 N",
                       "how far any overlaps", "m", drive_wedge}};

}  // namespace
}  // namespace fulcrum::stability
