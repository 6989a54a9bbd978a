#include "haptics/collision/near_leaves.h"

#include "haptics/collision/triangle_gap.h"
#include "haptics/geometry/shape.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <set>

namespace fulcrum {
namespace {

constexpr double kBall = 0.1;

Box box_of(const Vector3& middle, double half) {
    return {middle - Vector3::Constant(half), middle + Vector3::Constant(half)};
}

std::set<std::int32_t> find_near_way(const NearLeaves& near, const Vector3& from,
                                     const Vector3& to) {
    std::set<std::int32_t> found;
    near.for_each_near_way(from, to, kBall, [&](std::int32_t triangle) { found.insert(triangle); });
    return found;
}

TEST_CASE("near leaves: as the cursor goes on they are those of the box, and few are loaded anew") {
    const auto mesh = touchable(make_bumpy_sphere(1.0, 20, 0.1, 6.0));
    NearLeaves near;
    CHECK_FALSE(near.covers(box_of(Vector3::UnitX(), 0.0)));
    Wanderer wanderer(2);
    std::uint64_t n_leaves = 0;
    constexpr int kSteps = 400;
    for (int i = 0; i < kSteps; ++i) {
        const Vector3 at = 1.1 * wanderer.next();
        const Box box = box_of(at, 0.15);
        REQUIRE(near.collect(*mesh, box));
        CHECK(near.covers(box));
        CHECK(near.covers(box_of(at, 0.14)));
        CHECK_FALSE(near.covers(box_of(at, 0.16)));
        NearLeaves fresh;
        REQUIRE(fresh.collect(*mesh, box));
        REQUIRE(std::equal(near.leaves().begin(), near.leaves().end(), fresh.leaves().begin(),
                           fresh.leaves().end()));
        const Vector3 to = at + 0.01 * wanderer.next();
        REQUIRE(find_near_way(near, at, to) == find_near_way(fresh, at, to));
        n_leaves += near.leaves().size();
    }
    CHECK(n_leaves > 10U * kSteps);
    CHECK(near.n_loads() < n_leaves / 5);
}

TEST_CASE("near leaves: every triangle that a ball meets on its way is told") {
    const auto mesh = touchable(make_bumpy_sphere(1.0, 16, 0.1, 6.0));
    Random random(8);
    NearLeaves near;
    int n_met = 0;
    for (int i = 0; i < 200; ++i) {
        const Vector3 from = (1.1 + 0.1 * random.uniform()) * random.direction();
        const Vector3 to = from + 0.05 * random.in_cube();
        REQUIRE(near.collect(*mesh, box_of(from, kBall + 0.06)));
        const std::set<std::int32_t> told = find_near_way(near, from, to);
        for (std::int32_t triangle = 0; triangle < mesh->n_triangles(); ++triangle) {
            const TriangleForGap prepared = prepare_for_gap(*mesh, triangle);
            if (find_triangle_gap(prepared, from).distance_m <= kBall ||
                find_triangle_gap(prepared, to).distance_m <= kBall) {
                REQUIRE(told.contains(triangle));
                ++n_met;
            }
        }
    }
    CHECK(n_met > 200);
}

TEST_CASE("near leaves: in a box all triangles are told that reach above the floors") {
    const auto mesh = touchable(make_bumpy_sphere(1.0, 16, 0.1, 6.0));
    Random random(14);
    NearLeaves near;
    int n_told = 0;
    int n_asked = 0;
    for (int i = 0; i < 50; ++i) {
        const Vector3 out = random.direction();
        const Box box = box_of(1.05 * out, 0.15);
        REQUIRE(near.collect(*mesh, box));
        const std::array<Floor, 2> floors{Floor{out, 1.02}, Floor{out.unitOrthogonal(), -0.05}};
        std::set<std::int32_t> told;
        near.for_each_in_box(box, floors, [&](std::int32_t triangle) { told.insert(triangle); });
        for (std::int32_t triangle = 0; triangle < mesh->n_triangles(); ++triangle) {
            const auto [a, b, c] = mesh->places_B(triangle);
            const Box own{a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
            bool is_asked = own.overlaps(box);
            for (const Floor& floor : floors) {
                const Vector3& up = floor.normal_B;
                is_asked = is_asked && std::max({up.dot(a), up.dot(b), up.dot(c)}) > floor.height_m;
            }
            REQUIRE((told.contains(triangle) || !is_asked));
            n_asked += is_asked ? 1 : 0;
        }
        n_told += static_cast<int>(told.size());
    }
    CHECK(n_asked > 200);
    CHECK(n_told < n_asked + 10);
}

TEST_CASE("near leaves: when they are too many none is covered, and the next box is as ever") {
    const auto mesh = touchable(make_sphere(1.0, 30));
    NearLeaves near;
    const Box small = box_of(Vector3::UnitX(), 0.1);
    REQUIRE(near.collect(*mesh, small));
    const std::size_t n = near.leaves().size();
    CHECK_FALSE(near.collect(*mesh, box_of(Vector3::Zero(), 2.0)));
    CHECK_FALSE(near.covers(small));
    REQUIRE(near.collect(*mesh, small));
    CHECK(near.leaves().size() == n);
    // Nothing had to be loaded again.
    CHECK(near.n_loads() == n);
    // A box beside the mesh has none, which is known.
    REQUIRE(near.collect(*mesh, box_of(Vector3(5.0, 0.0, 0.0), 0.1)));
    CHECK(near.leaves().empty());
    CHECK(find_near_way(near, Vector3(5.0, 0.0, 0.0), Vector3(5.0, 0.01, 0.0)).empty());
}

}  // namespace
}  // namespace fulcrum
