#include "haptics/geometry/shape.h"
#include "haptics/point/god_object.h"
#include "haptics/point/make_proxy.h"
#include "haptics/surface/shading.h"
#include "tests/stability/cases/stability_case.h"
#include "tests/support/bumpy_ball.h"
#include "tests/support/nearest_point.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <string>

namespace fulcrum::stability {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr const char* kMeasured = "shots that got inside";

constexpr double kDepth = 0.02;
constexpr double kTube = 0.4;  // of the ring's radius of 1
constexpr int kSteps = 20000;
constexpr double kFar = 3.0;         // times the depth: further is a snag
constexpr double kNearest = 2.0e-5;  // radii

// A body and where a hand is that presses it, for a direction that wanders.
struct Body {
    std::shared_ptr<const CollisionMesh> mesh;
    std::function<Vector3(const Vector3& u, double depth)> press;
};

Body make_ball(int frequency) {
    return {touchable(make_bumpy_sphere(1.0, frequency, kBumpHeight, kBumps)),
            [](const Vector3& u, double depth) { return Vector3(u * (bumpy_radius(u) - depth)); }};
}

// The direction leads once round the ring and once round the tube, whichever way it wanders.
Body make_ring(int n_ring) {
    return {touchable(make_torus(1.0, kTube, n_ring, n_ring * 2 / 5)),
            [](const Vector3& u, double depth) {
                const double turn = std::atan2(u.x(), u.z());
                const double tilt = 2.0 * std::asin(std::clamp(u.y(), -1.0, 1.0));
                const Vector3 out(std::sin(turn), 0.0, std::cos(turn));
                return Vector3(out + (kTube - depth) * (std::cos(tilt) * out +
                                                        std::sin(tilt) * Vector3::UnitY()));
            }};
}

// How far from the surface the hand is, and how far from it the proxy, over the whole way.
struct Course {
    int n_snagged = 0;
    int n_free = 0;
    double worst_excess = 0.0;  // of the proxy's distance from the hand over the nearest point's
};

Course slide(const Body& body, double side, const FrictionSettings& friction, int steps_a_check) {
    std::vector<SolidPlan> solids = only_solid(body.mesh);
    solids.front().friction = friction;
    ProxySettings settings;
    settings.kind =
        friction.static_coefficient > 0.0 ? ProxyKind::friction_cone : ProxyKind::god_object;
    const auto proxy = make_proxy(settings, solids, {});
    Wanderer wanderer(7);
    proxy->reset(body.press(wanderer.next(), -0.1 * side));
    Course course;
    for (int i = 0; i < kSteps; ++i) {
        const Vector3& u = wanderer.next();
        const Vector3 hand_W = body.press(u, kDepth * side);
        const ProxyContact& contact = proxy->step(hand_W, {});
        const double gap = (contact.position_W - hand_W).norm();
        // Friction of coefficient mu holds the proxy back by mu times the depth at most.
        const double most = kFar * kDepth * std::hypot(1.0, friction.static_coefficient);
        course.n_snagged += gap > most ? 1 : 0;
        // A coarse mesh does not reach all bumps: free it is rightly where no facet lies above the hand.
        course.n_free +=
            contact.solid == kNoBody &&
                    find_nearest_hit(*body.mesh, hand_W, body.press(u, -0.1 * side)).found()
                ? 1
                : 0;
        if (steps_a_check > 0 && i % steps_a_check == steps_a_check - 1) {
            const Vector3 nearest = find_nearest_on_mesh(*body.mesh, hand_W);
            course.worst_excess = worse(course.worst_excess, gap - (nearest - hand_W).norm());
        }
    }
    return course;
}

Finding count_snags(const Body& body, const FrictionSettings& friction) {
    int n_snagged = 0;
    int n_free = 0;
    for (const double side : {1.0, -1.0}) {
        const Course course = slide(body, side, friction, 0);
        n_snagged += course.n_snagged;
        n_free += course.n_free;
    }
    return {static_cast<double>(n_snagged + n_free), 0.0,
            std::to_string(body.mesh->n_triangles()) + " triangles, " + std::to_string(2 * kSteps) +
                " steps, free in " + std::to_string(n_free)};
}

// From inside, where the mesh's nearest point is one as long as the hand is not beyond the bumps' centres of curvature.
Finding find_nearest_error(const Body& body) {
    const Course course = slide(body, -1.0, {}, 400);
    return {course.worst_excess, kNearest,
            std::to_string(body.mesh->n_triangles()) + " triangles, against the nearest of all"};
}

// The widest angle between the facets that lie within `reach` of a point.
double find_spread_rad(const CollisionMesh& mesh, const Vector3& centre_B, double reach) {
    std::vector<Vector3> normals;
    const Vector3 half = Vector3::Constant(reach);
    mesh.tree().for_each_in_box({centre_B - half, centre_B + half}, [&](std::int32_t triangle) {
        normals.emplace_back(prepare_triangle(mesh, triangle).doubled_area.normalized());
    });
    double widest = 0.0;
    for (std::size_t i = 0; i < normals.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            widest = std::max(widest, std::atan2(normals[i].cross(normals[k]).norm(),
                                                 normals[i].dot(normals[k])));
        }
    }
    return widest;
}

double find_angle_deg(const Vector3& a, const Vector3& b) {
    return kDegrees * std::atan2(a.cross(b).norm(), a.dot(b));
}

// By how much what is felt turns in a tick, by how much it may, and how much more than that it does.
struct Turns {
    double felt_deg = 0.0;
    double allowed_deg = 0.0;
    double worst_deg = 0.0;
};

// Pressed in and carried over the body from both sides; felt(contact) is a direction, allowed_deg(before, contact) an angle.
template <class Felt, class Allowed>
Turns measure_turns(const Body& body, const Felt& felt, const Allowed& allowed_deg) {
    Turns turns;
    for (const double side : {1.0, -1.0}) {
        GodObject proxy(only_solid(body.mesh));
        Wanderer wanderer(9);
        proxy.reset(body.press(wanderer.next(), -0.1 * side));
        ProxyContact before;
        for (int i = 0; i < kSteps / 4; ++i) {
            const ProxyContact contact = proxy.step(body.press(wanderer.next(), kDepth * side), {});
            if (i > 0) {
                const double turned_deg = find_angle_deg(felt(before), felt(contact));
                const double allowed = allowed_deg(before, contact);
                turns.felt_deg = std::max(turns.felt_deg, turned_deg);
                turns.allowed_deg = std::max(turns.allowed_deg, allowed);
                turns.worst_deg = worse(turns.worst_deg, turned_deg - allowed);
            }
            before = contact;
        }
    }
    return turns;
}

Finding tell_turns(const Body& body, const Turns& turns, const char* what, double most_deg) {
    return {turns.worst_deg, 1.0,
            describe("%d triangles; %s by up to %.2f", body.mesh->n_triangles(), what, most_deg)};
}

// More than the facets turn that lie within two ticks' way of the proxy.
Finding find_turn(const Body& body) {
    const Turns turns = measure_turns(
        body, [](const ProxyContact& contact) { return contact.normal_W; },
        [&](const ProxyContact& /*before*/, const ProxyContact& contact) {
            return kDegrees *
                   find_spread_rad(*body.mesh, contact.position_W, 2.0 * Wanderer::kStep);
        });
    return tell_turns(body, turns, "with the facets it turned", turns.felt_deg);
}

// The true ball's normal over a place: of |p| = bumpy_radius(p / |p|).
Vector3 bumpy_normal(const Vector3& p) {
    const Vector3 u = p.normalized();
    const Vector3 slope =
        kBumpHeight * kBumps / 3.0 * (kBumps * u).unaryExpr([](double x) { return std::cos(x); });
    return (u - (slope - u.dot(slope) * u) / p.norm()).normalized();
}

// The shaded force, more than the true ball's normal turns under the proxy: at 4 radii a second the bumps alone turn that by more
// than a degree.
Finding find_shaded_turn(const Body& body) {
    const ShadedNormals shaded(body.mesh, 60.0);
    const Turns turns = measure_turns(
        body,
        [&](const ProxyContact& contact) {
            Vector3 force = Vector3::Zero();
            for (const SolidTouch& touch : contact.active()) {
                force += touch.push_m *
                         shaded.normal_B(touch.feature, contact.position_W, touch.normal_W);
            }
            return force;
        },
        [](const ProxyContact& before, const ProxyContact& contact) {
            return find_angle_deg(bumpy_normal(before.position_W),
                                  bumpy_normal(contact.position_W));
        });
    return tell_turns(body, turns, "the true ball's normal turned", turns.allowed_deg);
}

constexpr FrictionSettings kRough{.static_coefficient = 0.5, .dynamic_coefficient = 0.4};
constexpr const char* kSnags =
    "steps further than three depths from the hand, or free where they should not";
constexpr const char* kSlide = "the hand slides over it and along its inside, 2 % deep";
constexpr const char* kRub = "the same with friction of 0.5 and 0.4";

const HardCase kBall1k{{"pressed: a bumpy ball of 1 k", kSlide, kSnags, "",
                        [] { return count_snags(make_ball(7), {}); }}};
const HardCase kBall10k{{"pressed: a bumpy ball of 10 k", kSlide, kSnags, "",
                         [] { return count_snags(make_ball(22), {}); }}};
const HardCase kBall100k{{"pressed: a bumpy ball of 100 k", kSlide, kSnags, "",
                          [] { return count_snags(make_ball(71), {}); }}};
const HardCase kRing1k{
    {"pressed: a ring of 1 k", kSlide, kSnags, "", [] { return count_snags(make_ring(36), {}); }}};
const HardCase kRing100k{{"pressed: a ring of 100 k", kSlide, kSnags, "",
                          [] { return count_snags(make_ring(354), {}); }}};
const HardCase kRough10k{{"pressed: a rough bumpy ball of 10 k", kRub, kSnags, "",
                          [] { return count_snags(make_ball(22), kRough); }}};
const HardCase kRough100k{{"pressed: a rough ring of 100 k", kRub, kSnags, "",
                           [] { return count_snags(make_ring(354), kRough); }}};
const HardCase kNear10k{{"pressed: the nearest point of 10 k", "from inside a bumpy ball, 2 % deep",
                         "distance from the hand over the nearest point's", "R",
                         [] { return find_nearest_error(make_ball(22)); }}};
const HardCase kNear100k{{"pressed: the nearest point of 100 k",
                          "from inside a bumpy ball, 2 % deep",
                          "distance from the hand over the nearest point's", "R",
                          [] { return find_nearest_error(make_ball(71)); }}};
const HardCase kTurn{{"pressed: turns of the force on a ball of 100 k", kSlide,
                      "turn in a tick beyond that of the facets around", "degrees",
                      [] { return find_turn(make_ball(71)); }}};
const HardCase kTurnRing{{"pressed: turns of the force on a ring of 100 k", kSlide,
                          "turn in a tick beyond that of the facets around", "degrees",
                          [] { return find_turn(make_ring(354)); }}};

const HardCase kShaded100k{
    {"pressed: how a shaded ball of 100 k turns", kSlide,
     "most that the shaded force turned in a tick more than the true surface", "degrees",
     [] { return find_shaded_turn(make_ball(71)); }}};

// From twice as far out straight to the middle, in `n_ticks`: halving is exact, so the way leads through `p` itself. True
// when the proxy is behind the surface then.
bool leaks(const std::shared_ptr<const CollisionMesh>& mesh, const Vector3& p, int n_ticks) {
    GodObject proxy(only_solid(mesh));
    proxy.reset(2.0 * p);
    for (int i = 1; i <= n_ticks; ++i) {
        proxy.step(2.0 * p * (1.0 - static_cast<double>(i) / n_ticks), {});
    }
    const Vector3& place = proxy.contact().position_W;
    return proxy.contact().solid == kNoBody ||
           find_nearest_hit(*mesh, place, place + 2.0 * p).found();
}

struct Shots {
    int n_leaks = 0;
    int count = 0;
    void shoot(const std::shared_ptr<const CollisionMesh>& mesh, const Vector3& p) {
        // One tick from outside to the middle; four of which one ends in `p` itself.
        for (const int n_ticks : {1, 4}) {
            n_leaks += leaks(mesh, p, n_ticks) ? 1 : 0;
            ++count;
        }
    }
    [[nodiscard]] Finding finding() const {
        return {static_cast<double>(n_leaks), 0.0, "of " + std::to_string(count) + " shots"};
    }
};

// Every vertex, where five or six triangles meet.
Finding shoot_at_vertices() {
    const auto ball = make_sphere(1.0, 12);
    const auto mesh = touchable(ball);
    Shots shots;
    for (const Vector3& vertex : ball->vertices_B()) {
        shots.shoot(mesh, vertex);
    }
    return shots.finding();
}

// Eighths along the edges of a cube and the diagonals of its faces: numbers that a double holds exactly.
Finding shoot_at_edges() {
    const auto cube = make_box(Vector3::Ones());
    const auto mesh = touchable(cube);
    Shots shots;
    for (const TriangleCorners& t : cube->triangles()) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Vector3& a = cube->vertices_B()[static_cast<std::size_t>(t[i])];
            const Vector3& b = cube->vertices_B()[static_cast<std::size_t>(t[(i + 1) % 3])];
            for (int eighth = 0; eighth < 8; ++eighth) {
                shots.shoot(mesh, a + 0.125 * eighth * (b - a));
            }
        }
    }
    return shots.finding();
}

const HardCase kVertices{{"shots exactly at vertices", "at every vertex of a ball, fast and slow",
                          kMeasured, "", shoot_at_vertices}};
const HardCase kEdges{{"shots exactly at edges",
                       "at places on the edges of a cube and the diagonals of its faces", kMeasured,
                       "", shoot_at_edges}};

}  // namespace

}  // namespace fulcrum::stability
