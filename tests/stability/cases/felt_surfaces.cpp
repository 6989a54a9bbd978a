#include "haptics/geometry/shape.h"
#include "haptics/point/god_object.h"
#include "haptics/point/make_proxy.h"
#include "haptics/surface/materials.h"
#include "tests/stability/cases/held_arm.h"
#include "tests/stability/cases/stability_case.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/touchable.h"
#include "tests/support/wall_trial.h"
#include "tests/support/wander.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fulcrum::stability {
namespace {

constexpr const char* kTurned = "most that the force turned in a tick";
constexpr int kSteps = 10000;
using Hand = Vector3 (*)(int i, double slope, Random& random);

constexpr int kFrequency = 224;  // 1 003 520 triangles
constexpr int kSlideSteps = 20000;
constexpr double kDepth = 0.02;  // of the radius

double to_degrees(double angle_rad) {
    return angle_rad * 180.0 / std::numbers::pi;
}

// Between unit vectors, exact for small angles too.
double angle_between(const Vector3& a, const Vector3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

// How far a facet's normal is from the ball's over its corners, at most: the steps in which the surface turns.
double find_facet_angle(const CollisionMesh& mesh) {
    double widest = 0.0;
    for (std::int32_t i = 0; i < mesh.n_triangles(); ++i) {
        const PreparedTriangle t = prepare_triangle(mesh, i);
        for (const Vector3& corner : {t.a, t.b, t.c}) {
            widest =
                std::max(widest, angle_between(t.doubled_area.normalized(), corner.normalized()));
        }
    }
    return widest;
}

Finding slide(double side) {
    const auto mesh = touchable(make_sphere(1.0, kFrequency));
    GodObject proxy(only_solid(mesh));
    Wanderer wanderer(71);
    proxy.reset(wanderer.next() * (1.0 + 0.1 * side));
    double worst_rad = 0.0;
    double sum_rad = 0.0;
    Vector3 before = Vector3::Zero();
    for (int i = 0; i < kSlideSteps; ++i) {
        const ProxyContact& contact = proxy.step(wanderer.next() * (1.0 - kDepth * side), {});
        if (i > 0) {
            const double turned =
                contact.solid == 0 ? angle_between(contact.normal_W, before) : std::numbers::pi;
            worst_rad = worse(worst_rad, turned);
            sum_rad += turned;
        }
        before = contact.normal_W;
    }
    // The hand itself goes round by kStep a tick. Before and after, the force is normal to a facet, which is off the ball's normal by
    // no more than the facet's own angle, from outside up to 1/(1 - depth) of it: there it holds the proxy a little longer.
    const double limit_rad = Wanderer::kStep + 2.0 * find_facet_angle(*mesh) / (1.0 - kDepth);
    return {to_degrees(worst_rad), to_degrees(limit_rad),
            describe("the hand's own turn is %.3f degrees, the mean of all %.3f",
                     to_degrees(Wanderer::kStep), to_degrees(sum_rad / (kSlideSteps - 1)))};
}

const HardCase kOutside{{"a smooth ball of a million triangles, outside",
                         "the hand slides over it at 4 radii a second, pressed in 2 %", kTurned,
                         "degrees", [] { return slide(1.0); }}};
const HardCase kInside{{"a smooth ball of a million triangles, inside",
                        "the hand slides along its inside at 4 radii a second, pressed in 2 %",
                        kTurned, "degrees", [] { return slide(-1.0); }}};

// The point between the walls nearest to the hand: itself, its foot on a wall, or its foot on the bottom line.
Vector3 find_place(double slope, const Vector3& hand_W) {
    const double side = hand_W.x() < 0.0 ? -1.0 : 1.0;
    const Vector3 up_the_wall(side * std::cos(slope), std::sin(slope), 0.0);
    const Vector3 normal(-side * std::sin(slope), std::cos(slope), 0.0);
    if (normal.dot(hand_W) >= 0.0) {
        return hand_W;
    }
    return up_the_wall.dot(hand_W) > 0.0 ? Vector3(hand_W - normal.dot(hand_W) * normal)
                                         : Vector3(0.0, 0.0, hand_W.z());
}

Vector3 sway(int i, double /*slope*/, Random& /*random*/) {
    return {0.3 * std::sin(0.011 * i), 0.2 + 0.6 * std::sin(0.003 * i), 0.9 * std::sin(0.0017 * i)};
}
Vector3 sway_between_walls(int i, double slope, Random& /*random*/) {
    return {0.2 * std::sin(0.011 * i) * std::cos(slope), 0.25 + 0.6 * std::sin(0.003 * i),
            0.9 * std::sin(0.0017 * i)};
}
Vector3 jump(int /*i*/, double /*slope*/, Random& random) {
    return Vector3(0.0, 0.2, 0.0) + Vector3(0.3, 0.6, 0.9).cwiseProduct(random.in_cube());
}

// A ball's middle is where both walls are a radius away, or a radius over the hand's foot on one; a point is a ball of radius 0.
Finding press_into(double opening_deg, int n_strips, Hand hand, double radius_m) {
    const double half_opening = 0.5 * opening_deg * std::numbers::pi / 180.0;
    const double slope = 0.5 * std::numbers::pi - half_opening;
    const Vector3 bottom(0.0, radius_m / std::sin(half_opening), 0.0);
    const auto mesh = touchable(make_trench(slope, n_strips));
    ProxySettings settings;
    if (radius_m > 0.0) {
        settings = {.kind = ProxyKind::virtual_proxy, .cursor = SphereShape{radius_m}};
    }
    const auto proxy = make_proxy(settings, only_solid(mesh), {});
    proxy->reset(Vector3(0.0, radius_m > 0.0 ? 0.9 : 0.7, -0.3));
    Random random(32);
    double worst_m = 0.0;
    int n_bottom = 0;
    for (int i = 0; i < kSteps; ++i) {
        const Vector3 hand_W = hand(i, slope, random);
        const Vector3 place_W = bottom + find_place(slope, hand_W - bottom);
        const ProxyContact& contact = proxy->step(hand_W, {});
        worst_m = worse(worst_m, (contact.position_W - place_W).norm());
        n_bottom += contact.n_constraints == 2 ? 1 : 0;
    }
    // It is held 1e-10 of the mesh's radius over both walls: that is this much over the line where they meet, and a tenth more for rounding; of a
    // ball as much again.
    const double held = radius_m > 0.0 ? 2.0e-10 : 1.1e-10;
    return {worst_m, held * mesh->radius_m() / std::sin(half_opening),
            describe("on both walls at %d of %d steps", n_bottom, kSteps)};
}

constexpr double kBall_m = 0.01;
constexpr const char* kMeasured = "distance from the exact place";
constexpr const char* kSways = "the hand sways below the bottom and up the walls";

const HardCase kRight{{"a groove of 90 degrees", kSways, kMeasured, "m",
                       [] { return press_into(90.0, 7, sway, 0.0); }}};
const HardCase kNarrow{{"a groove of 10 degrees", kSways, kMeasured, "m",
                        [] { return press_into(10.0, 7, sway, 0.0); }}};
const HardCase kNarrowest{{"a groove of 2 degrees", kSways, kMeasured, "m",
                           [] { return press_into(2.0, 7, sway, 0.0); }}};
const HardCase kFine{{"a groove of 2 degrees in 2000 strips", kSways, kMeasured, "m",
                      [] { return press_into(2.0, 2000, sway, 0.0); }}};
const HardCase kJumps{{"a groove of 2 degrees with a hand that jumps",
                       "the hand jumps by up to a metre a tick", kMeasured, "m",
                       [] { return press_into(2.0, 200, jump, 0.0); }}};
const HardCase kBallRight{{"a ball in a groove of 90 degrees", kSways, kMeasured, "m",
                           [] { return press_into(90.0, 7, sway_between_walls, kBall_m); }}};
const HardCase kBallNarrow{{"a ball in a groove of 10 degrees", kSways, kMeasured, "m",
                            [] { return press_into(10.0, 200, sway_between_walls, kBall_m); }}};
const HardCase kBallNarrowest{{"a ball in a groove of 2 degrees", kSways, kMeasured, "m",
                               [] { return press_into(2.0, 7, sway_between_walls, kBall_m); }}};

HapticPlan make_floor_of(const Material& material) {
    HapticPlan plan = make_floor_plan();
    put_material(material, plan.solids[0]);
    return plan;
}

Finding press_on_materials() {
    Finding finding{0.0, z_width::kCalmSteps * kEncoderStep_m, {}};
    for (const Material& material : shipped_materials()) {
        for (const HumanImpedance& human : kHands) {
            finding.take(measure_swing(make_floor_of(material), human), material.name);
        }
    }
    return finding;
}

// Each law, on a floor of nine tenths of the stiffness at which the map ends.
Finding press_on_bumps_at_the_edge() {
    Finding finding{0.0, z_width::kCalmSteps * kEncoderStep_m, {}};
    for (const HumanImpedance& human : kHands) {
        for (const double damping : {0.0, 2.0}) {
            const double stiffness = find_stiffness_inside(human, damping);
            for (const TextureLaw law :
                 {TextureLaw::perturbed_normal, TextureLaw::lateral, TextureLaw::height_offset}) {
                HapticPlan plan = make_floor_plan();
                plan.coupling = {.stiffness_N_per_m = stiffness, .damping_Ns_per_m = damping};
                TextureSettings& texture = plan.solids[0].surface.texture;
                texture.source = NoiseTexture{0.001, 0.004, 1};
                texture.law = law;
                texture.height_m = 1.0e-4;
                finding.take(measure_swing(plan, human),
                             describe("law %d, %.0f N/m", static_cast<int>(law), stiffness));
            }
        }
    }
    return finding;
}

// A hand drops on the floor from 60 mm at each material; a second later the arm is at rest on it.
Finding tap_all_materials() {
    Finding finding{0.0, z_width::kCalmSteps * kEncoderStep_m, {}};
    for (const Material& material : shipped_materials()) {
        for (const HumanImpedance& human : kHands) {
            HeldArm held(make_floor_of(material), make_arm_over_floor(human));
            for (int tap = 0; tap < 5; ++tap) {
                held.aim(0.06);
                held.run(0.5);
                held.aim(-kFloorPress_m);
                held.run(2.0);
            }
            Swing swing;
            for (int k = 0; k < 500; ++k) {
                held.step();
                swing.take(held.height_m());
            }
            finding.take(swing.width(), material.name);
        }
    }
    return finding;
}

// What a bumpy floor gives a hand that strokes it to and fro for ten seconds, beyond the ideal, at its worst moment.
Finding stroke_bumps() {
    Finding finding{0.0, 2.0e-4, {}};
    for (const Material& material : shipped_materials()) {
        HeldArm held(make_floor_of(material), make_arm_over_floor(kPosture));
        held.aim(-kFloorPress_m);
        held.run(1.0);
        const double before_J = held.state().force_energy.peak_J;
        for (int k = 0; k < 10000; ++k) {
            held.aim_at(Vector3(0.013 + 0.03 * std::sin(0.006 * k), -kFloorPress_m, 0.017));
            held.step();
        }
        finding.take(held.state().force_energy.peak_J - before_J, material.name);
    }
    return finding;
}

const HardCase kMaterials{{"pressed on every material",
                           "three hands press 4 mm into floors of all shipped materials",
                           "the hand's swing in the last second", "m", press_on_materials}};
const HardCase kBumpsAtTheEdge{{"bumps on a floor at the edge of the map",
                                "three hands press on bumps of each law, on floors of nine tenths "
                                "of the stiffness at which the Z-width map ends",
                                "the hand's swing in the last second", "m",
                                press_on_bumps_at_the_edge}};
const HardCase kTaps{{"taps on every material",
                      "three hands tap floors of all shipped materials from 60 mm, and stay",
                      "the hand's swing two seconds later", "m", tap_all_materials}};
const HardCase kStroke{{"bumps stroked to and fro",
                        "a hand strokes floors of all shipped materials at up to 0.18 m/s",
                        "energy given beyond the ideal, at the worst", "J", stroke_bumps}};

}  // namespace

}  // namespace fulcrum::stability
