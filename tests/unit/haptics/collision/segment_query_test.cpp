#include "haptics/collision/segment_query.h"

#include "haptics/geometry/shape.h"

#include <catch2/catch.hpp>

#include <random>

namespace fulcrum {
namespace {

std::shared_ptr<const CollisionMesh> make_collision_mesh(Expected<TriangleMesh> mesh) {
    REQUIRE(mesh);
    auto made = CollisionMesh::create(std::move(*mesh));
    REQUIRE(made);
    return *made;
}

// Draws segments of every kind: long, short, and ending or passing exactly at corners and on edges.
class SegmentSource {
  public:
    SegmentSource(const CollisionMesh& mesh, double scale) : mesh_(mesh), scale_(scale) {}

    std::pair<Vector3, Vector3> draw() {
        const Vector3 from = scale_ * 1.3 * random_vector();
        switch (kind_++ % 6) {
            case 0:
                return {from, scale_ * 1.3 * random_vector()};
            case 1:
                return {from, from + 0.05 * scale_ * random_vector()};
            case 2:
                return {from, random_corner()};
            case 3: {
                const Vector3 corner = random_corner();
                return {corner - 0.5 * (from - corner), from};
            }
            case 4: {
                const TriangleCorners& t = random_triangle();
                const Vector3 middle = 0.5 * (mesh_.vertex_B(t[0]) + mesh_.vertex_B(t[1]));
                return {from, middle + (middle - from)};
            }
            default:
                return {random_corner(), random_corner()};
        }
    }

  private:
    Vector3 random_vector() { return Vector3(unit_(random_), unit_(random_), unit_(random_)); }
    const TriangleCorners& random_triangle() {
        return mesh_.corners(
            static_cast<std::int32_t>(random_() % static_cast<std::uint64_t>(mesh_.n_triangles())));
    }
    Vector3 random_corner() { return mesh_.vertex_B(random_triangle()[random_() % 3]); }

    const CollisionMesh& mesh_;
    double scale_;
    unsigned kind_ = 0;
    std::mt19937_64 random_{17};
    std::uniform_real_distribution<double> unit_{-1.0, 1.0};
};

void check_same_hits(const CollisionMesh& mesh, double scale, int n_segments) {
    SegmentSource source(mesh, scale);
    int n_hits = 0;
    for (int i = 0; i < n_segments; ++i) {
        const auto [from, to] = source.draw();
        const SegmentHit quick = find_nearest_hit(mesh, from, to);
        const SegmentHit slow = find_nearest_hit_brute_force(mesh, from, to);
        REQUIRE(quick.triangle == slow.triangle);
        REQUIRE(quick.t == slow.t);
        REQUIRE(quick.side == slow.side);
        n_hits += quick.found() ? 1 : 0;
    }
    CHECK(n_hits > n_segments / 2);
    CHECK(n_hits < n_segments);
}

TEST_CASE("segment query: the tree finds the same hits as brute force on 180 000 segments") {
    check_same_hits(*make_collision_mesh(make_bumpy_sphere(1.0, 5, 0.1, 7.0)), 1.0, 60000);
    check_same_hits(*make_collision_mesh(make_bumpy_sphere(1e-4, 4, 0.1, 7.0)), 1e-4, 30000);
    check_same_hits(*make_collision_mesh(make_torus(8e3, 2e3, 24, 12)), 1e4, 30000);
    check_same_hits(*make_collision_mesh(make_globe(1.0, 24, 12)), 1.0, 30000);
    check_same_hits(*make_collision_mesh(make_box(Vector3(1.0, 1.0, 1.0))), 0.7, 30000);
}

TEST_CASE("segment query: the tree finds the same hits in a triangle soup") {
    std::mt19937_64 random(23);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    std::vector<Vector3> vertices;
    std::vector<TriangleCorners> triangles;
    for (std::int32_t i = 0; i < 600; ++i) {
        vertices.emplace_back(unit(random), unit(random), unit(random));
    }
    for (int i = 0; i < 500; ++i) {
        triangles.push_back({static_cast<std::int32_t>(random() % 600),
                             static_cast<std::int32_t>(random() % 600),
                             static_cast<std::int32_t>(random() % 600)});
    }
    check_same_hits(*make_collision_mesh(TriangleMesh::build(vertices, triangles)), 1.0, 20000);
}

TEST_CASE("segment query: where and on which side") {
    const auto box = make_collision_mesh(make_box(Vector3(2.0, 2.0, 2.0)));
    const SegmentHit outside =
        find_nearest_hit(*box, Vector3(0.3, 0.1, 4.0), Vector3(0.3, 0.1, 0.0));
    CHECK(outside.t == Approx(0.75).epsilon(1e-15));
    CHECK(outside.side == 1);
    const SegmentHit inside =
        find_nearest_hit(*box, Vector3(0.3, 0.1, 0.0), Vector3(0.3, 0.1, 4.0));
    CHECK(inside.t == Approx(0.25).epsilon(1e-15));
    CHECK(inside.side == -1);
    CHECK(inside.triangle == outside.triangle);
    CHECK_FALSE(find_nearest_hit(*box, Vector3(0.3, 0.1, 4.0), Vector3(0.3, 0.1, 1.1)).found());
    CHECK_FALSE(find_nearest_hit(*box, Vector3(1.1, 0.1, 4.0), Vector3(1.1, 0.1, -4.0)).found());
}

TEST_CASE("segment query: ends in the surface belong to it") {
    const auto box = make_collision_mesh(make_box(Vector3(2.0, 2.0, 2.0)));
    CHECK(find_nearest_hit(*box, Vector3(0.3, 0.1, 2.0), Vector3(0.3, 0.1, 1.0)).t == 1.0);
    CHECK(find_nearest_hit(*box, Vector3(0.3, 0.1, 1.0), Vector3(0.3, 0.1, 2.0)).t == 0.0);
    CHECK(find_nearest_hit(*box, Vector3(0.3, 0.1, 1.0), Vector3(0.3, 0.1, 1.0)).t == 0.0);
    CHECK(find_nearest_hit(*box, Vector3(1.0, 1.0, 1.0), Vector3(2.0, 2.0, 2.0)).t == 0.0);
    CHECK_FALSE(find_nearest_hit(*box, Vector3(0.3, 0.1, 1.5), Vector3(0.3, 0.1, 1.5)).found());
}

TEST_CASE(
    "segment query: a segment within the plane of a sheet meets its rim, and nothing beside it") {
    const auto plate = make_collision_mesh(make_plate(2.0, 2.0, 3));
    const SegmentHit rim =
        find_nearest_hit(*plate, Vector3(-3.0, 0.0, 0.1), Vector3(1.0, 0.0, 0.1));
    CHECK(rim.t == Approx(0.5).epsilon(1e-14));
    CHECK(rim.side == 0);
    CHECK(find_nearest_hit(*plate, Vector3(0.1, 0.0, 0.2), Vector3(0.3, 0.0, 0.2)).t == 0.0);
    CHECK_FALSE(find_nearest_hit(*plate, Vector3(-3.0, 0.0, 1.5), Vector3(3.0, 0.0, 1.5)).found());
    CHECK_FALSE(find_nearest_hit(*plate, Vector3(-3.0, 0.0, 0.1), Vector3(-1.5, 0.0, 0.1)).found());
    // Along the rim's own line, before its corner and past it.
    CHECK_FALSE(find_nearest_hit(*plate, Vector3(-3.0, 0.0, 1.0), Vector3(-1.5, 0.0, 1.0)).found());
    CHECK(find_nearest_hit(*plate, Vector3(-3.0, 0.0, 1.0), Vector3(3.0, 0.0, 1.0)).t ==
          Approx(1.0 / 3.0).epsilon(1e-14));
}

TEST_CASE(
    "segment query: no segment slips out of a closed mesh, not even through its corners and "
    "edges") {
    // From inside through each corner and through points of each edge, at directions that round differently.
    std::mt19937_64 random(29);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (const double scale : {1e-4, 1.0, 1e4}) {
        const auto mesh = make_collision_mesh(make_bumpy_sphere(scale, 6, 0.05, 9.0));
        for (int round = 0; round < 30000; ++round) {
            const auto triangle = static_cast<std::int32_t>(
                random() % static_cast<std::uint64_t>(mesh->n_triangles()));
            const TriangleCorners& t = mesh->corners(triangle);
            const Vector3& a = mesh->vertex_B(t[random() % 3]);
            const Vector3& b = mesh->vertex_B(t[random() % 3]);
            const Vector3 target = a + unit(random) * (b - a);
            const Vector3 from =
                0.3 * scale * Vector3(unit(random) - 0.5, unit(random) - 0.5, unit(random) - 0.5);
            const Vector3 to = target + (target - from);
            const SegmentHit hit = find_nearest_hit(*mesh, from, to);
            REQUIRE(hit.found());
            REQUIRE(hit.side == -1);
            REQUIRE((from + hit.t * (to - from) - target).norm() <= 1e-9 * scale + 2.0 * scale);
        }
    }
}

TEST_CASE(
    "segment query: triangles collected near a box answer as the tree does, in the box and out of "
    "it") {
    const auto mesh = make_collision_mesh(make_bumpy_sphere(1.0, 16, 0.05, 9.0));
    std::mt19937_64 random(31);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const auto vector = [&] { return Vector3(unit(random), unit(random), unit(random)); };
    NearbyTriangles nearby;
    int n_covered = 0;
    int n_hits = 0;
    for (int round = 0; round < 2000; ++round) {
        const Vector3 centre = vector().normalized();
        const Vector3 half = Vector3::Constant(0.1);
        nearby.collect(*mesh, {centre - half, centre + half});
        for (int i = 0; i < 20; ++i) {
            const Vector3 from = centre + 0.1 * vector();
            const Vector3 to = from + (i % 2 == 0 ? 0.1 : 1.5) * vector();
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
                REQUIRE(near.triangle == all.triangle);
                REQUIRE(near.t == all.t);
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
    const auto mesh = make_collision_mesh(make_bumpy_sphere(1.0, 24, 0.05, 9.0));
    std::mt19937_64 random(37);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const auto vector = [&] { return Vector3(unit(random), unit(random), unit(random)); };
    const auto check = [&](NearbyTriangles& nearby, const Vector3& from, const Vector3& to) {
        if (!nearby.covers(from) || !nearby.covers(to)) {
            return 0;
        }
        const SegmentHit near = nearby.find_nearest_hit(*mesh, from, to, 1.0, 0.01);
        const SegmentHit all = find_nearest_hit(*mesh, from, to);
        REQUIRE(near.triangle == all.triangle);
        REQUIRE(near.t == all.t);
        return all.found() ? 1 : 0;
    };
    int n_hits = 0;
    NearbyTriangles nearby;
    for (int round = 0; round < 4000; ++round) {
        const Vector3 centre = vector().normalized();
        nearby.collect(*mesh, {centre - Vector3::Constant(0.1), centre + Vector3::Constant(0.1)});
        const Vector3 from = centre + 0.05 * vector();
        const Vector3 to = centre + 0.05 * vector();
        n_hits += check(nearby, from, to);
        n_hits += check(nearby, 0.5 * (from + to), from);
        n_hits += check(nearby, from + 0.2 * (to - from), to);
        n_hits += check(nearby, 0.5 * (from + to), to + 0.05 * vector());
        n_hits += check(nearby, from, from + 0.7 * (to - from) + 0.01 * vector());
    }
    CHECK(n_hits > 2000);
}

TEST_CASE("segment query: the next triangles are collected ahead while the present ones serve") {
    const auto mesh = make_collision_mesh(make_bumpy_sphere(1.0, 30, 0.05, 9.0));
    const auto box_at = [](const Vector3& centre) {
        return Box{centre - Vector3::Constant(0.05), centre + Vector3::Constant(0.05)};
    };
    std::mt19937_64 random(41);
    std::normal_distribution<double> normal;
    const auto vector = [&] { return Vector3(normal(random), normal(random), normal(random)); };
    NearbyTriangles nearby;
    int n_hits = 0;
    int n_longest = 0;
    for (int round = 0; round < 500; ++round) {
        const Vector3 here = vector().normalized();
        const Vector3 next = here + 0.08 * vector().normalized();
        REQUIRE(nearby.collect(*mesh, box_at(here)));
        nearby.begin_ahead(*mesh, box_at(next));
        // Two nodes at a time: half as often as one at a time.
        NearbyTriangles one_by_one;
        one_by_one.begin_ahead(*mesh, box_at(next));
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
            const Vector3 from = here + 0.01 * vector().normalized();
            const Vector3 to = here - 0.02 * vector().normalized();
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
        const Vector3 from = next + 0.04 * vector().normalized();
        const Vector3 to = next - 0.04 * vector().normalized();
        const SegmentHit near = nearby.find_nearest_hit(*mesh, from, to, 1.0, 0.01);
        REQUIRE(near.triangle == find_nearest_hit(*mesh, from, to).triangle);
        n_hits += near.found() ? 1 : 0;
    }
    CHECK(n_hits > 50);
    CHECK(n_longest >= 4);
    // One that does not fit leaves the present ones in place.
    REQUIRE(nearby.collect(*mesh, box_at(Vector3::UnitX())));
    nearby.begin_ahead(*mesh, {Vector3::Constant(-2.0), Vector3::Constant(2.0)});
    CHECK(nearby.go_on_ahead(*mesh, 1000000) == Collecting::too_many);
    CHECK_FALSE(nearby.covers_ahead(Vector3::Zero()));
    CHECK(nearby.covers(Vector3::UnitX()));
}

TEST_CASE("segment query: more triangles around a sweep than can be remembered are all asked") {
    const auto mesh = make_collision_mesh(make_bumpy_sphere(1.0, 24, 0.05, 9.0));
    std::mt19937_64 random(43);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const auto vector = [&] { return Vector3(unit(random), unit(random), unit(random)); };
    NearbyTriangles nearby;
    int n_hits = 0;
    for (int round = 0; round < 300; ++round) {
        const Vector3 centre = vector().normalized();
        REQUIRE(nearby.collect(
            *mesh, {centre - Vector3::Constant(0.08), centre + Vector3::Constant(0.08)}));
        for (int i = 0; i < 10; ++i) {
            const Vector3 from = centre + 0.07 * vector();
            const Vector3 to = centre + 0.07 * vector();
            const SegmentHit near = nearby.find_nearest_hit(*mesh, from, to, 1.0, 0.07);
            const SegmentHit all = find_nearest_hit_brute_force(*mesh, from, to);
            REQUIRE(near.triangle == all.triangle);
            REQUIRE(near.t == all.t);
            n_hits += all.found() ? 1 : 0;
        }
    }
    CHECK(n_hits > 500);
}

TEST_CASE("segment query: what is made ready around a sweep ends with the collected box") {
    const auto mesh = make_collision_mesh(make_sphere(1.0, 80));
    std::mt19937_64 random(47);
    std::normal_distribution<double> normal;
    const auto vector = [&] { return Vector3(normal(random), normal(random), normal(random)); };
    const auto box_at = [](const Vector3& centre) {
        return Box{centre - Vector3::Constant(0.004), centre + Vector3::Constant(0.004)};
    };
    NearbyTriangles nearby;
    for (int round = 0; round < 200; ++round) {
        const Vector3 here = vector().normalized();
        const Vector3 next = (here + 0.05 * here.cross(vector()).normalized()).normalized();
        REQUIRE(nearby.collect(*mesh, box_at(here)));
        REQUIRE(nearby.find_nearest_hit(*mesh, 1.002 * here, 0.998 * here, 1.0, 0.06).found());
        REQUIRE(nearby.collect(*mesh, box_at(next)));
        REQUIRE(nearby.find_nearest_hit(*mesh, 1.002 * next, 0.998 * next, 1.0, 0.06).triangle ==
                find_nearest_hit(*mesh, 1.002 * next, 0.998 * next).triangle);
    }
}

TEST_CASE("segment query: too many triangles for the near set leave the answer to the tree") {
    const auto mesh = make_collision_mesh(make_sphere(1.0, 8));
    NearbyTriangles nearby;
    nearby.collect(*mesh, {Vector3::Constant(-2.0), Vector3::Constant(2.0)});
    CHECK_FALSE(nearby.covers(Vector3::Zero()));
}

}  // namespace
}  // namespace fulcrum
