#include "runtime/render/gl/simplify.h"

#include "runtime/render/scene/shapes.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

constexpr float kRadius_m = 0.1F;

ModelPrimitive ball() {
    return make_ball(kRadius_m, {1, 1, 1, 1}).primitives.front();
}

/// A unit square of n x n small ones, facing +Z.
ModelPrimitive sheet(std::uint32_t n) {
    ModelPrimitive p;
    for (std::uint32_t y = 0; y <= n; ++y) {
        for (std::uint32_t x = 0; x <= n; ++x) {
            p.positions.insert(p.positions.end(),
                               {static_cast<float>(x) / static_cast<float>(n),
                                static_cast<float>(y) / static_cast<float>(n), 0});
            p.normals.insert(p.normals.end(), {0, 0, 1});
        }
    }
    for (std::uint32_t y = 0; y < n; ++y) {
        for (std::uint32_t x = 0; x < n; ++x) {
            const std::uint32_t a = y * (n + 1) + x;
            for (const std::uint32_t i : {a, a + 1, a + n + 2, a, a + n + 2, a + n + 1}) {
                p.indices.push_back(i);
            }
        }
    }
    return p;
}

}  // namespace

TEST_CASE("simplify: a ball stays a closed ball with fewer triangles") {
    const ModelPrimitive before = ball();
    REQUIRE(gl::is_closed(before));
    const float cell_m = 2.0F * kRadius_m / 10.0F;
    const ModelPrimitive after = gl::simplified(before, cell_m);
    CHECK(after.indices.size() < before.indices.size() * 2 / 3);
    CHECK(after.indices.size() > 300);
    CHECK(gl::is_closed(after));
    CHECK(after.normals.size() == after.positions.size());
    CHECK(after.uvs.size() * 3 == after.positions.size() * 2);
    for (std::size_t i = 0; i + 2 < after.positions.size(); i += 3) {
        // Corners are chosen, not invented.
        CHECK(fulcrum::Vector3f(after.positions.data() + i).norm() == Approx(kRadius_m));
    }
    for (const std::uint32_t index : after.indices) {
        CHECK(index < after.positions.size() / 3);
    }
}

TEST_CASE("simplify: cells smaller than the triangles change no triangle") {
    const ModelPrimitive before = sheet(6);
    const ModelPrimitive after = gl::simplified(before, 0.01F);
    CHECK(after.indices.size() == before.indices.size());
}

TEST_CASE("simplify: material and picture are kept") {
    ModelPrimitive before = ball();
    before.image = 3;
    before.roughness = 0.25F;
    before.base_colour = {0.1F, 0.2F, 0.3F, 1.0F};
    const ModelPrimitive after = gl::simplified(before, 0.05F);
    CHECK(after.image == 3);
    CHECK(after.roughness == 0.25F);
    CHECK(after.base_colour == before.base_colour);
}

TEST_CASE("simplify: the two sides of a thin sheet stay apart") {
    ModelPrimitive both = sheet(8);
    const ModelPrimitive front = both;
    const auto corners = static_cast<std::uint32_t>(front.positions.size() / 3);
    for (std::size_t i = 0; i < front.positions.size(); i += 3) {
        both.positions.insert(both.positions.end(),
                              {front.positions[i], front.positions[i + 1], -0.001F});
        both.normals.insert(both.normals.end(), {0, 0, -1});
    }
    for (std::size_t t = 0; t < front.indices.size(); t += 3) {
        for (const std::size_t k : {t, t + 2, t + 1}) {
            both.indices.push_back(front.indices[k] + corners);
        }
    }
    const ModelPrimitive after = gl::simplified(both, 0.25F);
    std::size_t forwards = 0;
    std::size_t backwards = 0;
    for (std::size_t i = 2; i < after.normals.size(); i += 3) {
        forwards += after.normals[i] > 0.0F ? 1 : 0;
        backwards += after.normals[i] < 0.0F ? 1 : 0;
    }
    CHECK(forwards > 0);
    CHECK(forwards == backwards);
    CHECK(after.indices.size() < both.indices.size());
}

TEST_CASE("closed: an open sheet, a ball with a hole and one inside out are not") {
    CHECK_FALSE(gl::is_closed(sheet(2)));
    ModelPrimitive holed = ball();
    holed.indices.resize(holed.indices.size() / 2);
    CHECK_FALSE(gl::is_closed(holed));
    ModelPrimitive inside_out = ball();
    for (std::size_t t = 0; t < inside_out.indices.size(); t += 3) {
        std::swap(inside_out.indices[t], inside_out.indices[t + 1]);
    }
    CHECK_FALSE(gl::is_closed(inside_out));
}
