#include "assets/make/parts.h"

#include "assets/make/noise.h"

#include <cmath>
#include <numbers>

namespace fulcrum::assets {

MeshPart outward(MeshPart part) {
    if (bulk_of(part).volume_m3 < 0.0) {
        part.turn_inside_out();
    }
    return part;
}

void centre_on_mass(Model& model) {
    const Vector3 centre = bulk_of(model.parts.front()).centroid;
    for (MeshPart& part : model.parts) {
        part.transform(Affine::at(-centre));
    }
}

MeshPart make_leaf(double length_m, double width_m) {
    // Two sheets that meet at the rim, each smooth in itself: u along the leaf, v across it.
    const auto sheet = [=](double side) {
        return [=](double u, double v) {
            const double outline = std::sin(std::numbers::pi * std::pow(u, 0.8));
            const double across = 2.0 * v - 1.0;
            const double half_width = 0.5 * width_m * std::max(outline, 0.0);
            const double thickness = 0.02 * length_m * (1.0 - across * across) * outline;
            const double cup = 0.22 * width_m * across * across - 0.16 * length_m * u * u;
            return Vector3(length_m * u, cup + side * thickness, half_width * across);
        };
    };
    MeshPart leaf = tessellate(sheet(1.0), 24, 12);
    MeshPart under = tessellate(sheet(-1.0), 24, 12);
    const std::size_t middle = leaf.normals.size() / 2;
    (leaf.normals[middle].y() < 0.0 ? leaf : under).turn_inside_out();
    leaf.append(under);
    leaf.roughness = 0.55;
    return leaf;
}

Picture paint_leaf() {
    return paint(128, 64, [](double u, double v) {
        const double across = std::abs(2.0 * v - 1.0);
        const double rib = smooth_step(0.10, 0.03, across);
        // Side veins leave the rib slanting towards the tip.
        const double phase = 9.0 * (u - 0.35 * across);
        const double vein = smooth_step(0.12, 0.03, std::abs(phase - std::floor(phase) - 0.5));
        const Colour green =
            blend(srgb(0x3F8F2E), srgb(0x2C6E22), 0.5 + fractal_noise({9.0 * u, 9.0 * v, 0.5}, 2));
        return blend(green, srgb(0xA8D06A), std::max(0.8 * rib, 0.35 * vein));
    });
}

MeshPart make_blob(const Vector3& centre_m, const Vector3& radii_m, double bump, int columns,
                   int rows) {
    const Surface ball = ellipsoid(Vector3::Ones());
    const auto surface = [=](double u, double v) {
        const Vector3 unit = ball(u, v);
        const double swell = 1.0 + bump * fractal_noise(2.6 * unit + 31.0 * centre_m, 3);
        return Vector3(centre_m + swell * unit.cwiseProduct(radii_m));
    };
    return outward(tessellate(surface, columns, rows));
}

}  // namespace fulcrum::assets
