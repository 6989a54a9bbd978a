#include "haptics/collision/sampled_contacts.h"

#include "haptics/geometry/shape.h"
#include "tests/support/hollow_meshes.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace fulcrum {
namespace {

struct Patched {
    std::array<ContactManifold, kMostPatches> manifolds{};

    void find(const SampledShape& a, const ContactPlace& at_a, const SampledShape& b,
              const ContactPlace& at_b, double margin_m = 1.0e-3, double size_m = 0.05) {
        std::array<ContactManifold*, kMostPatches> all{};
        for (std::size_t i = 0; i < all.size(); ++i) {
            all[i] = &manifolds[i];
        }
        find_sampled_contacts({a, at_a}, {b, at_b}, size_m, {.margin_m = margin_m}, all);
    }
    [[nodiscard]] std::vector<ContactManifold> used() const {
        std::vector<ContactManifold> with;
        std::ranges::copy_if(manifolds, std::back_inserter(with),
                             [](const ContactManifold& m) { return m.count > 0; });
        return with;
    }
};

std::shared_ptr<const SampledShape> sampled(const SolidShape& shape) {
    auto made = SampledShape::make(shape);
    REQUIRE(made);
    return *made;
}

ContactPlace at(const Vector3& position_W, const Quaternion& turn = Quaternion::Identity()) {
    return ContactPlace::of({position_W, turn});
}

TEST_CASE("sampled contacts: a mesh of a cube flat on a box touches at its four corners") {
    const auto cube = sampled(SolidShape(touchable(make_box({0.1, 0.1, 0.1}))));
    const auto table = sampled(BoxShape{{0.3, 0.05, 0.3}});
    const double gap_m = 2.0e-5;
    for (const bool is_first : {true, false}) {
        Patched found;
        const ContactPlace high = at({0.02, 0.1 + gap_m, -0.03});
        const ContactPlace low = at(Vector3::Zero());
        is_first ? found.find(*cube, high, *table, low) : found.find(*table, low, *cube, high);
        const auto used = found.used();
        REQUIRE(used.size() == 1);
        CHECK((used[0].normal_W - (is_first ? 1.0 : -1.0) * Vector3::UnitY()).norm() < 1.0e-4);
        REQUIRE(used[0].count == 4);
        std::set<std::pair<int, int>> corners;
        for (const ContactPoint& point : used[0].points()) {
            CHECK(point.gap_m == Approx(gap_m).margin(1.0e-7));
            CHECK(std::abs(point.place_W.x() - 0.02) == Approx(0.05).margin(1.0e-6));
            CHECK(std::abs(point.place_W.z() + 0.03) == Approx(0.05).margin(1.0e-6));
            CHECK(point.place_W.y() == Approx(0.05 + 0.5 * gap_m).margin(1.0e-6));
            corners.insert({point.place_W.x() > 0.02 ? 1 : 0, point.place_W.z() > -0.03 ? 1 : 0});
        }
        CHECK(corners.size() == 4);
    }
}

TEST_CASE("sampled contacts: round on round and round on flat touch where they do in closed form") {
    const auto ring = sampled(SolidShape(touchable(make_torus(0.1, 0.03, 240, 120))));
    const auto ball = sampled(SphereShape{0.02});
    Random random(3);
    for (int i = 0; i < 40; ++i) {
        // Over the tube at a chance place, 0.1 mm away.
        const double round = 3.2 * random.uniform();
        const double up = 3.2 * random.uniform();
        const Vector3 outwards(std::cos(round), 0.0, std::sin(round));
        const Vector3 normal = std::cos(up) * outwards + std::sin(up) * Vector3::UnitY();
        const Vector3 centre = 0.1 * outwards + (0.03 + 0.02 + 1.0e-4) * normal;
        Patched found;
        found.find(*ball, at(centre, random.turn(3.0)), *ring, at(Vector3::Zero()), 1.0e-3);
        const auto used = found.used();
        REQUIRE_FALSE(used.empty());
        double least_m = 1.0;
        for (const ContactManifold& manifold : used) {
            for (const ContactPoint& point : manifold.points()) {
                least_m = std::min(least_m, point.gap_m);
            }
            CHECK(manifold.normal_W.dot(normal) > 0.9);
        }
        // The mesh's chords lie up to 2e-5 m within, and the field's cells cut the bend by s^2 / 4 (1 / 0.03 + 1 / 0.13) = 7.5e-5 m.
        CHECK(least_m > 0.8e-4);
        CHECK(least_m < 1.95e-4);
    }
}

TEST_CASE("sampled contacts: edges that cross touch at the crossing") {
    const auto bar = sampled(SolidShape(touchable(make_box({0.3, 0.04, 0.04}))));
    const auto other = sampled(BoxShape{{0.15, 0.02, 0.02}});
    const Quaternion on_edge(AngleAxis(0.25 * std::numbers::pi, Vector3::UnitX()));
    const Quaternion across(AngleAxis(0.5 * std::numbers::pi, Vector3::UnitY()));
    const double half_diagonal_m = 0.02 * std::numbers::sqrt2;
    const double gap_m = 1.0e-4;
    Patched found;
    // Neither's middle lies over the crossing.
    found.find(*bar, at({0.013, 2.0 * half_diagonal_m + gap_m, 0.0}, on_edge), *other,
               at({0.0, 0.0, 0.0071}, across * on_edge), 5.0e-4);
    const auto used = found.used();
    REQUIRE_FALSE(used.empty());
    const ContactPoint* nearest = nullptr;
    for (const ContactManifold& manifold : used) {
        for (const ContactPoint& point : manifold.points()) {
            if (nearest == nullptr || point.gap_m < nearest->gap_m) {
                nearest = &point;
            }
        }
    }
    CHECK(std::abs(nearest->place_W.x()) < 1.0e-3);
    CHECK(std::abs(nearest->place_W.z()) < 1.0e-3);
    CHECK(nearest->gap_m == Approx(gap_m).margin(2.0e-4));
}

TEST_CASE("sampled contacts: what is held from several sides has a patch for each") {
    const auto channel = sampled(SolidShape(touchable(make_channel(0.1, 0.02, 0.3))));
    const auto ball = sampled(SphereShape{0.0499});
    Patched found;
    found.find(*ball, at({0.0, 0.02 + 0.0499, 0.01}), *channel, at(Vector3::Zero()), 5.0e-4);
    const auto used = found.used();
    REQUIRE(used.size() == 3);
    Vector3 sum = Vector3::Zero();
    for (const ContactManifold& manifold : used) {
        CHECK(std::max(std::abs(manifold.normal_W.x()), manifold.normal_W.y()) > 0.999);
        sum += manifold.normal_W;
        for (const ContactPoint& point : manifold.points()) {
            CHECK(std::abs(point.place_W.z() - 0.01) < 1.0e-2);
        }
    }
    CHECK((sum - Vector3::UnitY()).norm() < 1.0e-2);
}

// Beside each other's edges, a little out and a little up: the edges meet, and no face faces anything.
TEST_CASE("sampled contacts: edges beside each other touch slantwise, and no face does") {
    const auto cube = sampled(SolidShape(touchable(make_box({0.1, 0.1, 0.1}))));
    const auto table = sampled(BoxShape{{0.05, 0.05, 0.05}});
    constexpr double kApart_m = 2.0e-3;
    for (const double lean_rad : {0.0, 0.02, -0.02}) {
        CAPTURE(lean_rad);
        const Quaternion lean(AngleAxis(lean_rad, Vector3::UnitZ()));
        const Vector3 edge(0.05 + kApart_m, 0.05 + kApart_m, 0.0);
        Patched found;
        found.find(*cube, at(edge + lean * Vector3(0.05, 0.05, 0.0), lean), *table,
                   at(Vector3::Zero()), 0.012);
        const auto used = found.used();
        REQUIRE(used.size() == 1);
        CHECK(used[0].normal_W.dot(Vector3(1.0, 1.0, 0.0).normalized()) > 0.999);
        for (const ContactPoint& point : used[0].points()) {
            CHECK(point.gap_m == Approx(kApart_m * std::numbers::sqrt2).epsilon(0.02));
            CHECK(std::abs(point.place_W.x() - 0.05 - 0.5 * kApart_m) < 2.0e-4);
            CHECK(std::abs(point.place_W.y() - 0.05 - 0.5 * kApart_m) < 2.0e-4);
        }
    }
}

TEST_CASE("sampled contacts: what stands flush on its like touches upwards alone") {
    const auto cube = sampled(SolidShape(touchable(make_box({0.1, 0.1, 0.1}))));
    Random random(11);
    for (int i = 0; i < 20; ++i) {
        const Vector3 off = 2.0e-5 * random.in_cube();
        Patched found;
        found.find(*cube, at(Vector3(0.0, 0.1, 0.0) + off), *cube, at(Vector3::Zero()), 5.0e-4);
        const auto used = found.used();
        REQUIRE(used.size() == 1);
        CHECK(used[0].normal_W.y() > 0.9999);
        CHECK(used[0].count == 4);
    }
}

TEST_CASE("sampled contacts: a patch keeps its place whichever side is nearer") {
    const auto channel = sampled(SolidShape(touchable(make_channel(0.1, 0.02, 0.3))));
    const auto ball = sampled(SphereShape{0.0499});
    Patched found;
    std::array<Vector3, kMostPatches> first{};
    for (int i = 0; i < 40; ++i) {
        const double beside_m = 8.0e-5 * std::cos(0.7 * i);
        const double up_m = 8.0e-5 * std::sin(1.9 * i);
        found.find(*ball, at({beside_m, 0.02 + 0.05 + up_m, 0.01}), *channel, at(Vector3::Zero()),
                   5.0e-4);
        REQUIRE(found.used().size() == 3);
        for (std::size_t j = 0; j < 3; ++j) {
            first[j] = i == 0 ? found.manifolds[j].normal_W : first[j];
            REQUIRE(found.manifolds[j].normal_W.dot(first[j]) > 0.99);
        }
    }
}

TEST_CASE("sampled contacts: what trembles keeps its ids, and a patch its place") {
    const auto cube = sampled(SolidShape(touchable(make_box({0.1, 0.1, 0.1}))));
    const auto channel = sampled(SolidShape(touchable(make_channel(0.12, 0.02, 0.3))));
    Random random(9);
    Patched found;
    std::array<std::set<std::uint32_t>, kMostPatches> ids;
    for (int i = 0; i < 200; ++i) {
        const Vector3 place = Vector3(0.0, 0.07, 0.0) + 3.0e-6 * random.in_cube();
        found.find(*cube, at(place, random.turn(3.0e-6)), *channel, at(Vector3::Zero()), 5.0e-4);
        for (std::size_t j = 0; j < ids.size(); ++j) {
            for (const ContactPoint& point : found.manifolds[j].points()) {
                ids[j].insert(point.id);
            }
        }
    }
    CHECK(found.used().size() == 1);
    CHECK(ids[0].size() == 4);
    for (std::size_t j = 1; j < ids.size(); ++j) {
        CHECK(ids[j].empty());
    }
}

TEST_CASE(
    "sampled contacts: far away, places that are no numbers and fewer patches than are needed") {
    const auto cube = sampled(SolidShape(touchable(make_box({0.1, 0.1, 0.1}))));
    const auto ball = sampled(SphereShape{0.05});
    Patched found;
    found.find(*cube, at(Vector3::Zero()), *ball, at({0.0, 0.1, 0.0}));
    CHECK(found.used().size() == 1);
    found.find(*cube, at(Vector3::Zero()), *ball, at({0.0, 0.2, 0.0}));
    CHECK(found.used().empty());
    found.find(*cube, at(Vector3::Zero()), *ball, at({0.0, 0.1, 0.0}));
    CHECK_FALSE(found.used().empty());
    found.find(*cube, at({0.0, std::nan(""), 0.0}), *ball, at({0.0, 0.1, 0.0}));
    CHECK(found.used().empty());
    found.find(*cube, at(Vector3::Zero()), *ball, at({0.0, 0.1, 0.0}), std::nan(""));
    CHECK(found.used().empty());
    // Two patches for three sides: the third is in the one that is within 60 degrees, or in none.
    const auto channel = sampled(SolidShape(touchable(make_channel(0.1, 0.02, 0.3))));
    const auto tight = sampled(SphereShape{0.0499});
    std::array<ContactManifold, 2> two{};
    std::array<ContactManifold*, 2> places{&two[0], &two[1]};
    const ContactPlace at_ball = at({0.0, 0.0699, 0.0});
    const ContactPlace at_channel = at(Vector3::Zero());
    find_sampled_contacts({*tight, at_ball}, {*channel, at_channel}, 0.05, {.margin_m = 5.0e-4},
                          places);
    CHECK(two[0].count > 0);
    CHECK(two[1].count > 0);
}

}  // namespace
}  // namespace fulcrum
