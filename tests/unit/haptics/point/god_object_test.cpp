#include "haptics/point/god_object.h"

#include "haptics/geometry/shape.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace fulcrum {
namespace {

// The claim: positions are those of geometry to this part of the solid's size.
constexpr double kExact = 1.0e-9;

// One proxy on one solid of the given size, moved along straight lines.
class Hand {
  public:
    Hand(std::shared_ptr<const CollisionMesh> mesh, const Vector3& start_W, Pose pose_W = {})
        : pose_W_(pose_W),
          proxy_({SolidPlan{.body = 0, .shape = std::move(mesh), .initial_pose_W = pose_W}}),
          at_W_(start_W) {
        proxy_.reset(start_W);
    }
    const ProxyContact& go_to(const Vector3& to_W, int n_steps = 50) {
        const Vector3 from_W = at_W_;
        for (int i = 1; i <= n_steps; ++i) {
            at_W_ = i == n_steps ? to_W : Vector3(from_W + (to_W - from_W) * i / n_steps);
            proxy_.step(at_W_, std::span(&pose_W_, 1));
        }
        return proxy_.contact();
    }
    GodObject& proxy() { return proxy_; }
    void put_solid(const Pose& pose_W) { pose_W_ = pose_W; }

  private:
    Pose pose_W_;
    GodObject proxy_;
    Vector3 at_W_;
};

TEST_CASE("god object: in free space the proxy is the hand, to the bit") {
    Hand hand(touchable(make_box(Vector3::Ones())), Vector3(2.0, 0.1, 0.3));
    for (const Vector3& place :
         {Vector3(0.7, 0.7, 0.1), Vector3(-3.0, 0.9, 1e-7), Vector3(0.1, 0.5000001, 0.2)}) {
        const ProxyContact& contact = hand.go_to(place);
        CHECK(contact.position_W == place);
        CHECK(contact.solid == kNoBody);
        CHECK(contact.n_constraints == 0);
        CHECK(contact.normal_W == Vector3::Zero());
    }
}

TEST_CASE("god object: on a face the proxy is the foot of the perpendicular") {
    for (const double scale : {1e-4, 1.0, 1e4}) {
        Hand hand(touchable(make_box(scale * Vector3::Ones())), scale * Vector3(0.1, 0.9, -0.2));
        const ProxyContact& contact = hand.go_to(scale * Vector3(0.13, 0.3, -0.22));
        CHECK((contact.position_W - scale * Vector3(0.13, 0.5, -0.22)).norm() <= kExact * scale);
        CHECK(contact.solid == 0);
        CHECK(contact.n_constraints == 1);
        CHECK((contact.normal_W - Vector3::UnitY()).norm() < 1e-8);
        // Never below the face, not even by rounding.
        CHECK(contact.position_W.y() > 0.5 * scale);
    }
}

TEST_CASE("god object: inside a box, wall, edge and corner hold it at the analytic position") {
    for (const double scale : {1e-4, 1.0, 1e4}) {
        Hand hand(touchable(make_box(scale * Vector3(1.0, 2.0, 3.0))), Vector3::Zero());
        const auto expect = [&](const Vector3& wish, const Vector3& position, int n_constraints) {
            const ProxyContact& contact = hand.go_to(scale * wish);
            CHECK((contact.position_W - scale * position).norm() <= kExact * scale);
            CHECK(contact.n_constraints == n_constraints);
            CHECK((contact.normal_W - (position - wish).normalized()).norm() < 1e-7);
        };
        expect(Vector3(0.8, 0.1, 0.2), Vector3(0.5, 0.1, 0.2), 1);
        expect(Vector3(0.9, 1.3, -0.7), Vector3(0.5, 1.0, -0.7), 2);
        expect(Vector3(0.7, 1.2, 1.9), Vector3(0.5, 1.0, 1.5), 3);
        expect(Vector3(0.7, 0.2, 1.9), Vector3(0.5, 0.2, 1.5), 2);
        expect(Vector3(-0.7, -1.1, -1.6), Vector3(-0.5, -1.0, -1.5), 3);
        CHECK(hand.go_to(scale * Vector3(0.1, 0.2, 0.3)).n_constraints == 0);
    }
}

TEST_CASE("god object: a turned and moved box gives the turned and moved position") {
    const Pose pose{Vector3(0.7, -0.4, 1.2),
                    Quaternion(AngleAxis(1.1, Vector3(1.0, -2.0, 0.5).normalized()))};
    Hand hand(touchable(make_box(Vector3(1.0, 2.0, 3.0))), pose * Vector3::Zero(), pose);
    const ProxyContact& contact = hand.go_to(pose * Vector3(0.7, 1.2, 1.9));
    CHECK((contact.position_W - pose * Vector3(0.5, 1.0, 1.5)).norm() <= kExact);
    CHECK(contact.n_constraints == 3);
}

TEST_CASE(
    "god object: a concave edge holds it on its line, whatever the angle and however finely "
    "divided") {
    for (const double angle : {1.2, 0.5, 0.05, 1e-3}) {
        for (const int n : {1, 7, 200}) {
            Hand hand(touchable(make_trench(angle, n)), Vector3(0.2 * std::cos(angle), 0.7, -0.9));
            // Below the middle: on the line, wherever along it.
            for (const double z : {-0.5, 0.313, 0.8, -0.777}) {
                const ProxyContact& contact = hand.go_to(Vector3(0.05 * std::sin(angle), -0.4, z));
                INFO("angle " << angle << " strips " << n << " z " << z);
                // The clearance is kept over both slopes, so the line lies that much over sin(angle) higher and aside.
                CHECK((contact.position_W - Vector3(0.0, 0.0, z)).norm() <=
                      kExact * std::max(1.0, 1.0 / std::cos(angle)));
                CHECK(contact.n_constraints == 2);
            }
            // And lets go up the slope: foot of the perpendicular on the right one.
            const Vector3 wish(0.6 * std::cos(angle), 0.6 * std::sin(angle) - 0.1, 0.1);
            const Vector3 normal(-std::sin(angle), std::cos(angle), 0.0);
            const ProxyContact& contact = hand.go_to(wish, 200);
            CHECK((contact.position_W - (wish - normal.dot(wish) * normal)).norm() <= 2.0 * kExact);
        }
    }
}

TEST_CASE(
    "god object: a convex edge lets go when the foot leaves the first face, then the second takes "
    "over") {
    Hand hand(touchable(make_box(Vector3::Ones())), Vector3(0.0, 0.8, 0.1));
    hand.go_to(Vector3(0.0, 0.45, 0.1));
    // Nearer to the side x = 0.5 already, but the foot is on the top still: there it stays.
    CHECK((hand.go_to(Vector3(0.49, 0.45, 0.1)).position_W - Vector3(0.49, 0.5, 0.1)).norm() <=
          kExact);
    // Past the edge the hand is free.
    CHECK(hand.go_to(Vector3(0.51, 0.45, 0.1)).position_W == Vector3(0.51, 0.45, 0.1));
    // Back in from the side.
    CHECK((hand.go_to(Vector3(0.45, 0.4, 0.1)).position_W - Vector3(0.5, 0.4, 0.1)).norm() <=
          kExact);
}

TEST_CASE("god object: deep in a convex body the proxy goes round the edge to the nearer face") {
    // A roof whose ridge is shallow: from one slope over the ridge to the other, deep below both.
    auto vertices = make_trench(0.2, 9)->vertices_B();
    for (Vector3& vertex : vertices) {
        vertex.y() = -vertex.y();
    }
    const auto roof = touchable(TriangleMesh::build(vertices, make_trench(0.2, 9)->triangles()));
    Hand hand(roof, Vector3(-0.4, 0.5, 0.07));
    hand.go_to(Vector3(-0.4, -0.3, 0.07));
    const Vector3 wish(0.4, -0.3, 0.07);
    const ProxyContact& contact = hand.go_to(wish, 400);
    const Vector3 normal(std::sin(0.2), std::cos(0.2), 0.0);
    CHECK((contact.position_W - (wish - normal.dot(wish) * normal)).norm() <= kExact);
    CHECK(contact.n_constraints == 1);
}

TEST_CASE(
    "god object: the whole path scales with the world to the last bit: no tolerance is absolute") {
    const auto trace = [](double scale) {
        Hand hand(touchable(make_bumpy_sphere(scale, 20, 0.05, 12.0)),
                  scale * Vector3(1.3, 0.0, 0.0));
        std::vector<Vector3> path;
        for (int i = 0; i < 3000; ++i) {
            const double turn = 0.004 * i;
            const Vector3 wish = Vector3(std::cos(turn), std::sin(turn) * std::cos(0.3 * turn),
                                         std::sin(turn) * std::sin(0.3 * turn));
            path.push_back(hand.go_to(scale * (0.97 * wish), 1).position_W / scale);
        }
        return path;
    };
    const std::vector<Vector3> reference = trace(1.0);
    for (const int power : {-14, -40, 13, 40}) {  // 6e-5, 1e-12, 8e3 and 1e12 metres
        const std::vector<Vector3> scaled = trace(std::ldexp(1.0, power));
        for (std::size_t i = 0; i < reference.size(); ++i) {
            REQUIRE(scaled[i] == reference[i]);
        }
    }
}

TEST_CASE("god object: a sheet is solid from both sides, at any speed") {
    for (const double scale : {1e-4, 1.0, 1e4}) {
        const auto plate = touchable(make_plate(scale, scale, 11));
        for (const double side : {1.0, -1.0}) {
            for (const int n_steps : {1, 3, 1000}) {
                // Through faces, through corners of the grid and through the diagonals.
                for (const Vector3& at :
                     {Vector3(0.013, 0.0, -0.22), Vector3(0.5 / 11.0, 0.0, 0.5 / 11.0),
                      Vector3(1e-3, 0.0, 1e-3)}) {
                    Hand hand(plate, scale * (at + side * 0.4 * Vector3::UnitY()));
                    const ProxyContact& contact =
                        hand.go_to(scale * (at - side * 0.3 * Vector3::UnitY()), n_steps);
                    CHECK((contact.position_W - scale * at).norm() <= kExact * scale);
                    CHECK(side * contact.position_W.y() > 0.0);
                }
            }
        }
    }
}

TEST_CASE("god object: a plate that moves or turns through a still hand takes the proxy along") {
    const auto plate = touchable(make_plate(1.0, 1.0, 5));
    for (const double side : {1.0, -1.0}) {
        for (const double speed : {1e-3, 0.037, 0.5}) {
            const Vector3 still(0.1, 0.0, 0.07);
            Hand hand(plate, still, Pose{Vector3(0.0, -0.9 * side, 0.0), Quaternion::Identity()});
            for (double height = -0.9; height < 0.9; height += speed) {
                const Pose pose{Vector3(0.0, height * side, 0.0), Quaternion::Identity()};
                hand.put_solid(pose);
                const ProxyContact& contact = hand.go_to(still, 1);
                // Never on the plate's other side; free until it comes, on it after.
                REQUIRE(side * (contact.position_W.y() - pose.position.y()) > 0.0);
                const double expected = height < 0.0 ? 0.0 : side * height;
                REQUIRE((contact.position_W - Vector3(0.1, expected, 0.07)).norm() <= kExact);
            }
            CHECK(hand.proxy().n_squeezed() == 0);
        }
    }
}

TEST_CASE("god object: a turning plate sweeps the proxy round, in small and in large turns") {
    const auto plate = touchable(make_plate(2.0, 2.0, 3));
    for (const double turn_a_step : {0.003, 0.1, 0.7}) {
        const Vector3 still(0.5, 0.2, 0.03);
        Hand hand(plate, still);
        for (double turn = 0.0; turn < 1.5; turn += turn_a_step) {
            const Pose pose{Vector3::Zero(), Quaternion(AngleAxis(turn, Vector3::UnitZ()))};
            hand.put_solid(pose);
            const Vector3 in_plate = pose.inverse() * hand.go_to(still, 1).position_W;
            REQUIRE(in_plate.y() > 0.0);
            const Vector3 wish_in_plate = pose.inverse() * still;
            REQUIRE((in_plate - Vector3(wish_in_plate.x(), std::max(wish_in_plate.y(), 0.0),
                                        wish_in_plate.z()))
                        .norm() <= 2.0 * kExact);
        }
    }
}

TEST_CASE("god object: whichever structure finds the triangles, it goes the same way to the bit") {
    const auto mesh = touchable(make_bumpy_sphere(1.0, 12, 0.05, 9.0));
    GodObject by_tree(only_solid(mesh));
    GodObject by_grid(only_solid(mesh), SegmentStructureKind::h_collide);
    GodObject by_all(only_solid(mesh), SegmentStructureKind::brute_force);
    Random random(77);
    Vector3 hand(1.2, 0.0, 0.0);
    int n_touching = 0;
    for (GodObject* const proxy : {&by_tree, &by_grid, &by_all}) {
        proxy->reset(hand);
    }
    for (int i = 0; i < 3000; ++i) {
        hand = 0.98 * hand + 0.03 * random.vector();
        Pose pose;
        pose.position = 0.1 * Vector3(std::sin(0.01 * i), 0.0, 0.0);
        const Vector3 place = by_tree.step(hand, std::span(&pose, 1)).position_W;
        REQUIRE(by_grid.step(hand, std::span(&pose, 1)).position_W == place);
        REQUIRE(by_all.step(hand, std::span(&pose, 1)).position_W == place);
        n_touching += by_all.contact().solid == 0 ? 1 : 0;
    }
    CHECK(n_touching > 300);
}

TEST_CASE("god object: triangles are at hand from step to step, as often at any scale and speed") {
    std::array<std::uint64_t, 3> n_searches{};
    for (const double step_rad : {0.0004, 0.004}) {
        for (std::size_t i = 0; i < 3; ++i) {
            // Powers of two, so that the ways are the same but for the scale.
            const double scale = std::ldexp(1.0, 10 * (static_cast<int>(i) - 1));
            const auto mesh = touchable(make_sphere(scale, 32));
            GodObject proxy(only_solid(mesh));
            Wanderer wanderer(3, step_rad);
            proxy.reset(1.2 * scale * wanderer.next());
            for (int k = 0; k < 4000; ++k) {
                proxy.step(0.98 * scale * wanderer.next(), {});
            }
            n_searches[i] = proxy.n_searches();
        }
        CHECK(n_searches[0] == n_searches[1]);
        CHECK(n_searches[2] == n_searches[1]);
        CHECK(n_searches[1] > 0);
        CHECK(n_searches[1] < 200);
    }
}

}  // namespace
}  // namespace fulcrum
