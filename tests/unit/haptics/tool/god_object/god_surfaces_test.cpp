#include "haptics/geometry/shape.h"
#include "haptics/math/rotation.h"
#include "haptics/tool/god_object/god_shading.h"
#include "haptics/tool/god_object/god_surface.h"
#include "tests/support/edited_meshes.h"
#include "tests/support/god_scene.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

using namespace fulcrum;

namespace {

constexpr double kEpsilon = 1.0e-8;

// How many corners and edges of triangles may touch.
struct Carrying {
    int corners = 0;
    int edges = 0;
};
Carrying count_carrying(const GodSurface& surface) {
    Carrying n;
    for (std::int32_t i = 0; i < surface.swept().n_triangles(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            n.corners += surface.carries_corner(i, k) ? 1 : 0;
            n.edges += surface.carries_edge(i, k) ? 1 : 0;
        }
    }
    return n;
}

using test::make_spike;
using test::move_to;

constexpr double kStiffness = 500.0;
constexpr double kRadius_m = 0.05;
constexpr double kDepth_m = 0.002;
TriangleMesh make_ball() {
    return make_sphere(kRadius_m, 5).value();
}

std::shared_ptr<const GodShading> shade(const TriangleMesh& mesh, double crease_angle_deg = 45.0) {
    return GodShading::create(mesh, {.on = true, .crease_angle_deg = crease_angle_deg}).value();
}

struct Shaded {
    bool object = false;
    bool tool = false;
};

GodObjectTool make_tool(const TriangleMesh& tool, const TriangleMesh& object, Shaded shaded) {
    GodObjectPlan plan{.object = GodSurface::create(object), .tool = GodSurface::create(tool)};
    plan.object_shading = shaded.object ? shade(object) : nullptr;
    plan.tool_shading = shaded.tool ? shade(tool) : nullptr;
    return GodObjectTool::build({plan}, test::make_sudden_settings(test::make_still_inertia()))
        .value();
}

double angle_between(const Vector3& a, const Vector3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

// How far the force's direction turns in a step, beyond what the way turns, and how far it is from the ball's own; rad.
struct Turns {
    double most_jump = 0.0;
    double most_off = 0.0;
    double rms_jump = 0.0;
};

constexpr int kSteps = 3000;
constexpr double kArc_rad = 1.2;

Vector3 find_direction(int i) {
    const double angle = kArc_rad * (static_cast<double>(i) / kSteps - 0.5);
    return compute_exp(Vector3(0.3, 0.4, 0.2)) * Vector3(std::sin(angle), std::cos(angle), 0.0);
}

// A spike drawn over a ball, or a ball over a spike that stands with its tip at the origin.
Turns draw_over(GodObjectTool& tool, bool ball_is_tool) {
    const auto handle_at = [&](int i, double out_m) {
        const Vector3 out = find_direction(i);
        return ball_is_tool ? Pose{Vector3(0.0, kRadius_m + out_m, 0.0),
                                   Quaternion::FromTwoVectors(-out, -Vector3::UnitY())}
                            : Pose{(kRadius_m + out_m) * out,
                                   Quaternion::FromTwoVectors(Vector3::UnitY(), out)};
    };
    tool.place(handle_at(0, 0.003));
    for (int i = 0; i <= 60; ++i) {
        (void)move_to(tool, handle_at(0, 0.003 - (0.003 + kDepth_m) * i / 50.0));
    }
    Turns turns;
    Vector3 before = Vector3::Zero();
    for (int i = 0; i < kSteps; ++i) {
        const ToolFelt felt = move_to(tool, handle_at(i, -kDepth_m));
        const Vector3 even = ball_is_tool ? Vector3(Vector3::UnitY()) : find_direction(i);
        REQUIRE(felt.felt_W.force.norm() > 0.5 * kStiffness * kDepth_m);
        turns.most_off = std::max(turns.most_off, angle_between(felt.felt_W.force, even));
        if (i > 0) {
            const double jump = angle_between(felt.felt_W.force, before);
            turns.most_jump = std::max(turns.most_jump, jump);
            turns.rms_jump += jump * jump / kSteps;
        }
        before = felt.felt_W.force;
    }
    turns.rms_jump = std::sqrt(turns.rms_jump);
    return turns;
}

}  // namespace

TEST_CASE("god surface: a box touches with its edges, a plate with its border, faces do not") {
    const auto box = GodSurface::create(make_box({0.1, 0.2, 0.3}).value());
    // Twelve triangles: two of three edges, all corners.
    CHECK(count_carrying(*box).edges == 24);
    CHECK(count_carrying(*box).corners == 36);
    constexpr int kN = 4;
    const TriangleMesh plate = make_plate(0.1, 0.1, kN).value();
    const auto surface = GodSurface::create(plate);
    const auto is_border = [&](const Vector3& v) {
        return std::max(std::abs(v.x()), std::abs(v.z())) > 0.05 - 1.0e-12;
    };
    int n_edges = 0;
    for (std::int32_t i = 0; i < surface->swept().n_triangles(); ++i) {
        const Triangle t = surface->swept().triangle(i);
        for (std::size_t k = 0; k < 3; ++k) {
            CHECK(surface->carries_corner(i, k) == is_border(t[k]));
            n_edges += surface->carries_edge(i, k) ? 1 : 0;
        }
    }
    CHECK(n_edges == 4 * kN);
}

TEST_CASE("god surface: its rise along a direction beside a corner, an edge and inside a face") {
    const auto box = GodSurface::create(make_box({2.0, 2.0, 2.0}).value());
    for (std::int32_t i = 0; i < box->swept().n_triangles(); ++i) {
        const Triangle t = box->swept().triangle(i);
        const Vector3 inside = (t[0] + t[1] + t[2]) / 3.0;
        CHECK(box->find_rise_m(i, inside, Vector3::UnitX(), kEpsilon) == 0.0);
        for (std::size_t k = 0; k < 3; ++k) {
            // From a corner of a cube away from it the cube falls away; towards its middle it rises by the way to the next corner.
            const Vector3 out = t[k].normalized();
            CHECK(box->find_rise_m(i, t[k], out, kEpsilon) == 0.0);
            CHECK(box->find_rise_m(i, t[k], -out, kEpsilon) > 1.0);
            const Vector3 along_x(std::copysign(1.0, t[k].x()), 0.0, 0.0);
            CHECK(box->find_rise_m(i, t[k], along_x, kEpsilon) == 0.0);
            CHECK(box->find_rise_m(i, t[k], -along_x, kEpsilon) == Approx(2.0));
            const Vector3 middle = 0.5 * (t[k] + t[(k + 1) % 3]);
            CHECK(box->find_rise_m(i, middle, middle.normalized(), kEpsilon) < 1.0e-12);
        }
    }
}

TEST_CASE("god surface: a messy mesh touches where the sound one does, and where it is doubled") {
    const TriangleMesh sound = make_box({0.1, 0.2, 0.3}).value();
    const auto messy = GodSurface::create(make_messy(sound, 0.0).value());
    const auto whole = GodSurface::create(sound);
    CHECK(messy->swept().n_triangles() >= whole->swept().n_triangles());
    int n_carrying = 0;
    for (std::int32_t i = 0; i < messy->swept().n_triangles(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            n_carrying += messy->carries_corner(i, k) ? 1 : 0;
            const Vector3 corner = messy->swept().triangle(i)[k];
            CHECK(messy->find_rise_m(i, corner, corner.normalized(), kEpsilon) == 0.0);
        }
    }
    CHECK(n_carrying >= 36);
    CHECK(messy->memory_bytes() > whole->memory_bytes());
}

TEST_CASE("god surface: each corner and edge that touches is one triangle's own, messy or not") {
    const TriangleMesh ball = make_bumpy_sphere(0.1, 6, 0.1, 5.0).value();
    for (const TriangleMesh& mesh :
         {ball, make_box({0.1, 0.2, 0.3}).value(), make_plate(0.2, 0.2, 4).value(),
          make_messy(make_box({0.1, 0.2, 0.3}).value(), 0.0).value()}) {
        const auto surface = GodSurface::create(mesh);
        const auto key = [](const Vector3& v) { return std::tuple(v.x(), v.y(), v.z()); };
        std::map<std::tuple<double, double, double>, int> corners;
        std::map<std::tuple<double, double, double>, int> edges;
        for (std::int32_t i = 0; i < surface->swept().n_triangles(); ++i) {
            const Triangle t = surface->swept().triangle(i);
            for (std::size_t k = 0; k < 3; ++k) {
                // The sum of an edge's ends is the same from both sides.
                const Vector3 middle = t[k] + t[(k + 1) % 3];
                const bool owns_corner = (surface->own_corners(i) >> k & 1U) != 0;
                const bool owns_edge = (surface->own_edges(i) >> k & 1U) != 0;
                if (surface->carries_corner(i, k)) {
                    corners[key(t[k])] += owns_corner ? 1 : 0;
                } else {
                    CHECK_FALSE(owns_corner);
                }
                if (surface->carries_edge(i, k)) {
                    edges[key(middle)] += owns_edge ? 1 : 0;
                } else {
                    CHECK_FALSE(owns_edge);
                }
            }
        }
        CHECK(corners.size() >= 8);
        CHECK(edges.size() >= 12);
        CHECK(std::ranges::all_of(corners, [](const auto& each) { return each.second == 1; }));
        CHECK(std::ranges::all_of(edges, [](const auto& each) { return each.second == 1; }));
    }
}

TEST_CASE("god surface: it encloses what is inside, inside out or not, and nothing in its hollow") {
    const TriangleMesh ball = make_sphere(0.1, 6).value();
    const TriangleMesh inner = make_sphere(0.05, 4).value();
    const auto solid = GodSurface::create(ball);
    const auto inverted = GodSurface::create(make_inverted(ball).value());
    const auto hollow = GodSurface::create(make_hollow(ball, inner).value());
    const auto open = GodSurface::create(make_plate(0.2, 0.2, 4).value());
    Random random(4);
    for (int i = 0; i < 300; ++i) {
        const Vector3 at = 0.12 * random.in_cube();
        // The facets of a ball lie a little inside it.
        if (std::abs(at.norm() - 0.1) < 0.005 || std::abs(at.norm() - 0.05) < 0.005) {
            continue;
        }
        CHECK(solid->encloses(at) == (at.norm() < 0.1));
        CHECK(inverted->encloses(at) == (at.norm() < 0.1));
        CHECK(hollow->encloses(at) == (at.norm() < 0.1 && at.norm() > 0.05));
        CHECK_FALSE(open->encloses(at));
    }
    CHECK(solid->encloses(Vector3::Zero()));
}

TEST_CASE("god shading: facets are felt within a fifth of their error, at a tenth of their jumps") {
    const bool ball_is_tool = GENERATE(false, true);
    const double way = ball_is_tool ? -1.0 : 1.0;
    const TriangleMesh turned = test::move_corners(
        make_spike(), [&](const Vector3& v) { return Vector3(v.x(), way * v.y(), v.z()); });
    const auto draw = [&](bool shaded) {
        GodObjectTool tool = ball_is_tool ? make_tool(make_ball(), turned, {false, shaded})
                                          : make_tool(turned, make_ball(), {shaded, false});
        return draw_over(tool, ball_is_tool);
    };
    const Turns flat = draw(false);
    const Turns even = draw(true);
    CAPTURE(ball_is_tool, flat.most_jump, even.most_jump, flat.most_off, even.most_off,
            flat.rms_jump, even.rms_jump);
    CHECK(even.most_jump < 0.1 * flat.most_jump);
    CHECK(even.most_off < 0.2 * flat.most_off);
    CHECK(flat.most_jump > 0.02);
}

TEST_CASE("god shading: the way stays to the bit, and flat faces and creases push as they did") {
    const bool is_flat = GENERATE(false, true);
    const TriangleMesh object = is_flat ? make_box({0.3, 0.1, 0.3}).value() : make_ball();
    const TriangleMesh cube = test::make_cube(0.04);
    const auto handle_at = [&](int i) {
        // Flat, over the floor's edge, and on an edge of its own; or over the ball by all sides.
        return is_flat
                   ? Pose{Vector3(0.0004 * i, 0.066 + (i > 300 ? 0.004 : 0.0), 0.0),
                          compute_exp(Vector3(0.0, 0.0, i > 300 ? 0.3 : 0.0))}
                   : Pose{Vector3(0.03 * std::sin(0.01 * i), 0.068 - 0.004 * std::cos(0.003 * i),
                                  0.02 * std::sin(0.007 * i)),
                          compute_exp(Vector3(0.4 * std::sin(0.005 * i), 0.002 * i, 0.3))};
    };
    GodObjectTool shaded = make_tool(cube, object, {true, true});
    GodObjectTool plain = make_tool(cube, object, {});
    shaded.place(Pose::at({0.0, 0.08, 0.0}));
    plain.place(Pose::at({0.0, 0.08, 0.0}));
    double most_N = 0.0;
    for (int i = 0; i < (is_flat ? 600 : 1000); ++i) {
        const Wrench a = move_to(shaded, handle_at(i)).felt_W;
        const Wrench b = move_to(plain, handle_at(i)).felt_W;
        CAPTURE(is_flat, i);
        REQUIRE(shaded.pose_W().position == plain.pose_W().position);
        REQUIRE(shaded.pose_W().orientation.coeffs() == plain.pose_W().orientation.coeffs());
        REQUIRE_FALSE(test::do_enter(object, {}, cube, shaded.pose_W()));
        // Nothing is felt where nothing touches.
        REQUIRE((a.force.norm() > 0.0) == (b.force.norm() > 0.0));
        REQUIRE((!is_flat || (a.force - b.force).norm() < 1.0e-9));
        REQUIRE((!is_flat || (a.torque - b.torque).norm() < 1.0e-9));
        most_N = std::max(most_N, b.force.norm());
    }
    CHECK(most_N > 1.0);
}

TEST_CASE("god shading: an edge is even where both its triangles agree") {
    const TriangleMesh cylinder = make_cylinder(0.02, 0.1, 24).value();
    const auto shading = shade(cylinder, 30.0);
    int n_even = 0;
    int n_crease = 0;
    for (std::size_t t = 0; t < cylinder.triangles().size(); ++t) {
        const auto p = [&](std::size_t k) {
            return cylinder.vertices_B()[static_cast<std::size_t>(cylinder.triangles()[t][k % 3])];
        };
        const Vector3 normal = (p(1) - p(0)).cross(p(2) - p(0)).normalized();
        for (std::size_t k = 0; k < 3; ++k) {
            const Vector3 middle = 0.5 * (p(k) + p(k + 1));
            const bool on_rim = std::abs(std::abs(middle.y()) - 0.05) < 1.0e-9 &&
                                std::abs(std::hypot(middle.x(), middle.z()) -
                                         0.02 * std::cos(std::numbers::pi / 24.0)) < 1.0e-9;
            const bool even = shading->is_even(static_cast<std::int32_t>(t), k);
            REQUIRE(even != on_rim);
            n_even += even ? 1 : 0;
            n_crease += even ? 0 : 1;
            if (std::abs(normal.y()) < 0.5) {
                const Vector3 felt =
                    shading->normal_B(static_cast<std::int32_t>(t), middle, normal);
                CHECK(std::abs(felt.y()) < 1.0e-9);
            }
        }
    }
    CHECK(n_even > 48);
    CHECK(n_crease == 96);
}

TEST_CASE(
    "god shading: on an edge of the tool that is a crease the line between the features holds") {
    const TriangleMesh cylinder = make_cylinder(0.02, 0.1, 24).value();
    const auto shading = shade(cylinder, 30.0);
    int n_crease = 0;
    for (std::int32_t t = 0; t < shading->n_triangles(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto p = [&](std::size_t corner) {
                const TriangleCorners& of = cylinder.triangles()[static_cast<std::size_t>(t)];
                return cylinder.vertices_B()[static_cast<std::size_t>(of[corner % 3])];
            };
            const Vector3 normal = (p(1) - p(0)).cross(p(2) - p(0)).normalized();
            GodContact contact;
            contact.pair = FeaturePair::edge_edge;
            contact.tool_triangle = t;
            contact.tool_feature = static_cast<std::uint8_t>(k);
            contact.on_tool_O = 0.5 * (p(k) + p(k + 1));
            contact.normal_O = -(compute_exp(Vector3(0.15, 0.1, -0.05)) * normal);
            const Vector3 felt = find_felt_normal_O(nullptr, shading.get(), contact, {});
            const bool even = shading->is_even(t, k);
            CAPTURE(t, k, even);
            CHECK((felt == contact.normal_O) == !even);
            n_crease += even ? 0 : 1;
        }
    }
    CHECK(n_crease == 96);
}

TEST_CASE("god shading: angles out of range and another mesh's normals are refused") {
    const TriangleMesh ball = make_ball();
    CHECK_FALSE(GodShading::create(ball, {.on = true, .crease_angle_deg = -1.0}));
    CHECK_FALSE(GodShading::create(ball, {.on = true, .crease_angle_deg = std::nan("")}));
    GodObjectPlan plan{.object = GodSurface::create(ball),
                       .tool = GodSurface::create(make_spike())};
    plan.object_shading = shade(make_spike());
    CHECK_FALSE(GodObjectTool::build({plan}, test::make_god_settings(test::make_still_inertia())));
}
