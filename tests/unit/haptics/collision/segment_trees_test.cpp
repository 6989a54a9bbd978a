#include "haptics/collision/broad_phase.h"
#include "haptics/collision/contact_pairs.h"
#include "haptics/collision/h_collide.h"
#include "haptics/collision/segment_structure.h"
#include "haptics/geometry/shape.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/random_segments.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <utility>
#include <vector>

using namespace fulcrum;

namespace {

using Mesh = std::shared_ptr<const CollisionMesh>;

bool is_same(const SegmentHit& a, const SegmentHit& b) {
    return a.triangle == b.triangle && a.t == b.t && a.side == b.side;
}

// All structures against brute force.
void compare(const Mesh& mesh, int n_random, int n_hard_of_each) {
    using enum SegmentStructureKind;
    const auto reference = make_segment_structure(brute_force, mesh).value();
    const auto tree = make_segment_structure(bounding_tree, mesh).value();
    const auto grid = make_segment_structure(h_collide, mesh).value();
    RandomSegments segments(*mesh, 91);
    int n_hits = 0;
    int n_other_by_tree = 0;
    int n_other_by_grid = 0;
    for (int i = 0; i < n_random + n_hard_of_each * RandomSegments::kKinds; ++i) {
        const auto [from, to] = i < n_random
                                    ? segments.draw()
                                    : segments.draw_hard((i - n_random) % RandomSegments::kKinds);
        const SegmentHit expected = reference->find_nearest_hit(from, to);
        n_hits += i < n_random && expected.found() ? 1 : 0;
        n_other_by_tree += is_same(expected, tree->find_nearest_hit(from, to)) ? 0 : 1;
        n_other_by_grid += is_same(expected, grid->find_nearest_hit(from, to)) ? 0 : 1;
    }
    CHECK(n_hits > n_random / 20);
    CHECK(n_hits < n_random);
    CHECK(n_other_by_tree == 0);
    CHECK(n_other_by_grid == 0);
}

// Triangles of all sizes that cross each other.
Expected<TriangleMesh> make_soup() {
    Random random(23);
    std::vector<Vector3> vertices;
    std::vector<TriangleCorners> triangles;
    for (std::int32_t i = 0; i < 300; ++i) {
        const double size = i % 3 == 0 ? 1.0 : 0.05;
        const Vector3 at = random.in_cube();
        for (int corner = 0; corner < 3; ++corner) {
            vertices.emplace_back(at + size * random.in_cube());
        }
        triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return TriangleMesh::build(std::move(vertices), std::move(triangles));
}
// The same with corners in common, some of them without area.
Expected<TriangleMesh> make_web() {
    Random random(23);
    std::vector<Vector3> vertices;
    std::vector<TriangleCorners> triangles;
    const auto draw = [&] { return static_cast<std::int32_t>(random.integer() % 600); };
    for (std::int32_t i = 0; i < 600; ++i) {
        vertices.emplace_back(random.in_cube());
        triangles.push_back({draw(), draw(), draw()});
    }
    return TriangleMesh::build(std::move(vertices), std::move(triangles));
}

Expected<TriangleMesh> moved(const TriangleMesh& mesh, const Vector3& by) {
    std::vector<Vector3> vertices = mesh.vertices_B();
    for (Vector3& vertex : vertices) {
        vertex += by;
    }
    return TriangleMesh::build(std::move(vertices), mesh.triangles(), {.weld_relative = 0.0});
}

std::shared_ptr<const HCollide> make(const Mesh& mesh, const HCollideSettings& settings = {}) {
    return HCollide::create(mesh, settings).value();
}

// Hits of the grid, with what it remembers from one to the next, are those of brute force.
void check_hits(const Mesh& mesh, const HCollide& grid, unsigned seed, int n, bool hard) {
    RandomSegments segments(*mesh, seed);
    HCollide::Memory memory;
    for (int i = 0; i < n; ++i) {
        const auto [from, to] =
            hard ? segments.draw_hard(i % RandomSegments::kKinds) : segments.draw();
        REQUIRE(grid.find_nearest_hit(from, to, memory).triangle ==
                find_nearest_hit_brute_force(*mesh, from, to).triangle);
    }
}

std::vector<BodyPair> try_all(const std::vector<Box>& boxes,
                              const std::vector<std::uint8_t>& moves) {
    std::vector<BodyPair> pairs;
    for (std::size_t a = 0; a < boxes.size(); ++a) {
        for (std::size_t b = a + 1; b < boxes.size(); ++b) {
            if (boxes[a].overlaps(boxes[b]) && (moves[a] != 0 || moves[b] != 0)) {
                pairs.push_back({static_cast<std::int32_t>(a), static_cast<std::int32_t>(b)});
            }
        }
    }
    return pairs;
}
Box make_box_round(const Vector3& middle, const Vector3& half) {
    return {middle - half, middle + half};
}

TEST_CASE("broad phase: exactly the pairs that overlap, while boxes wander, jump, come and go") {
    Random random(1);
    BroadPhase broad_phase(100, 5000);
    std::vector<Vector3> places(100);
    std::size_t n_found = 0;
    for (int step = 0; step < 300; ++step) {
        // Spread along one axis after another; now and then all jump.
        const Vector3 spread = Vector3::Constant(0.3) + 4.0 * Vector3::Unit(step / 50 % 3);
        std::vector<Box> boxes;
        std::vector<std::uint8_t> moves;
        const std::size_t n = step % 7 == 0 ? 60 : 100;
        for (std::size_t i = 0; i < n; ++i) {
            const bool jumps = step % 50 == 0;
            places[i] = jumps ? Vector3(spread.cwiseProduct(random.in_cube()))
                              : Vector3(places[i] + 0.02 * random.in_cube());
            boxes.push_back(
                make_box_round(places[i], Vector3::Constant(0.1 + 0.001 * static_cast<double>(i))));
            moves.push_back(i % 5 == 0 ? 0 : 1);
            if (step % 3 == 0 && i % 20 == 7) {
                boxes.back().lower.setConstant(std::nan(""));
            }
        }
        const auto pairs = broad_phase.find_pairs(boxes, moves);
        const auto expected = try_all(boxes, moves);
        REQUIRE(std::ranges::equal(pairs, expected));
        REQUIRE(broad_phase.n_dropped() == 0);
        n_found += pairs.size();
    }
    CHECK(n_found > 3000);
}

TEST_CASE("broad phase: touching boxes, equal ones and one without end meet whom they should") {
    constexpr double kEndless = std::numeric_limits<double>::infinity();
    const std::vector<Box> boxes{{Vector3::Constant(-kEndless), Vector3::Constant(kEndless)},
                                 make_box_round({0.0, 0.5, 0.0}, Vector3::Constant(0.5)),
                                 make_box_round({0.0, 1.5, 0.0}, Vector3::Constant(0.5)),
                                 make_box_round({0.0, 1.5, 0.0}, Vector3::Constant(0.5))};
    const std::vector<std::uint8_t> moves{0, 1, 1, 1};
    BroadPhase broad_phase(4, 10);
    CHECK(std::ranges::equal(broad_phase.find_pairs(boxes, moves), try_all(boxes, moves)));
    CHECK(broad_phase.find_pairs(boxes, moves).size() == 6);
}

TEST_CASE("broad phase: of more pairs than there is room for the nearest stay, reaches left out") {
    Random random(4);
    constexpr std::size_t kRoom = 40;
    BroadPhase few(60, static_cast<int>(kRoom));
    for (int trial = 0; trial < 20; ++trial) {
        std::vector<Box> bodies;
        std::vector<Box> boxes;
        std::vector<double> reaches_m;
        const std::vector<std::uint8_t> moves(60, 1);
        for (int i = 0; i < 60; ++i) {
            bodies.push_back(make_box_round(2.0 * random.in_cube(), Vector3::Constant(0.1)));
            reaches_m.push_back(random.uniform() + 1.0);
            const Vector3 reach = Vector3::Constant(reaches_m.back());
            boxes.push_back({bodies.back().lower - reach, bodies.back().upper + reach});
        }
        const auto gap_of = [&](const BodyPair& pair) {
            const Box& a = bodies[static_cast<std::size_t>(pair.first)];
            const Box& b = bodies[static_cast<std::size_t>(pair.second)];
            return (a.lower - b.upper).cwiseMax(b.lower - a.upper).maxCoeff();
        };
        auto expected = try_all(boxes, moves);
        REQUIRE(expected.size() > 2 * kRoom);
        const auto n_dropped = static_cast<int>(expected.size() - kRoom);
        std::ranges::sort(expected, {}, gap_of);
        expected.resize(kRoom);
        std::sort(expected.begin(), expected.end());
        REQUIRE(std::ranges::equal(few.find_pairs(boxes, moves, reaches_m), expected));
        REQUIRE(few.n_dropped() == n_dropped);
    }
}

TEST_CASE("broad phase: what has no room is counted, and a box that is none meets nobody") {
    std::vector<Box> boxes(5, make_box_round(Vector3::Zero(), Vector3::Ones()));
    const std::vector<std::uint8_t> moves(5, 1);
    BroadPhase few(5, 4);
    CHECK(few.find_pairs(boxes, moves).size() == 4);
    CHECK(few.n_dropped() == 6);
    boxes[2].lower.setConstant(std::nan(""));
    boxes[2].upper.setConstant(std::nan(""));
    BroadPhase enough(5, 10);
    CHECK(std::ranges::equal(enough.find_pairs(boxes, moves), try_all(boxes, moves)));
    CHECK(enough.find_pairs(boxes, moves).size() == 6);
    BroadPhase small(3, 10);
    CHECK(small.find_pairs(boxes, moves).size() == 1);
}

TEST_CASE("contact pairs: what was remembered of a pair stays while it is named, and no longer") {
    Random random(1);
    ContactPairs pairs(40);
    std::map<BodyPair, std::uint32_t> told;
    std::uint32_t next = 1;
    for (int step = 0; step < 500; ++step) {
        std::vector<BodyPair> named;
        for (std::int32_t a = 0; a < 8; ++a) {
            for (std::int32_t b = a + 1; b < 8; ++b) {
                if (random.uniform() > 0.2) {
                    named.push_back({a, b});
                }
            }
        }
        pairs.update(named);
        REQUIRE(pairs.count() == static_cast<int>(named.size()));
        std::map<BodyPair, std::uint32_t> now;
        for (int i = 0; i < pairs.count(); ++i) {
            ContactPair& pair = pairs.at(i);
            REQUIRE(pair.bodies == named[static_cast<std::size_t>(i)]);
            const auto old = told.find(pair.bodies);
            if (old == told.end()) {
                REQUIRE(pair.n_memories == 0);
                REQUIRE(pair.manifold.count == 0);
            } else {
                REQUIRE(pair.recall(old->second) != nullptr);
                REQUIRE(pair.recall(old->second)->impulse_W.x() == old->second);
                REQUIRE(pair.recall(old->second + 1) == nullptr);
            }
            pair.forget();
            pair.remember({.id = next, .impulse_W = Vector3(next, 0.0, 0.0)});
            now[pair.bodies] = next;
            next += 2;
        }
        told = now;
    }
}

TEST_CASE("contact pairs: more than there is room for are left out, and one pair remembers four") {
    ContactPairs pairs(2);
    const std::vector<BodyPair> three{{0, 1}, {0, 2}, {1, 2}};
    pairs.update(three);
    CHECK(pairs.count() == 2);
    pairs.update(std::vector<BodyPair>{{1, 2}});
    REQUIRE(pairs.count() == 1);
    for (std::uint32_t id = 1; id < 7; ++id) {
        pairs.at(0).remember({.id = id});
    }
    CHECK(pairs.at(0).recall(4) != nullptr);
    CHECK(pairs.at(0).recall(5) == nullptr);
}

}  // namespace

// Structures that find where a segment meets a mesh first, all against brute force. What h_collide.h adds is asked of it alone.

TEST_CASE("segment structures: all find the hits of brute force on a million random segments") {
    compare(touchable(make_bumpy_sphere(1.0, 4, 0.1, 7.0)), 1000000, 2000);
}

TEST_CASE("segment structures: all find the hits of brute force on every kind of mesh") {
    struct Kind {
        const char* name;
        Expected<TriangleMesh> mesh;
        int n_random, n_hard_of_each;
    };
    const Kind kinds[] = {{"torus", make_torus(8e3, 2e3, 24, 12), 30000, 200},
                          {"slivers", make_globe(1e-4, 40, 12), 10000, 200},
                          {"globe", make_globe(1.0, 24, 12), 30000, 200},
                          {"small", make_bumpy_sphere(1e-4, 4, 0.1, 7.0), 30000, 200},
                          {"soup", make_soup(), 10000, 200},
                          {"web", make_web(), 20000, 200},
                          {"bumpy", make_bumpy_sphere(1.0, 12, 0.1, 7.0), 2000, 50},
                          {"box", make_box(Vector3(1.0, 1.0, 1.0)), 30000, 1000},
                          {"flat box", make_box(Vector3(1.0, 1e-4, 3.0)), 10000, 1000},
                          {"trench", make_trench(0.7, 40), 10000, 300},
                          {"far", moved(*make_sphere(1.0, 5), Vector3(1e5, -3e5, 2e5)), 10000, 100},
                          // Met by few; most of the hard ones lie in its plane.
                          {"plate", make_plate(1.0, 2.0, 8), 10000, 1000}};
    for (const Kind& kind : kinds) {
        INFO(kind.name);
        compare(touchable(kind.mesh), kind.n_random, kind.n_hard_of_each);
    }
}

TEST_CASE("segment structures: names lead to kinds; no mesh and bad settings are refused") {
    for (const auto kind : {SegmentStructureKind::bounding_tree, SegmentStructureKind::h_collide,
                            SegmentStructureKind::brute_force}) {
        CHECK(find_segment_structure(name_of(kind)) == kind);
    }
    CHECK(name_of(SegmentStructureKind::h_collide) == "h_collide");
    CHECK_FALSE(find_segment_structure("octree"));
    CHECK_FALSE(find_segment_structure(""));
    using enum SegmentStructureKind;
    const auto box = touchable(make_box(Vector3::Ones()));
    CHECK_FALSE(make_segment_structure(bounding_tree, nullptr));
    CHECK_FALSE(make_segment_structure(h_collide, nullptr));
    CHECK_FALSE(make_segment_structure(h_collide, box, {.triangles_a_cell = 0.5}));
    CHECK_FALSE(make_segment_structure(h_collide, box, {.triangles_a_leaf = 0}));
    CHECK(make_segment_structure(brute_force, box).value()->memory_bytes() == 0);
}

TEST_CASE("h-collide: whatever its cells, leaves and memory, hits are the same") {
    const auto mesh = touchable(make_bumpy_sphere(1.0, 8, 0.05, 9.0));
    for (const double triangles_a_cell : {1.0, 20.0, 1000.0, 1.0e6}) {
        for (const int triangles_a_leaf : {1, 7, 1000}) {
            const auto grid = make(mesh, {triangles_a_cell, triangles_a_leaf});
            RandomSegments segments(*mesh, 5);
            HCollide::Memory kept;
            for (int i = 0; i < 400; ++i) {
                const auto [from, to] = i % 2 == 0
                                            ? segments.draw()
                                            : segments.draw_hard(i / 2 % RandomSegments::kKinds);
                const SegmentHit expected = find_nearest_hit_brute_force(*mesh, from, to);
                HCollide::Memory fresh;
                for (HCollide::Memory* const memory : {&kept, &fresh}) {
                    const SegmentHit hit = grid->find_nearest_hit(from, to, *memory);
                    REQUIRE(hit.triangle == expected.triangle);
                    REQUIRE(hit.t == expected.t);
                }
            }
        }
    }
}

TEST_CASE("h-collide: it remembers the triangle that was met and the cell where it ended") {
    const auto mesh = touchable(make_box(Vector3::Ones()));
    const auto grid = make(mesh);
    HCollide::Memory memory;
    const SegmentHit hit =
        grid->find_nearest_hit(Vector3(0.1, 2.0, 0.2), Vector3(0.1, 0.0, 0.2), memory);
    CHECK(hit.found());
    CHECK(memory.triangle == hit.triangle);
    CHECK(memory.has_cell);
    // A miss forgets nothing: the next question will be near.
    (void)grid->find_nearest_hit(Vector3(0.1, 2.0, 0.2), Vector3(0.1, 1.0, 0.2), memory);
    CHECK(memory.triangle == hit.triangle);
}

TEST_CASE("h-collide: cells hold about as many triangles as asked, and no empty one is kept") {
    const auto mesh = touchable(make_sphere(1.0, 30));  // 18000 triangles
    const auto fine = make(mesh, {.triangles_a_cell = 4.0});
    const auto coarse = make(mesh, {.triangles_a_cell = 64.0});
    // A sheet passes through some twice the cells that its area alone would fill.
    CHECK(fine->n_cells() > 18000 / 4);
    CHECK(fine->n_cells() < 3 * 18000 / 4);
    CHECK(coarse->n_cells() > 18000 / 64);
    CHECK(coarse->n_cells() < 3 * 18000 / 64);
    CHECK(coarse->cell_m() == Approx(4.0 * fine->cell_m()));
    CHECK(fine->memory_bytes() > coarse->memory_bytes());
}

TEST_CASE("h-collide: long triangles among small ones do not fill the memory") {
    // Blades across the whole room, and a ball of small triangles that asks for small cells.
    const auto ball = make_sphere(0.01, 12);
    std::vector<Vector3> vertices = ball->vertices_B();
    std::vector<TriangleCorners> triangles = ball->triangles();
    Random random(3);
    for (int i = 0; i < 300; ++i) {
        const auto first = static_cast<std::int32_t>(vertices.size());
        const Vector3 end = random.direction();
        vertices.emplace_back(end);
        vertices.emplace_back(-end);
        vertices.emplace_back(end + 1.0e-4 * random.direction());
        triangles.push_back({first, first + 1, first + 2});
    }
    const auto mesh = touchable(TriangleMesh::build(vertices, triangles));
    const auto grid = make(mesh);
    CHECK(grid->memory_bytes() < 2000U * static_cast<unsigned>(mesh->n_triangles()));
    check_hits(mesh, *grid, 7, 600, true);
}

TEST_CASE("h-collide: meshes from the smallest to the largest size that a mesh may have") {
    for (const double scale : {1e-15, 1e-4, 1e4, 1e15}) {
        CAPTURE(scale);
        const auto mesh = touchable(make_bumpy_sphere(scale, 4, 0.05, 9.0));
        check_hits(mesh, *make(mesh), 9, 2000, false);
    }
}
