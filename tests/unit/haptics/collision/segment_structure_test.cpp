#include "haptics/collision/segment_structure.h"

#include "haptics/geometry/shape.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/random_segments.h"
#include "tests/support/touchable.h"

#include <catch2/catch.hpp>

#include <array>
#include <memory>

namespace fulcrum {
namespace {

using Mesh = std::shared_ptr<const CollisionMesh>;

std::unique_ptr<SegmentStructure> make(SegmentStructureKind kind, const Mesh& mesh) {
    auto made = make_segment_structure(kind, mesh);
    REQUIRE(made);
    return std::move(*made);
}

bool is_same(const SegmentHit& a, const SegmentHit& b) {
    return a.triangle == b.triangle && a.t == b.t && a.side == b.side;
}

// All structures against brute force.
class Comparison {
  public:
    explicit Comparison(const Mesh& mesh)
        : reference_(make(SegmentStructureKind::brute_force, mesh)),
          tree_(make(SegmentStructureKind::bounding_tree, mesh)),
          grid_(make(SegmentStructureKind::h_collide, mesh)) {}
    void ask(const Vector3& from, const Vector3& to) {
        const SegmentHit expected = reference_->find_nearest_hit(from, to);
        n_hits += expected.found() ? 1 : 0;
        n_other_by_tree += is_same(expected, tree_->find_nearest_hit(from, to)) ? 0 : 1;
        n_other_by_grid += is_same(expected, grid_->find_nearest_hit(from, to)) ? 0 : 1;
    }
    int n_hits = 0;
    int n_other_by_tree = 0;
    int n_other_by_grid = 0;

  private:
    std::unique_ptr<SegmentStructure> reference_;
    std::unique_ptr<SegmentStructure> tree_;
    std::unique_ptr<SegmentStructure> grid_;
};

void compare(const Mesh& mesh, int n_random, int n_hard_of_each) {
    Comparison all(mesh);
    RandomSegments segments(*mesh, 91);
    for (int i = 0; i < n_random; ++i) {
        const auto [from, to] = segments.draw();
        all.ask(from, to);
    }
    CHECK(all.n_hits > n_random / 20);
    CHECK(all.n_hits < n_random);
    for (int i = 0; i < n_hard_of_each * RandomSegments::kKinds; ++i) {
        const auto [from, to] = segments.draw_hard(i % RandomSegments::kKinds);
        all.ask(from, to);
    }
    CHECK(all.n_other_by_tree == 0);
    CHECK(all.n_other_by_grid == 0);
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

Expected<TriangleMesh> moved(const TriangleMesh& mesh, const Vector3& by) {
    std::vector<Vector3> vertices = mesh.vertices_B();
    for (Vector3& vertex : vertices) {
        vertex += by;
    }
    return TriangleMesh::build(std::move(vertices), mesh.triangles(), {.weld_relative = 0.0});
}

TEST_CASE("segment structures: all find the hits of brute force on a million random segments") {
    compare(touchable(make_bumpy_sphere(1.0, 4, 0.1, 7.0)), 1000000, 2000);
}

TEST_CASE("segment structures: all find the hits of brute force on tori, slivers and soups") {
    compare(touchable(make_torus(8e3, 2e3, 24, 12)), 10000, 200);
    compare(touchable(make_globe(1e-4, 40, 12)), 10000, 200);
    compare(touchable(make_soup()), 10000, 200);
    compare(touchable(make_bumpy_sphere(1.0, 12, 0.1, 7.0)), 2000, 50);
}

TEST_CASE("segment structures: all find the hits of brute force on flat, boxed and far meshes") {
    compare(touchable(make_box(Vector3(1.0, 1.0, 1.0))), 10000, 1000);
    compare(touchable(make_box(Vector3(1.0, 1e-4, 3.0))), 10000, 1000);
    compare(touchable(make_trench(0.7, 40)), 10000, 300);
    compare(touchable(moved(*make_sphere(1.0, 5), Vector3(1e5, -3e5, 2e5))), 10000, 100);
    // A flat plate is met by few; most of the hard ones lie in its plane.
    const auto plate = touchable(make_plate(1.0, 2.0, 8));
    compare(plate, 10000, 1000);
}

TEST_CASE("segment structures: names lead to kinds and back, and others to nothing") {
    for (const auto kind : {SegmentStructureKind::bounding_tree, SegmentStructureKind::h_collide,
                            SegmentStructureKind::brute_force}) {
        CHECK(find_segment_structure(name_of(kind)) == kind);
    }
    CHECK(name_of(SegmentStructureKind::h_collide) == "h_collide");
    CHECK_FALSE(find_segment_structure("octree"));
    CHECK_FALSE(find_segment_structure(""));
}

TEST_CASE("segment structures: no mesh and settings out of range are refused") {
    const auto box = touchable(make_box(Vector3::Ones()));
    CHECK_FALSE(make_segment_structure(SegmentStructureKind::bounding_tree, nullptr));
    CHECK_FALSE(make_segment_structure(SegmentStructureKind::h_collide, nullptr));
    CHECK_FALSE(
        make_segment_structure(SegmentStructureKind::h_collide, box, {.triangles_a_cell = 0.5}));
    CHECK_FALSE(
        make_segment_structure(SegmentStructureKind::h_collide, box, {.triangles_a_leaf = 0}));
    CHECK(make_segment_structure(SegmentStructureKind::brute_force, box).value()->memory_bytes() ==
          0);
}

}  // namespace
}  // namespace fulcrum
