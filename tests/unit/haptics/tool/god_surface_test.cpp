#include "haptics/tool/god_surface.h"

#include "haptics/geometry/shape.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace fulcrum {
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

TEST_CASE("god surface: a box touches with its edges, not with the diagonals of its faces") {
    const auto box = GodSurface::create(make_box({0.1, 0.2, 0.3}).value());
    // Twelve triangles: two of three edges, all corners.
    CHECK(count_carrying(*box).edges == 24);
    CHECK(count_carrying(*box).corners == 36);
}

TEST_CASE("god surface: within a flat plate nothing touches, round its border all does") {
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

}  // namespace
}  // namespace fulcrum
