#include "haptics/point/god_object.h"

#include "haptics/geometry/shape.h"
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

TEST_CASE("god object: the whole path scales to the last bit: no tolerance is absolute") {
    const auto trace = [](double scale) {
        GodObject proxy(only_solid(touchable(make_bumpy_sphere(scale, 20, 0.05, 12.0))));
        proxy.reset(scale * Vector3(1.3, 0.0, 0.0));
        std::vector<Vector3> path;
        for (int i = 0; i < 3000; ++i) {
            const double turn = 0.004 * i;
            const Vector3 wish = Vector3(std::cos(turn), std::sin(turn) * std::cos(0.3 * turn),
                                         std::sin(turn) * std::sin(0.3 * turn));
            path.push_back(proxy.step(scale * (0.97 * wish), {}).position_W / scale);
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

TEST_CASE("god object: a plate that moves or turns through a still hand takes the proxy along") {
    const auto plate = touchable(make_plate(1.0, 1.0, 5));
    for (const double side : {1.0, -1.0}) {
        for (const double speed : {1e-3, 0.037, 0.5}) {
            const Vector3 still(0.1, 0.0, 0.07);
            GodObject proxy(only_solid(plate, Pose::at(Vector3(0.0, -0.9 * side, 0.0))));
            proxy.reset(still);
            for (double height = -0.9; height < 0.9; height += speed) {
                const Pose pose = Pose::at(Vector3(0.0, height * side, 0.0));
                const ProxyContact& contact = proxy.step(still, std::span(&pose, 1));
                // Never on the plate's other side; free until it comes, on it after.
                REQUIRE(side * (contact.position_W.y() - pose.position.y()) > 0.0);
                const double expected = height < 0.0 ? 0.0 : side * height;
                REQUIRE((contact.position_W - Vector3(0.1, expected, 0.07)).norm() <= kExact);
            }
            CHECK(proxy.n_squeezed() == 0);
        }
    }
}

TEST_CASE("god object: a turning plate sweeps the proxy round, in small and in large turns") {
    const auto plate = touchable(make_plate(2.0, 2.0, 3));
    for (const double turn_a_step : {0.003, 0.1, 0.7}) {
        const Vector3 still(0.5, 0.2, 0.03);
        GodObject proxy(only_solid(plate));
        proxy.reset(still);
        for (double turn = 0.0; turn < 1.5; turn += turn_a_step) {
            const Pose pose{Vector3::Zero(), Quaternion(AngleAxis(turn, Vector3::UnitZ()))};
            const Vector3 in_plate =
                pose.inverse() * proxy.step(still, std::span(&pose, 1)).position_W;
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
