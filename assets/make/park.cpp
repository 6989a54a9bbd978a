// Who walks in the maze park, and what is found there.
#include "assets/make/models.h"
#include "assets/make/parts.h"

#include <numbers>

namespace fulcrum::assets {
namespace {

/// A part turned on a lathe about the upright axis, from its top to its foot: {radius, height} in metres.
MeshPart turned(const std::vector<Vector2>& outline, Colour colour, double roughness) {
    const auto profile = [outline](double v) { return curve_through(outline, v); };
    MeshPart part = outward(tessellate(revolve(profile), 32, 22));
    part.colour = colour;
    part.roughness = roughness;
    return part;
}

}  // namespace

Model make_walker() {
    MeshPart coat = turned({{0.0, 0.041},
                            {0.006, 0.040},
                            {0.010, 0.033},
                            {0.015, 0.012},
                            {0.0175, 0.002},
                            {0.016, 0.0},
                            {0.0, 0.0}},
                           srgb(0xD8472B), 0.7);
    MeshPart head = outward(tessellate(ellipsoid(Vector3(0.011, 0.012, 0.011)), 24, 14));
    head.transform(Affine::at({0.0, 0.050, 0.0}));
    head.colour = srgb(0xC98F62);
    head.roughness = 0.6;
    MeshPart hat = turned({{0.0, 0.070},
                           {0.006, 0.069},
                           {0.009, 0.064},
                           {0.010, 0.058},
                           {0.020, 0.056},
                           {0.020, 0.0545},
                           {0.0, 0.0545}},
                          srgb(0xF2D27A), 0.8);
    return {"walker", {std::move(coat), std::move(head), std::move(hat)}, {}};
}

Model make_gem() {
    constexpr int kSides = 6;
    constexpr double kRadius_m = 0.022;
    constexpr double kHeight_m = 0.030;
    constexpr double kCrown_m = 0.012;  // half the belt's own height
    // Flat faces: no two share a corner.
    MeshPart gem;
    const auto corner = [](int side, double y_m) {
        const double angle = 2.0 * std::numbers::pi * side / kSides;
        return Vector3(kRadius_m * std::sin(angle), y_m, kRadius_m * std::cos(angle));
    };
    const auto add = [&gem](const Vector3& a, const Vector3& b, const Vector3& c) {
        const Vector3 normal = (b - a).cross(c - a).normalized();
        for (const Vector3& at : {a, b, c}) {
            gem.indices.push_back(static_cast<std::uint32_t>(gem.positions.size()));
            gem.positions.push_back(at);
            gem.normals.push_back(normal);
            gem.uvs.emplace_back(0.5, 0.5);
        }
    };
    const double up_m = 0.5 * kCrown_m;
    for (int side = 0; side < kSides; ++side) {
        const int next = (side + 1) % kSides;
        add({0.0, kHeight_m, 0.0}, corner(side, up_m), corner(next, up_m));
        add({0.0, -kHeight_m, 0.0}, corner(next, -up_m), corner(side, -up_m));
        add(corner(side, up_m), corner(side, -up_m), corner(next, -up_m));
        add(corner(side, up_m), corner(next, -up_m), corner(next, up_m));
    }
    gem.colour = srgb(0x8A3FD1);
    gem.roughness = 0.15;
    return {"gem", {std::move(gem)}, {}};
}

}  // namespace fulcrum::assets
