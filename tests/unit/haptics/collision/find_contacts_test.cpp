#include "haptics/collision/find_contacts.h"

#include "haptics/collision/contact_points.h"
#include "tests/support/contact_shapes.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace fulcrum {
namespace {

ContactShape make_cube(double half_m = 0.5) {
    return make_contact_shape(BoxShape{Vector3::Constant(half_m)}).value();
}
ContactManifold touch(const ContactShape& a, const Pose& at_a, const ContactShape& b,
                      const Pose& at_b, double margin_m = 0.01, ContactManifold manifold = {}) {
    find_contacts(a, ContactPlace::of(at_a), b, ContactPlace::of(at_b), margin_m, manifold);
    return manifold;
}
double find_least_gap(const ContactManifold& manifold) {
    double least = std::numeric_limits<double>::infinity();
    for (const ContactPoint& point : manifold.points()) {
        least = std::min(least, point.gap_m);
    }
    return least;
}
std::vector<std::uint32_t> ids_of(const ContactManifold& manifold) {
    std::vector<std::uint32_t> ids;
    for (const ContactPoint& point : manifold.points()) {
        ids.push_back(point.id);
    }
    std::ranges::sort(ids);
    return ids;
}
// Every old place has a new one there.
bool are_same_places(const ContactManifold& a, const ContactManifold& b, const Pose& move,
                     double within_m) {
    return a.count == b.count && std::ranges::all_of(a.points(), [&](const ContactPoint& point) {
               return std::ranges::any_of(b.points(), [&](const ContactPoint& other) {
                   return (move * point.place_W - other.place_W).norm() <= within_m &&
                          std::abs(point.gap_m - other.gap_m) <= within_m;
               });
           });
}

TEST_CASE("contact manifold: a cube on an equal cube touches at its four corners") {
    const ContactShape cube = make_cube();
    const auto manifold = touch(cube, Pose::at({0.0, 0.999, 0.0}), cube, Pose::at(Vector3::Zero()));
    REQUIRE(manifold.count == 4);
    CHECK(manifold.normal_W == Vector3::UnitY());
    for (const ContactPoint& point : manifold.points()) {
        CHECK(point.gap_m == Approx(-0.001));
        CHECK(std::abs(point.place_W.x()) == Approx(0.5));
        CHECK(std::abs(point.place_W.z()) == Approx(0.5));
        CHECK(point.place_W.y() == Approx(0.4995));
    }
}

TEST_CASE("contact manifold: a cube turned by an eighth keeps the four corners of most area") {
    const ContactShape cube = make_cube();
    const Pose turned{{0.0, 1.0, 0.0}, Quaternion(AngleAxis(M_PI / 4, Vector3::UnitY()))};
    const auto manifold = touch(cube, turned, cube, Pose::at(Vector3::Zero()));
    REQUIRE(manifold.count == 4);
    double twice_area = 0.0;
    for (const ContactPoint& a : manifold.points()) {
        CHECK(std::hypot(a.place_W.x(), a.place_W.z()) == Approx(0.5 / std::cos(M_PI / 8)));
        for (const ContactPoint& b : manifold.points()) {
            twice_area = std::max(twice_area, (a.place_W - b.place_W).norm());
        }
    }
    CHECK(twice_area == Approx(1.0 / std::cos(M_PI / 8)));
}

TEST_CASE("contact manifold: every shape on the ground, standing and lying") {
    const ContactShape ground = make_half_space();
    const Pose floor = Pose::at(Vector3::Zero());
    const Quaternion lying(AngleAxis(M_PI / 2, Vector3::UnitX()));
    const auto capsule = make_contact_shape(CapsuleShape{0.1, 0.4}).value();
    CHECK(touch(capsule, Pose::at({0.0, 0.5, 0.0}), ground, floor).count == 1);
    const auto lies = touch(capsule, {{0.0, 0.099, 0.0}, lying}, ground, floor);
    REQUIRE(lies.count == 2);
    CHECK(lies.contacts[0].gap_m == Approx(-0.001));
    CHECK(std::abs(lies.contacts[0].place_W.z() - lies.contacts[1].place_W.z()) == Approx(0.8));
    const auto cylinder = make_contact_shape(CylinderShape{0.2, 0.3}).value();
    const auto stands = touch(cylinder, Pose::at({0.0, 0.3, 0.0}), ground, floor);
    REQUIRE(stands.count == 4);
    CHECK(stands.contacts[0].place_W.y() == Approx(0.0).margin(1.0e-12));
    CHECK(touch(cylinder, {{0.0, 0.2, 0.0}, lying}, ground, floor).count == 2);
    const Quaternion tilted(AngleAxis(0.3, Vector3::UnitX()));
    CHECK(touch(cylinder, {{0.0, 0.3 * std::cos(0.3) + 0.2 * std::sin(0.3), 0.0}, tilted}, ground,
                floor, 1.0e-3)
              .count == 1);
    const auto sphere = make_contact_shape(SphereShape{0.2}).value();
    const auto ball = touch(sphere, Pose::at({1.0, 0.19, 2.0}), ground, floor);
    REQUIRE(ball.count == 1);
    CHECK(ball.contacts[0].gap_m == Approx(-0.01));
    CHECK((ball.contacts[0].place_W - Vector3(1.0, -0.005, 2.0)).norm() < 1.0e-12);
    // Under a ceiling: the same turned over.
    const auto above = touch(ground, floor, sphere, Pose::at({1.0, 0.19, 2.0}));
    CHECK(above.normal_W == -Vector3::UnitY());
    CHECK((above.contacts[0].place_W - ball.contacts[0].place_W).norm() < 1.0e-12);
    CHECK(touch(ground, floor, ground, floor).count == 0);
}

TEST_CASE("contact manifold: crossed edges, a corner on a face, a rod over an edge: one place") {
    const ContactShape cube = make_cube();
    const double reach_m = std::sqrt(0.5);
    const Pose about_x{{0.1, 2.0 * reach_m - 0.001, 0.2},
                       Quaternion(AngleAxis(M_PI / 4, Vector3::UnitX()))};
    const Pose about_z{Vector3::Zero(), Quaternion(AngleAxis(M_PI / 4, Vector3::UnitZ()))};
    const auto edges = touch(cube, about_x, cube, about_z, 1.0e-3);
    // Within the margin the crossing alone, or with it places that are as near.
    REQUIRE(edges.count >= 1);
    CHECK(find_least_gap(edges) == Approx(-0.001));
    const auto& deepest = *std::ranges::min_element(edges.points(), {}, &ContactPoint::gap_m);
    CHECK((deepest.place_W - Vector3(0.0, reach_m - 0.0005, 0.2)).norm() < 1.0e-9);
    const Quaternion on_corner =
        Quaternion::FromTwoVectors(Vector3(1.0, 1.0, 1.0), Vector3(0.0, -1.0, 0.0));
    const auto corner = touch(cube, {{0.1, 0.5 + std::sqrt(0.75) - 0.001, 0.1}, on_corner}, cube,
                              Pose::at(Vector3::Zero()), 1.0e-3);
    REQUIRE(corner.count >= 1);
    CHECK(find_least_gap(corner) == Approx(-0.001));
    const auto capsule = make_contact_shape(CapsuleShape{0.1, 1.0}).value();
    const Pose over{{0.0, reach_m + 0.099, 0.2}, Quaternion(AngleAxis(M_PI / 2, Vector3::UnitZ()))};
    const auto line = touch(capsule, over, cube, about_z, 1.0e-3);
    REQUIRE(line.count >= 1);
    CHECK(find_least_gap(line) == Approx(-0.001));
}

TEST_CASE("contact manifold: the deepest of its points is as deep as the bodies, whatever pair") {
    const auto shapes = make_contact_shapes(1.0);
    Random random(11);
    for (const ContactShape& first : shapes) {
        for (const ContactShape& second : shapes) {
            for (int i = 0; i < 60; ++i) {
                const Pose a{(0.2 + 0.012 * i) * random.direction(), random.turn(3.0)};
                const Pose b{Vector3::Zero(), random.turn(3.0)};
                const ContactManifold manifold = touch(first, a, second, b, 0.02);
                const PlacedShape pa{&first, a.orientation.toRotationMatrix(), a.position};
                const PlacedShape pb{&second, b.orientation.toRotationMatrix(), b.position};
                const ContactAxis axis = find_contact_axis(pa, pb, 0.02, 0);
                INFO("kinds " << static_cast<int>(first.kind) << ' '
                              << static_cast<int>(second.kind) << ", gap " << axis.gap_m
                              << ", axis " << axis.which);
                REQUIRE((manifold.count > 0) == (axis.gap_m <= 0.02));
                if (manifold.count > 0) {
                    // A face's shadow ends at its corners; an end of a cylinder that is all but level falls short of its circle by 2 %.
                    REQUIRE(find_least_gap(manifold) >= axis.gap_m - 1.0e-6);
                    REQUIRE(find_least_gap(manifold) <= axis.gap_m + 0.02);
                }
            }
        }
    }
}

TEST_CASE("contact manifold: turned over, moved and made larger it is the same") {
    const auto shapes = make_contact_shapes(1.0);
    Random random(12);
    for (const ContactShape& first : shapes) {
        for (const ContactShape& second : shapes) {
            for (int i = 0; i < 10; ++i) {
                const Pose a{0.75 * random.direction(), random.turn(3.0)};
                const Pose b{Vector3::Zero(), random.turn(3.0)};
                const ContactManifold here = touch(first, a, second, b, 0.02);
                const Pose move{10.0 * random.in_cube(), random.turn(3.0)};
                const ContactManifold there = touch(first, move * a, second, move * b, 0.02);
                INFO("kinds " << static_cast<int>(first.kind) << ' '
                              << static_cast<int>(second.kind));
                REQUIRE((here.count > 0) == (there.count > 0));
                if (here.count == 0) {
                    continue;
                }
                if (there.normal_W.dot(move.orientation * here.normal_W) > 1.0 - 1.0e-14) {
                    // The direction agrees to 1e-7, and a crossing at a flat angle moves by twenty times that.
                    REQUIRE(are_same_places(here, there, move, 1.0e-5));
                } else {
                    // As good a direction was nearer to being taken.
                    REQUIRE(find_least_gap(there) == Approx(find_least_gap(here)).margin(0.02));
                }
            }
        }
    }
    const ContactShape cube = make_cube();
    for (const double size : {1.0e-3, 1.0e3}) {
        const ContactShape scaled = make_cube(0.5 * size);
        const auto small = touch(scaled, Pose::at(size * Vector3(0.3, 0.99, 0.2)), scaled,
                                 Pose::at(Vector3::Zero()), 0.01 * size);
        const auto plain = touch(cube, Pose::at({0.3, 0.99, 0.2}), cube, Pose::at(Vector3::Zero()));
        REQUIRE(small.count == plain.count);
        for (int i = 0; i < 4; ++i) {
            const auto k = static_cast<std::size_t>(i);
            CHECK((small.contacts[k].place_W / size - plain.contacts[k].place_W).norm() < 1.0e-9);
            CHECK(small.contacts[k].gap_m / size == Approx(plain.contacts[k].gap_m));
        }
    }
    for (const Vector3& apart : {Vector3(0.3, 0.99, 0.2), Vector3(0.0, 0.99, 0.0)}) {
        const auto one = touch(cube, Pose::at(apart), cube, Pose::at(Vector3::Zero()));
        const auto other = touch(cube, Pose::at(Vector3::Zero()), cube, Pose::at(apart));
        CHECK(one.normal_W == -other.normal_W);
        CHECK(are_same_places(one, other, Pose{}, 1.0e-12));
    }
}

TEST_CASE("contact manifold: bodies that tremble by a millionth at rest keep points and ids") {
    Random random(13);
    auto shapes = make_contact_shapes(1.0);
    shapes.push_back(make_cube());
    const ContactShape ground = make_half_space();
    const Pose below = Pose::at({0.0, -0.5, 0.0});
    const ContactShape floor_box = make_contact_shape(BoxShape{{2.0, 0.5, 2.0}}).value();
    const ContactShape cube = make_cube();
    for (const ContactShape& shape : shapes) {
        // Resting on its face that looks down.
        const double height_m =
            -shape.core.find_support(-Vector3::UnitY()).y() + shape.core.radius_m;
        for (const auto* floor : {&floor_box, &cube, &ground}) {
            const Pose floor_at = floor == &ground ? Pose{} : below;
            ContactManifold manifold =
                touch(shape, Pose::at({0.0, height_m, 0.0}), *floor, floor_at, 1.0e-3);
            const auto ids = ids_of(manifold);
            const std::int32_t axis = manifold.which_axis;
            REQUIRE_FALSE(ids.empty());
            for (int i = 0; i < 500; ++i) {
                const Pose at{Vector3(0.0, height_m, 0.0) + 1.0e-6 * random.in_cube(),
                              random.turn(1.0e-6)};
                manifold = touch(shape, at, *floor, floor_at, 1.0e-3, manifold);
                REQUIRE(ids_of(manifold) == ids);
                REQUIRE(manifold.which_axis == axis);
            }
        }
    }
}

TEST_CASE("contact manifold: a box that slides and turns on another keeps ids, each but once") {
    const ContactShape cube = make_cube();
    ContactManifold manifold;
    std::uint32_t n_lost = 0;
    for (int i = 0; i < 400; ++i) {
        const Pose at{{0.001 * i, 1.0, 0.0005 * i},
                      Quaternion(AngleAxis(0.0005 * i, Vector3::UnitY()))};
        const auto before = ids_of(manifold);
        manifold = touch(cube, at, cube, Pose::at(Vector3::Zero()), 0.01, manifold);
        const auto now = ids_of(manifold);
        REQUIRE(std::set<std::uint32_t>(now.begin(), now.end()).size() == now.size());
        REQUIRE(manifold.count == 4);
        for (const std::uint32_t id : before) {
            n_lost += std::ranges::count(now, id) == 0 ? 1U : 0U;
        }
    }
    // Corners pass from one edge to another now and then.
    CHECK(n_lost <= 8);
}

TEST_CASE("contact manifold: middles in one place, slivers of hulls, and places that are none") {
    const auto shapes = make_contact_shapes(1.0);
    for (const ContactShape& first : shapes) {
        for (const ContactShape& second : shapes) {
            const auto manifold = touch(first, Pose{}, second, Pose{});
            REQUIRE(manifold.count >= 1);
            CHECK(find_least_gap(manifold) < -0.4);
            CHECK(manifold.normal_W.norm() == Approx(1.0));
        }
        Pose nowhere;
        nowhere.position.x() = std::nan("");
        CHECK(touch(first, nowhere, shapes[2], Pose{}).count == 0);
        CHECK(touch(shapes[2], Pose{}, first, nowhere).count == 0);
    }
    const std::vector<Vector3> thin{
        {0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 1e-7, 1}, {0.5, -1e-7, 0.5}};
    const auto sliver = make_contact_shape(make_hull_shape(thin).value()).value();
    const ContactShape cube = make_cube();
    const auto lies = touch(sliver, Pose::at({-0.5, 0.5, -0.5}), cube, Pose{}, 0.001);
    REQUIRE(lies.count >= 3);
    CHECK(lies.normal_W.y() == Approx(1.0));
    CHECK(find_least_gap(lies) == Approx(0.0).margin(1.0e-5));
}

ContactManifold choose(const std::vector<Vector3>& places) {
    ContactCandidates candidates;
    for (std::size_t i = 0; i < places.size(); ++i) {
        candidates.add({places[i], -1.0e-4, static_cast<std::uint16_t>(i)});
    }
    const ContactPlace here;
    ContactManifold manifold;
    choose_contacts(candidates, Vector3::UnitY(), 0.1, {Vector3::Zero(), here, here}, manifold);
    return manifold;
}

TEST_CASE("contact points: few are kept, far apart, each once, on a line and round a face") {
    std::vector<Vector3> places;
    for (const double x_m : {0.0, 0.02, 0.05, 0.03, 0.04}) {
        places.push_back({x_m, 0.0, 2.0 * x_m});
    }
    const ContactManifold manifold = choose(places);
    REQUIRE(manifold.count == 2);
    CHECK(std::abs(manifold.contacts[0].place_W.x() - manifold.contacts[1].place_W.x()) >= 0.03);
    places.clear();
    for (int i = 0; i < 8; ++i) {
        places.push_back(0.05 * Vector3(std::cos(0.7854 * i), 0.0, std::sin(0.7854 * i)));
    }
    const ContactManifold round_face = choose(places);
    REQUIRE(round_face.count == 4);
    std::set<std::uint16_t> features;
    for (const ContactPoint& point : round_face.points()) {
        features.insert(point.feature);
    }
    CHECK(features.size() == 4);
}

}  // namespace
}  // namespace fulcrum
