// A kite for the card of its lesson; the one that flies is built of its own figures (render/scene/kite_models).
#include "assets/make/models.h"
#include "assets/make/parts.h"

#include <array>
#include <cmath>
#include <numbers>

namespace fulcrum::assets {
namespace {

/// A quarter of the diamond from its crossing to two of its corners, as thick as cloth on a spar; flat on all sides.
MeshPart make_quarter(const Vector3& one, const Vector3& other, const Colour& colour) {
    const Vector3 thick(0.0, 0.0, 0.0025);
    const std::array<Vector3, 3> corners{Vector3::Zero(), one, other};
    MeshPart part;
    const auto face = [&](std::initializer_list<Vector3> around) {
        const auto first = static_cast<std::uint32_t>(part.positions.size());
        const auto* p = around.begin();
        const Vector3 normal = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
        for (const Vector3& at : around) {
            part.positions.push_back(at);
            part.normals.push_back(normal);
            part.uvs.emplace_back(0.0, 0.0);
        }
        for (std::uint32_t i = 2; i < around.size(); ++i) {
            part.indices.insert(part.indices.end(), {first, first + i - 1, first + i});
        }
    };
    face({corners[0] + thick, corners[1] + thick, corners[2] + thick});
    face({corners[2] - thick, corners[1] - thick, corners[0] - thick});
    for (std::size_t i = 0; i < 3; ++i) {
        const Vector3& a = corners[i];
        const Vector3& b = corners[(i + 1) % 3];
        face({a - thick, b - thick, b + thick, a + thick});
    }
    part.colour = colour;
    part.roughness = 0.7;
    return outward(std::move(part));
}

}  // namespace

// Faces +z; the spars cross at the origin.
Model make_kite() {
    const Vector3 top(0.0, 0.07, 0.0);
    const Vector3 right(0.075, 0.0, 0.0);
    const Vector3 foot(0.0, -0.12, 0.0);
    const Vector3 left(-0.075, 0.0, 0.0);
    Model kite{"kite", {}, {}};
    kite.parts = {make_quarter(right, top, srgb(0xD55E00)), make_quarter(top, left, srgb(0xF6B914)),
                  make_quarter(left, foot, srgb(0x0072B2)),
                  make_quarter(foot, right, srgb(0x009E73))};
    const auto way = [&](double t) -> Vector3 {
        return foot + Vector3(0.02 * std::sin(2.5 * std::numbers::pi * t), -0.11 * t, 0.0);
    };
    MeshPart tail = outward(
        tessellate(tube(way, [](double t) { return t > 0.0 && t < 1.0 ? 0.0022 : 0.0; }), 6, 24));
    for (const double t : {0.3, 0.6, 0.9}) {
        for (const double side : {-1.0, 1.0}) {
            MeshPart wing = outward(tessellate(ellipsoid(Vector3(0.011, 0.006, 0.004)), 10, 6));
            wing.transform(Affine::at(way(t) + Vector3(side * 0.01, 0.0, 0.0)));
            tail.append(wing);
        }
    }
    tail.colour = srgb(0xD55E00);
    tail.roughness = 0.7;
    kite.parts.push_back(std::move(tail));
    return kite;
}

}  // namespace fulcrum::assets
