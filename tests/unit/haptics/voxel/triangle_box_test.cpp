#include "haptics/voxel/triangle_box.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <random>

using fulcrum::overlaps_box;
using fulcrum::TrianglePoints;
using fulcrum::Vector3;

namespace {

const Vector3 kHalf{1.0, 1.0, 1.0};

bool touches_unit(const TrianglePoints& t) {
    return overlaps_box(t, Vector3::Zero(), kHalf);
}

TrianglePoints moved(const TrianglePoints& t, const Vector3& by) {
    return {t[0] + by, t[1] + by, t[2] + by};
}

// Cuts the triangle by the box's six planes; what remains is the part inside. Sutherland and Hodgman's way: independent of
// separating lines.
std::vector<Vector3> clip(const TrianglePoints& t, const Vector3& half) {
    std::vector<Vector3> polygon(t.begin(), t.end());
    for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
            std::vector<Vector3> kept;
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                const Vector3& a = polygon[i];
                const Vector3& b = polygon[(i + 1) % polygon.size()];
                const double da = half[axis] - sign * a[axis];
                const double db = half[axis] - sign * b[axis];
                if (da >= 0.0) {
                    kept.push_back(a);
                }
                if ((da >= 0.0) != (db >= 0.0)) {
                    kept.emplace_back(a + da / (da - db) * (b - a));
                }
            }
            polygon = kept;
        }
    }
    return polygon;
}

}  // namespace

TEST_CASE(
    "triangle and box: each of the thirteen lines separates, and a little nearer they touch") {
    struct Trial {
        TrianglePoints triangle;
        Vector3 away;  // by which it moves off
    };
    // A corner, an edge or a face of the triangle against one of the box, at the touch.
    const std::vector<Trial> trials{
        {{Vector3(1, 0, 0), Vector3(3, 1, 0), Vector3(3, 0, 1)}, {1, 0, 0}},
        {{Vector3(0, -1, 0), Vector3(1, -3, 0), Vector3(0, -3, 1)}, {0, -1, 0}},
        {{Vector3(0, 0, 1), Vector3(1, 0, 3), Vector3(0, 1, 3)}, {0, 0, 1}},
        // The plane x + y + z = 3 through the corner 1, 1, 1.
        {{Vector3(5, -1, -1), Vector3(-1, 5, -1), Vector3(-1, -1, 5)}, {1, 1, 1}},
        // An edge of the triangle against one of the box, along x, y and z.
        {{Vector3(0, 3, -1), Vector3(0.5, -1, 3), Vector3(0.2, 5, 5)}, {0, 1, 1}},
        {{Vector3(3, 0, -1), Vector3(-1, 0.5, 3), Vector3(5, 0.2, 5)}, {1, 0, 1}},
        {{Vector3(3, -1, 0), Vector3(-1, 3, 0.5), Vector3(5, 5, 0.2)}, {1, 1, 0}}};
    for (const Trial& trial : trials) {
        CHECK(touches_unit(trial.triangle));
        CHECK(touches_unit(moved(trial.triangle, -1.0e-3 * trial.away)));
        CHECK_FALSE(touches_unit(moved(trial.triangle, 1.0e-9 * trial.away)));
    }
}

TEST_CASE("triangle and box: agrees with cutting the triangle to the box") {
    std::mt19937 random(7);  // NOLINT(cert-msc51-cpp): the same each time
    std::uniform_real_distribution<double> place(-2.5, 2.5);
    int n_touching = 0;
    for (int i = 0; i < 20000; ++i) {
        TrianglePoints t;
        for (Vector3& corner : t) {
            corner = {place(random), place(random), place(random)};
        }
        const Vector3 half{0.3, 1.0, 0.7};
        const bool touching = !clip(t, half).empty();
        n_touching += touching ? 1 : 0;
        REQUIRE(overlaps_box(t, Vector3::Zero(), half) == touching);
        // Where box and triangle lie changes nothing.
        REQUIRE(overlaps_box(moved(t, {7.0, -3.0, 2.0}), {7.0, -3.0, 2.0}, half) == touching);
    }
    CHECK(n_touching > 3000);
    CHECK(n_touching < 17000);
}

TEST_CASE("triangle and box: a touch is never missed, however the numbers are rounded") {
    // A triangle that hangs by its corner on the box's face, far from the origin, at places that no double holds exactly.
    std::mt19937 random(11);  // NOLINT(cert-msc51-cpp): the same each time
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int i = 0; i < 20000; ++i) {
        const Vector3 centre = 1.0e3 * Vector3(unit(random), unit(random), unit(random));
        const Vector3 half = Vector3::Constant(1.0 / 3.0);
        const Vector3 corner = centre + Vector3(half.x(), 0.3 * unit(random), 0.3 * unit(random));
        const TrianglePoints t{corner, corner + Vector3(1.0, unit(random), unit(random)),
                               corner + Vector3(1.0, unit(random), unit(random))};
        REQUIRE(overlaps_box(t, centre, half));
    }
}

TEST_CASE("triangle and box: a triangle around the box, one inside, a segment and a point") {
    CHECK(touches_unit({Vector3(-9, -9, 0), Vector3(9, -9, 0), Vector3(0, 9, 0)}));
    CHECK(touches_unit({Vector3(0.1, 0, 0), Vector3(0, 0.1, 0), Vector3(0, 0, 0.1)}));
    CHECK(touches_unit({Vector3(-2, 0, 0), Vector3(2, 0, 0), Vector3(2, 0, 0)}));
    CHECK_FALSE(touches_unit({Vector3(-2, 2.5, 0), Vector3(2.5, -2, 3.5), Vector3(2.5, -2, 3.5)}));
    CHECK(touches_unit({Vector3(1, 1, 1), Vector3(1, 1, 1), Vector3(1, 1, 1)}));
    CHECK_FALSE(touches_unit({Vector3(1.1, 0, 0), Vector3(1.1, 0, 0), Vector3(1.1, 0, 0)}));
}

TEST_CASE("triangle and box: what is no number touches nothing") {
    const double nan = std::nan("");
    const double infinity = std::numeric_limits<double>::infinity();
    CHECK_FALSE(touches_unit({Vector3(nan, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1)}));
    CHECK_FALSE(touches_unit({Vector3(infinity, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1)}));
    CHECK_FALSE(overlaps_box({Vector3(0, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1)},
                             {0.0, nan, 0.0}, kHalf));
}
