#include "haptics/collision/sampled_contacts.h"

#include "haptics/collision/sampled_shape.h"
#include "haptics/collision/shape_gap.h"
#include "haptics/geometry/height_field.h"
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
    [[nodiscard]] std::vector<ContactPoint> points() const {
        std::vector<ContactPoint> all;
        for (const ContactManifold& manifold : manifolds) {
            all.insert(all.end(), manifold.points().begin(), manifold.points().end());
        }
        return all;
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

std::shared_ptr<const SampledShape> sampled(const Expected<TriangleMesh>& mesh) {
    return sampled(SolidShape(touchable(mesh)));
}

TEST_CASE("sampled contacts: a mesh of a cube flat on a box touches at its four corners") {
    const auto cube = sampled(make_box({0.1, 0.1, 0.1}));
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
    const auto ring = sampled(make_torus(0.1, 0.03, 240, 120));
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
        for (const ContactManifold& manifold : used) {
            CHECK(manifold.normal_W.dot(normal) > 0.9);
        }
        const double least_m = std::ranges::min(found.points(), {}, &ContactPoint::gap_m).gap_m;
        // The mesh's chords lie up to 2e-5 m within, and the field's cells cut the bend by s^2 / 4 (1 / 0.03 + 1 / 0.13) = 7.5e-5 m.
        CHECK(least_m > 0.8e-4);
        CHECK(least_m < 1.95e-4);
    }
}

TEST_CASE("sampled contacts: edges that cross touch at the crossing") {
    const auto bar = sampled(make_box({0.3, 0.04, 0.04}));
    const auto other = sampled(BoxShape{{0.15, 0.02, 0.02}});
    const Quaternion on_edge(AngleAxis(0.25 * std::numbers::pi, Vector3::UnitX()));
    const Quaternion across(AngleAxis(0.5 * std::numbers::pi, Vector3::UnitY()));
    const double half_diagonal_m = 0.02 * std::numbers::sqrt2;
    const double gap_m = 1.0e-4;
    Patched found;
    // Neither's middle lies over the crossing.
    found.find(*bar, at({0.013, 2.0 * half_diagonal_m + gap_m, 0.0}, on_edge), *other,
               at({0.0, 0.0, 0.0071}, across * on_edge), 5.0e-4);
    const auto points = found.points();
    REQUIRE_FALSE(points.empty());
    const ContactPoint nearest = std::ranges::min(points, {}, &ContactPoint::gap_m);
    CHECK(std::abs(nearest.place_W.x()) < 1.0e-3);
    CHECK(std::abs(nearest.place_W.z()) < 1.0e-3);
    CHECK(nearest.gap_m == Approx(gap_m).margin(2.0e-4));
}

TEST_CASE("sampled contacts: what is held from several sides has a patch for each") {
    const auto channel = sampled(make_channel(0.1, 0.02, 0.3));
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
TEST_CASE("sampled contacts: edges touch slantwise beside each other, flush they touch upwards") {
    const auto cube = sampled(make_box({0.1, 0.1, 0.1}));
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
    const auto channel = sampled(make_channel(0.1, 0.02, 0.3));
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
    const auto cube = sampled(make_box({0.1, 0.1, 0.1}));
    const auto channel = sampled(make_channel(0.12, 0.02, 0.3));
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

TEST_CASE("sampled contacts: far away, places that are no numbers, and too few patches") {
    const auto cube = sampled(make_box({0.1, 0.1, 0.1}));
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
    const auto channel = sampled(make_channel(0.1, 0.02, 0.3));
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

TEST_CASE("sampled shape: round shapes and boxes have the distance of their closed forms") {
    Random random(4);
    const auto agrees = [&](const auto& shape) {
        const auto found = sampled(shape);
        CHECK_FALSE(found->is_mesh());
        for (int i = 0; i < 200; ++i) {
            const Vector3 p = 0.3 * random.in_cube();
            CHECK(found->at(p).gap_m == find_gap(shape, p).gap_m);
            CHECK(found->bound_m(p) == find_gap(shape, p).gap_m);
        }
        for (const SurfaceSample& sample : found->samples().all()) {
            CHECK(std::abs(found->at(sample.place_B).gap_m) < 4.0e-3);
        }
    };
    agrees(SphereShape{0.1});
    agrees(BoxShape{{0.1, 0.2, 0.05}});
    agrees(CapsuleShape{0.05, 0.1});
    agrees(CapsuleShape{0.05, 0.0});
    agrees(CylinderShape{0.1, 0.05});
}

TEST_CASE("sampled shape: a hull's is the height over its planes: exact inside, no more outside") {
    const BoxShape box{{0.1, 0.2, 0.05}};
    std::vector<Vector3> corners;
    for (int i = 0; i < 8; ++i) {
        corners.emplace_back((i & 1) != 0 ? 0.1 : -0.1, (i & 2) != 0 ? 0.2 : -0.2,
                             (i & 4) != 0 ? 0.05 : -0.05);
    }
    const auto hull = sampled(SolidShape(*make_hull_shape(corners)));
    Random random(5);
    for (int i = 0; i < 500; ++i) {
        const Vector3 p = 0.3 * random.in_cube();
        const double exact_m = find_gap(box, p).gap_m;
        const Gap gap = hull->at(p);
        CHECK(gap.gap_m <= exact_m + 1.0e-12);
        CHECK((gap.gap_m > 0.0) == (exact_m > 0.0));
        if (exact_m < 0.0) {
            CHECK(gap.gap_m == Approx(exact_m).margin(1.0e-12));
        }
    }
}

TEST_CASE("sampled shape: a mesh's is the distance field's near it, and a depth further within") {
    const auto ring = touchable(make_torus(0.1, 0.03, 96, 48));
    const auto shape = sampled(SolidShape(ring));
    CHECK(shape->is_mesh());
    const auto exact = [](const Vector3& p) {
        return std::hypot(std::hypot(p.x(), p.z()) - 0.1, p.y()) - 0.03;
    };
    Random random(6);
    int n_near = 0;
    for (int i = 0; i < 4000; ++i) {
        const Vector3 p = 0.13 * random.in_cube();
        const Gap gap = shape->at(p);
        CHECK(gap.normal_B.norm() == Approx(1.0));
        if (std::abs(exact(p)) < 0.004) {
            CHECK(gap.gap_m == Approx(exact(p)).margin(2.0e-4));
            ++n_near;
        }
        // Deep within the depth goes on: nothing is 0 there, and the way out is away from the ring's middle line.
        if (exact(p) < -0.01) {
            CHECK(gap.gap_m < -0.006);
        }
        if (exact(p) < -0.006 && exact(p) > -0.009) {
            const Vector3 middle = 0.1 * Vector3(p.x(), 0.0, p.z()) / std::hypot(p.x(), p.z());
            CHECK(gap.normal_B.dot((p - middle).normalized()) > 0.8);
        }
        CHECK(shape->bound_m(p) <= std::max(exact(p), 0.0) + 2.0e-4);
    }
    CHECK(n_near > 50);
}

TEST_CASE("sampled shape: open meshes, height fields and bad settings are refused in a sentence") {
    const auto told = [](const Expected<std::shared_ptr<const SampledShape>>& made) {
        return made ? std::string() : to_sentence(made.error());
    };
    CHECK(told(SampledShape::make(SolidShape(touchable(make_plate(1.0, 1.0, 2))))).find("open") !=
          std::string::npos);
    CHECK(told(SampledShape::make(SphereShape{}, {.n_cells = 100})).find("eights") !=
          std::string::npos);
    CHECK(told(SampledShape::make(SphereShape{}, {.n_cells = 1024})).find("512") !=
          std::string::npos);
    CHECK_FALSE(SampledShape::make(SphereShape{}, {.n_face_places = 1}));
    CHECK_FALSE(SampledShape::make(SphereShape{-1.0}));
    const auto ground = make_height_field_shape(HeightField{});
    REQUIRE(ground);
    CHECK(told(SampledShape::make(SolidShape(*ground))).find("height field") != std::string::npos);
}

}  // namespace
}  // namespace fulcrum
