#include "haptics/collision/collision_mesh.h"

#include "haptics/geometry/shape.h"

#include <catch2/catch.hpp>

namespace fulcrum {
namespace {

std::shared_ptr<const CollisionMesh> make_collision_mesh(Expected<TriangleMesh> mesh) {
    REQUIRE(mesh);
    auto made = CollisionMesh::create(std::move(*mesh));
    REQUIRE(made);
    return *made;
}

TEST_CASE("collision mesh: keeps the source's numbers of its triangles and tells its size") {
    const auto source = make_bumpy_sphere(1.0, 9, 0.05, 9.0);
    const auto mesh = make_collision_mesh(source);
    REQUIRE(mesh->n_triangles() == static_cast<std::int32_t>(source->triangles().size()));
    for (std::int32_t i = 0; i < mesh->n_triangles(); ++i) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const auto of_source =
                source->triangles()[static_cast<std::size_t>(mesh->source_triangle(i))][corner];
            REQUIRE(mesh->vertex_B(mesh->corners(i)[corner]) ==
                    source->vertices_B()[static_cast<std::size_t>(of_source)]);
        }
    }
    CHECK(mesh->radius_m() >= 1.0);
    CHECK(mesh->radius_m() <= 1.1);
    CHECK(mesh->memory_bytes() > 1620 * 30);
    CHECK(mesh->memory_bytes() < 1620 * 50);
}

TEST_CASE("collision mesh: a mesh that was given away is refused") {
    auto mesh = make_box(Vector3::Ones());
    REQUIRE(CollisionMesh::create(std::move(*mesh)));
    const TriangleMesh taken = std::move(*mesh);
    CHECK_FALSE(CollisionMesh::create(std::move(*mesh)));
}

}  // namespace
}  // namespace fulcrum
