#include "haptics/collision/segment_query.h"

#include "haptics/geometry/shape.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

namespace fulcrum {
namespace {

bool is_same(const SegmentHit& a, const SegmentHit& b) {
    return a.triangle == b.triangle && a.t == b.t;
}

Box box_of(const Vector3& centre, double half) {
    return {centre - Vector3::Constant(half), centre + Vector3::Constant(half)};
}

TEST_CASE("segment query: where and on which side, ends too; in a sheet's plane its rim") {
    const auto box = touchable(make_box(Vector3(2.0, 2.0, 2.0)));
    const SegmentHit outside = find_nearest_hit(*box, {0.3, 0.1, 4.0}, {0.3, 0.1, 0.0});
    CHECK(outside.t == Approx(0.75).epsilon(1e-15));
    CHECK(outside.side == 1);
    const SegmentHit inside = find_nearest_hit(*box, {0.3, 0.1, 0.0}, {0.3, 0.1, 4.0});
    CHECK(inside.t == Approx(0.25).epsilon(1e-15));
    CHECK(inside.side == -1);
    CHECK(inside.triangle == outside.triangle);
    CHECK_FALSE(find_nearest_hit(*box, {0.3, 0.1, 4.0}, {0.3, 0.1, 1.1}).found());
    CHECK_FALSE(find_nearest_hit(*box, {1.1, 0.1, 4.0}, {1.1, 0.1, -4.0}).found());
    CHECK(find_nearest_hit(*box, {0.3, 0.1, 2.0}, {0.3, 0.1, 1.0}).t == 1.0);
    CHECK(find_nearest_hit(*box, {0.3, 0.1, 1.0}, {0.3, 0.1, 2.0}).t == 0.0);
    CHECK(find_nearest_hit(*box, {0.3, 0.1, 1.0}, {0.3, 0.1, 1.0}).t == 0.0);
    CHECK(find_nearest_hit(*box, {1.0, 1.0, 1.0}, {2.0, 2.0, 2.0}).t == 0.0);
    CHECK_FALSE(find_nearest_hit(*box, {0.3, 0.1, 1.5}, {0.3, 0.1, 1.5}).found());
    const auto plate = touchable(make_plate(2.0, 2.0, 3));
    const SegmentHit rim = find_nearest_hit(*plate, {-3.0, 0.0, 0.1}, {1.0, 0.0, 0.1});
    CHECK(rim.t == Approx(0.5).epsilon(1e-14));
    CHECK(rim.side == 0);
    CHECK(find_nearest_hit(*plate, {0.1, 0.0, 0.2}, {0.3, 0.0, 0.2}).t == 0.0);
    CHECK_FALSE(find_nearest_hit(*plate, {-3.0, 0.0, 1.5}, {3.0, 0.0, 1.5}).found());
    CHECK_FALSE(find_nearest_hit(*plate, {-3.0, 0.0, 0.1}, {-1.5, 0.0, 0.1}).found());
    // Along the rim's own line, before its corner and past it.
    CHECK_FALSE(find_nearest_hit(*plate, {-3.0, 0.0, 1.0}, {-1.5, 0.0, 1.0}).found());
    CHECK(find_nearest_hit(*plate, {-3.0, 0.0, 1.0}, {3.0, 0.0, 1.0}).t ==
          Approx(1.0 / 3.0).epsilon(1e-14));
}

TEST_CASE("segment query: no segment slips out of a closed mesh, by corners and edges neither") {
    // From inside through each corner and through points of each edge, at directions that round differently.
    Random random(29);
    for (const double scale : {1e-4, 1.0, 1e4}) {
        const auto mesh = touchable(make_bumpy_sphere(scale, 6, 0.05, 9.0));
        for (int round = 0; round < 30000; ++round) {
            const auto triangle = static_cast<std::int32_t>(
                random.integer() % static_cast<std::uint64_t>(mesh->n_triangles()));
            const TriangleCorners& t = mesh->corners(triangle);
            const Vector3& a = mesh->vertex_B(t[random.integer() % 3]);
            const Vector3& b = mesh->vertex_B(t[random.integer() % 3]);
            const Vector3 target = a + (0.5 + 0.5 * random.uniform()) * (b - a);
            const Vector3 from = 0.15 * scale * random.in_cube();
            const Vector3 to = target + (target - from);
            const SegmentHit hit = find_nearest_hit(*mesh, from, to);
            REQUIRE(hit.found());
            REQUIRE(hit.side == -1);
            REQUIRE((from + hit.t * (to - from) - target).norm() <= 1e-9 * scale + 2.0 * scale);
        }
    }
}

TEST_CASE("segment query: triangles collected near a box answer as the tree, in it and out of it") {
    const auto mesh = touchable(make_bumpy_sphere(1.0, 16, 0.05, 9.0));
    Random random(31);
    NearbyTriangles nearby;
    int n_covered = 0;
    int n_hits = 0;
    for (int round = 0; round < 2000; ++round) {
        const Vector3 centre = random.direction();
        nearby.collect(*mesh, box_of(centre, 0.1));
        for (int i = 0; i < 20; ++i) {
            const Vector3 from = centre + 0.1 * random.in_cube();
            const Vector3 to = from + (i % 2 == 0 ? 0.1 : 1.5) * random.in_cube();
            if (!nearby.covers(from)) {
                continue;
            }
            ++n_covered;
            const double part = nearby.cover(from, to);
            const SegmentHit near =
                nearby.find_nearest_hit(*mesh, from, to, part, i % 3 == 0 ? 0.0 : 0.02);
            const SegmentHit all = find_nearest_hit(*mesh, from, to);
            if (all.t <= part) {
                ++n_hits;
                REQUIRE(is_same(near, all));
            } else {
                REQUIRE_FALSE(near.found());
            }
            // The part ends at the box: not before, not behind.
            const Vector3 end = from + part * (to - from);
            REQUIRE(nearby.covers(from + 0.999999 * (end - from)));
            REQUIRE((part == 1.0 || !nearby.covers(from + 1.000001 * (end - from))));
        }
    }
    CHECK(n_hits > 1000);
    CHECK(n_covered > 20000);
}

TEST_CASE("segment query: a way back and a way aside after a sweep are answered as by the tree") {
    // Within the last sweep's box its triangles are asked again; a little outside of it they are not enough.
    const auto mesh = touchable(make_bumpy_sphere(1.0, 24, 0.05, 9.0));
    Random random(37);
    const auto check = [&](NearbyTriangles& nearby, const Vector3& from, const Vector3& to) {
        if (!nearby.covers(from) || !nearby.covers(to)) {
            return 0;
        }
        const SegmentHit near = nearby.find_nearest_hit(*mesh, from, to, 1.0, 0.01);
        const SegmentHit all = find_nearest_hit(*mesh, from, to);
        REQUIRE(is_same(near, all));
        return all.found() ? 1 : 0;
    };
    int n_hits = 0;
    NearbyTriangles nearby;
    for (int round = 0; round < 4000; ++round) {
        const Vector3 centre = random.direction();
        nearby.collect(*mesh, box_of(centre, 0.1));
        const Vector3 from = centre + 0.05 * random.in_cube();
        const Vector3 to = centre + 0.05 * random.in_cube();
        n_hits += check(nearby, from, to);
        n_hits += check(nearby, 0.5 * (from + to), from);
        n_hits += check(nearby, from + 0.2 * (to - from), to);
        n_hits += check(nearby, 0.5 * (from + to), to + 0.05 * random.in_cube());
        n_hits += check(nearby, from, from + 0.7 * (to - from) + 0.01 * random.in_cube());
    }
    CHECK(n_hits > 2000);
}

TEST_CASE("segment query: the next triangles are collected ahead while the present ones serve") {
    const auto mesh = touchable(make_bumpy_sphere(1.0, 30, 0.05, 9.0));
    Random random(41);
    NearbyTriangles nearby;
    int n_hits = 0;
    int n_longest = 0;
    for (int round = 0; round < 500; ++round) {
        const Vector3 here = random.direction();
        const Vector3 next = here + 0.08 * random.direction();
        REQUIRE(nearby.collect(*mesh, box_of(here, 0.05)));
        nearby.begin_ahead(*mesh, box_of(next, 0.05));
        // Two nodes at a time: half as often as one at a time.
        NearbyTriangles one_by_one;
        one_by_one.begin_ahead(*mesh, box_of(next, 0.05));
        int n_nodes = 1;
        while (one_by_one.go_on_ahead(*mesh, 1) == Collecting::goes_on) {
            ++n_nodes;
        }
        int n_pairs = 0;
        Collecting collecting = Collecting::goes_on;
        while (collecting == Collecting::goes_on) {
            REQUIRE_FALSE(nearby.covers_ahead(next));
            ++n_pairs;
            REQUIRE(nearby.covers(here));
            const Vector3 from = here + 0.01 * random.direction();
            const Vector3 to = here - 0.02 * random.direction();
            REQUIRE(nearby.find_nearest_hit(*mesh, from, to, 1.0, 0.01).triangle ==
                    find_nearest_hit(*mesh, from, to).triangle);
            collecting = nearby.go_on_ahead(*mesh, 2);
            REQUIRE(nearby.is_collecting_ahead() == (collecting == Collecting::goes_on));
        }
        REQUIRE(collecting == Collecting::done);
        REQUIRE(n_pairs == (n_nodes + 1) / 2);
        n_longest = std::max(n_longest, n_nodes);
        // Done, it waits until it can answer further than the present one.
        REQUIRE(nearby.covers_ahead(next));
        REQUIRE(nearby.cover(here, here) == 1.0);
        REQUIRE(nearby.covers(here));
        REQUIRE(nearby.cover(next, next) == 1.0);
        REQUIRE(nearby.covers(next));
        const Vector3 from = next + 0.04 * random.direction();
        const Vector3 to = next - 0.04 * random.direction();
        const SegmentHit near = nearby.find_nearest_hit(*mesh, from, to, 1.0, 0.01);
        REQUIRE(near.triangle == find_nearest_hit(*mesh, from, to).triangle);
        n_hits += near.found() ? 1 : 0;
    }
    CHECK(n_hits > 50);
    CHECK(n_longest >= 4);
    // One that does not fit leaves the present ones in place.
    REQUIRE(nearby.collect(*mesh, box_of(Vector3::UnitX(), 0.05)));
    nearby.begin_ahead(*mesh, box_of(Vector3::Zero(), 2.0));
    CHECK(nearby.go_on_ahead(*mesh, 1000000) == Collecting::too_many);
    CHECK_FALSE(nearby.covers_ahead(Vector3::Zero()));
    CHECK(nearby.covers(Vector3::UnitX()));
}

TEST_CASE("segment query: more triangles around a sweep than can be remembered are all asked") {
    const auto mesh = touchable(make_bumpy_sphere(1.0, 24, 0.05, 9.0));
    Random random(43);
    NearbyTriangles nearby;
    int n_hits = 0;
    for (int round = 0; round < 300; ++round) {
        const Vector3 centre = random.direction();
        REQUIRE(nearby.collect(*mesh, box_of(centre, 0.08)));
        for (int i = 0; i < 10; ++i) {
            const Vector3 from = centre + 0.07 * random.in_cube();
            const Vector3 to = centre + 0.07 * random.in_cube();
            const SegmentHit near = nearby.find_nearest_hit(*mesh, from, to, 1.0, 0.07);
            const SegmentHit all = find_nearest_hit_brute_force(*mesh, from, to);
            REQUIRE(is_same(near, all));
            n_hits += all.found() ? 1 : 0;
        }
    }
    CHECK(n_hits > 500);
}

TEST_CASE("segment query: what is made ready around a sweep ends with the collected box") {
    const auto mesh = touchable(make_sphere(1.0, 80));
    Random random(47);
    NearbyTriangles nearby;
    for (int round = 0; round < 200; ++round) {
        const Vector3 here = random.direction();
        const Vector3 next = (here + 0.05 * here.cross(random.vector()).normalized()).normalized();
        REQUIRE(nearby.collect(*mesh, box_of(here, 0.004)));
        REQUIRE(nearby.find_nearest_hit(*mesh, 1.002 * here, 0.998 * here, 1.0, 0.06).found());
        REQUIRE(nearby.collect(*mesh, box_of(next, 0.004)));
        REQUIRE(nearby.find_nearest_hit(*mesh, 1.002 * next, 0.998 * next, 1.0, 0.06).triangle ==
                find_nearest_hit(*mesh, 1.002 * next, 0.998 * next).triangle);
    }
}

TEST_CASE("segment query: too many triangles for the near set leave the answer to the tree") {
    const auto mesh = touchable(make_sphere(1.0, 8));
    NearbyTriangles nearby;
    nearby.collect(*mesh, box_of(Vector3::Zero(), 2.0));
    CHECK_FALSE(nearby.covers(Vector3::Zero()));
}

}  // namespace
}  // namespace fulcrum
