#include "runtime/render/scene/tool_model.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace fulcrum;
using namespace fulcrum::runtime;

namespace {

Vector3f corner_of(const ModelPrimitive& primitive, std::size_t i) {
    return {primitive.positions[3 * i], primitive.positions[3 * i + 1],
            primitive.positions[3 * i + 2]};
}

// Half of the box around it.
Vector3f half_size(const LoadedModel& model) {
    Vector3f most = Vector3f::Zero();
    for (std::size_t i = 0; i < model.primitives[0].positions.size() / 3; ++i) {
        most = most.cwiseMax(corner_of(model.primitives[0], i).cwiseAbs());
    }
    return most;
}

// Each triangle faces as its corners' normals do.
bool faces_outwards(const LoadedModel& model) {
    const ModelPrimitive& primitive = model.primitives[0];
    for (std::size_t t = 0; t + 2 < primitive.indices.size(); t += 3) {
        const Vector3f a = corner_of(primitive, primitive.indices[t]);
        const Vector3f b = corner_of(primitive, primitive.indices[t + 1]);
        const Vector3f c = corner_of(primitive, primitive.indices[t + 2]);
        const Vector3f across = (b - a).cross(c - a);
        if (across.norm() > 1e-9F && across.dot(a + b + c) < -1e-9F) {
            return false;
        }
    }
    return true;
}

}  // namespace

TEST_CASE("tool model: it is as large as the tool that is felt, and its fronts look outwards") {
    const auto check = [](const CursorShape& shape, const Vector3f& half) {
        const LoadedModel model = make_tool_model(shape);
        REQUIRE(model.primitives.size() == 1);
        CHECK((half_size(model) - half).norm() < 2e-4F);
        CHECK(faces_outwards(model));
        for (const std::uint32_t index : model.primitives[0].indices) {
            REQUIRE(index < model.primitives[0].positions.size() / 3);
        }
        for (const float number : model.primitives[0].normals) {
            REQUIRE(std::isfinite(number));
        }
    };
    check(SphereShape{0.03}, {0.03F, 0.03F, 0.03F});
    check(BoxShape{Vector3(0.01, 0.02, 0.03)}, {0.01F, 0.02F, 0.03F});
    check(CapsuleShape{0.01, 0.04}, {0.01F, 0.05F, 0.01F});
    check(CylinderShape{0.02, 0.05}, {0.02F, 0.05F, 0.02F});
    check(std::monostate{}, {0.01F, 0.01F, 0.01F});
}
