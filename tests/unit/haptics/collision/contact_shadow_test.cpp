#include "haptics/collision/contact_shadow.h"

#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

namespace fulcrum {
namespace {

Shadow make_polygon(const std::vector<Shadow::Place>& corners, double height) {
    Shadow shadow;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        shadow.corners[i] = corners[i];
    }
    shadow.count = static_cast<int>(corners.size());
    shadow.height = height;
    return shadow;
}

Shadow make_rectangle(double x, double y, double half_x, double half_y) {
    return make_polygon({{x - half_x, y - half_y},
                         {x + half_x, y - half_y},
                         {x + half_x, y + half_y},
                         {x - half_x, y + half_y}},
                        0.0);
}

double find_area(const SharedCorners& shared) {
    double twice = 0.0;
    for (int i = 0; i < shared.count; ++i) {
        const auto& a = shared.corners[static_cast<std::size_t>(i)].at;
        const auto& b = shared.corners[static_cast<std::size_t>((i + 1) % shared.count)].at;
        twice += a.x * b.y - a.y * b.x;
    }
    return 0.5 * twice;
}

SharedCorners share(const Shadow& upper, const Shadow& lower) {
    SharedCorners shared;
    find_shared_corners(upper, lower, shared);
    return shared;
}

TEST_CASE("contact shadow: two rectangles share the rectangle of their overlap") {
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const double x = random.uniform();
        const double y = random.uniform();
        const SharedCorners shared =
            share(make_rectangle(x, y, 0.5, 0.7), make_rectangle(0.0, 0.0, 0.6, 0.4));
        const double width = std::min(0.6, x + 0.5) - std::max(-0.6, x - 0.5);
        const double depth = std::min(0.4, y + 0.7) - std::max(-0.4, y - 0.7);
        const double area = std::max(width, 0.0) * std::max(depth, 0.0);
        REQUIRE(find_area(shared) == Approx(area).margin(1.0e-8));
    }
}

TEST_CASE("contact shadow: two rectangles that are all but the same share the area of one") {
    for (const double off : {0.0, 1.0e-12, 1.0e-9, 1.0e-6, -1.0e-6}) {
        const SharedCorners shared =
            share(make_rectangle(off, -off, 0.5, 0.5), make_rectangle(0.0, 0.0, 0.5, 0.5));
        CHECK(shared.count >= 4);
        CHECK(find_area(shared) == Approx(1.0).margin(1.0e-5));
    }
    CHECK(share(make_rectangle(1.1, 0.0, 0.5, 0.5), make_rectangle(0.0, 0.0, 0.5, 0.5)).count == 0);
}

TEST_CASE("contact shadow: a segment is cut by a face, and heights are those of both") {
    Shadow segment = make_polygon({{-2.0, 0.1}, {2.0, 0.1}}, 1.0);
    segment.slope_x = 0.25;
    const Shadow face = make_rectangle(0.0, 0.0, 1.0, 0.5);
    const SharedCorners shared = share(segment, face);
    REQUIRE(shared.count == 2);
    CHECK(shared.corners[0].at.x == Approx(-1.0));
    CHECK(shared.corners[0].upper == Approx(0.75));
    CHECK(shared.corners[1].upper == Approx(1.25));
    CHECK(shared.corners[1].lower == 0.0);
    // The same with the face above.
    CHECK(share(face, segment).corners[1].lower == Approx(1.25));
    CHECK(share(make_polygon({{-2.0, 0.6}, {2.0, 0.6}}, 1.0), face).count == 0);
    CHECK(share(make_polygon({{0.0, 0.0}, {0.3, 0.2}}, 1.0), face).count == 2);
}

TEST_CASE("contact shadow: segments cross in one place, or share a stretch where parallel") {
    const Shadow along_x = make_polygon({{-1.0, 0.0}, {1.0, 0.0}}, 1.0);
    const SharedCorners crossing = share(along_x, make_polygon({{0.3, -1.0}, {0.3, 1.0}}, 0.0));
    REQUIRE(crossing.count == 1);
    CHECK(crossing.corners[0].at.x == Approx(0.3));
    const SharedCorners stretch = share(along_x, make_polygon({{2.0, 0.01}, {0.2, 0.0}}, 0.0));
    REQUIRE(stretch.count == 2);
    CHECK(std::abs(stretch.corners[0].at.x - stretch.corners[1].at.x) == Approx(0.8).margin(1e-3));
    CHECK(share(along_x, make_polygon({{2.0, 0.0}, {3.0, 0.0}}, 0.0)).count == 0);
}

TEST_CASE("contact shadow: of shadows that miss each other the nearest corner is told") {
    const Shadow segment = make_polygon({{-2.0, 0.50001}, {3.0, 0.50001}}, 1.0);
    Shadow face = make_polygon({{0.3, 0.5}, {-0.5, 0.2}, {0.4, -0.5}}, 0.25);
    REQUIRE(share(segment, face).count == 0);
    const SharedCorner nearest = find_nearest_corner(segment, face);
    CHECK(nearest.at.x == 0.3);
    CHECK(nearest.upper == 1.0);
    CHECK(nearest.lower == 0.25);
    CHECK(find_nearest_corner(face, segment).at.y == 0.5);
    const Shadow point = make_polygon({{1.0, 0.0}}, 0.0);
    CHECK(find_nearest_corner(point, make_rectangle(0.0, 0.0, 0.9, 0.9)).at.x == 1.0);
}

TEST_CASE("contact shadow: a place of the plane is over the place of the face that casts it") {
    Random random(2);
    for (int i = 0; i < 500; ++i) {
        SupportFeature feature;
        const Vector3 half(0.5, 0.3, 0.4);
        const auto box = make_contact_shape(BoxShape{half}).value();
        const Vector3 normal = random.direction();
        const Matrix3 turn = random.turn(3.0).toRotationMatrix();
        const Vector3 place = random.in_cube();
        const ShadowFrame frame = ShadowFrame::across(normal);
        REQUIRE(frame.u.cross(frame.v).dot(normal) == Approx(1.0));
        for (const double sign : {-1.0, 1.0}) {
            find_feature(box, turn.transpose() * (sign * normal), feature);
            Shadow shadow;
            make_shadow(feature, turn, place, frame, sign, shadow);
            double area = 0.0;
            for (std::size_t k = 0; k < 4; ++k) {
                const auto& at = shadow.corners[k];
                const Vector3 there =
                    at.x * frame.u + at.y * frame.v + shadow.height_over(at) * normal;
                const Vector3 corner = turn.transpose() * (there - place);
                REQUIRE((corner.cwiseAbs() - half).norm() < 1.0e-12);
                const auto& next = shadow.corners[(k + 1) % 4];
                area += at.x * next.y - at.y * next.x;
            }
            REQUIRE(area > 0.0);
        }
    }
}

TEST_CASE("contact shadow: a segment seen end on is its end, a face edge on its farthest corner") {
    SupportFeature feature;
    feature.corners_B[0] = {0.0, -1.0, 0.0};
    feature.corners_B[1] = {0.0, 1.0, 0.0};
    feature.count = 2;
    Shadow shadow;
    make_shadow(feature, Matrix3::Identity(), {0.0, 5.0, 0.0},
                ShadowFrame::across(Vector3::UnitY()), -1.0, shadow);
    CHECK(shadow.count == 1);
    CHECK(shadow.height == Approx(4.0));
    feature.corners_B[2] = {1.0, 0.0, 0.0};
    feature.count = 3;
    feature.normal_B = Vector3::UnitZ();
    make_shadow(feature, Matrix3::Identity(), Vector3::Zero(),
                ShadowFrame::across(Vector3::UnitY()), 1.0, shadow);
    CHECK(shadow.count == 1);
    CHECK(shadow.height == Approx(1.0));
}

TEST_CASE("contact shadow: edges that coincide to rounding share no corner outside both") {
    // Equal squares moved by as little as counts for the edge: each edge of one lies along one of the other.
    Random random(6);
    for (int i = 0; i < 20000; ++i) {
        const double part = 1.0e-9 * (1.0 + 1.0e-6 * random.uniform());
        const SharedCorners shared = share(
            make_rectangle(part * random.uniform(), part * (i % 2 == 0 ? 1.0 : -1.0), 0.5, 0.5),
            make_rectangle(0.0, 0.0, 0.5, 0.5));
        REQUIRE(find_area(shared) == Approx(1.0).margin(1.0e-6));
        for (int k = 0; k < shared.count; ++k) {
            const Shadow::Place& at = shared.corners[static_cast<std::size_t>(k)].at;
            REQUIRE(std::max(std::abs(at.x), std::abs(at.y)) <= 0.5 + 1.0e-8);
        }
    }
    // Turned a little against each other, about a corner that lies just outside.
    for (int i = 0; i < 20000; ++i) {
        const double turn = 2.0e-9 * random.uniform();
        const double away = 1.0e-9 * random.uniform();
        const SharedCorners shared =
            share(make_polygon({{-0.5 + turn * 0.5, -0.5 - turn * 0.5 - away},
                                {0.5 + turn * 0.5, -0.5 + turn * 0.5 - away},
                                {0.5 - turn * 0.5, 0.5 + turn * 0.5 - away},
                                {-0.5 - turn * 0.5, 0.5 - turn * 0.5 - away}},
                               0.0),
                  make_rectangle(0.0, 0.0, 0.5, 0.5));
        for (int k = 0; k < shared.count; ++k) {
            const Shadow::Place& at = shared.corners[static_cast<std::size_t>(k)].at;
            REQUIRE(std::max(std::abs(at.x), std::abs(at.y)) <= 0.5 + 1.0e-7);
        }
        REQUIRE(find_area(shared) == Approx(1.0).margin(1.0e-6));
    }
}

}  // namespace
}  // namespace fulcrum
