// A model as something to touch.
#include "runtime/scene/gltf/collision_from_model.h"

#include "tests/unit/runtime/scene/gltf/gltf_bytes.h"

#include <catch2/catch.hpp>

using namespace fulcrum;
using namespace fulcrum::runtime;
using namespace fulcrum::test;
using Catch::Matchers::Contains;

TEST_CASE("collision: a model's triangles become a mesh that can be touched, corners welded") {
    Gltf gltf;
    gltf.document["nodes"] = json::array({{{"mesh", 0}}, {{"mesh", 0}, {"scale", {1, -1, 1}}}});
    gltf.at("/scenes/0/nodes") = {0, 1};
    const auto mesh = collision_from_model(loaded(gltf), "test.glb");
    REQUIRE(mesh.has_value());
    CHECK(mesh->triangles().size() == 2);
    CHECK(mesh->vertices_B().size() == 4);  // the two triangles share an edge
    CHECK(mesh->lower_B().isApprox(Vector3(0, -1, 0)));
    CHECK(mesh->upper_B().isApprox(Vector3(1, 1, 0)));
    // Both still face +z, though one was mirrored.
    for (const auto& t : mesh->triangles()) {
        const auto& v = mesh->vertices_B();
        const auto at = [&](std::size_t k) { return v[static_cast<std::size_t>(t[k])]; };
        CHECK((at(1) - at(0)).cross(at(2) - at(0)).z() > 0.0);
    }
    CHECK_FALSE(collision_from_model(LoadedModel{}, "empty").has_value());
}
