// Ground, hill, tree, cloud, flower.
#include "assets/make/models.h"
#include "assets/make/noise.h"
#include "assets/make/parts.h"

#include <cmath>
#include <numbers>

namespace fulcrum::assets {
namespace {

Colour grass(const Vector3& p) {
    const double patch = fractal_noise(1.3 * p, 3);
    const double blades = fractal_noise(22.0 * p, 3);
    const Colour meadow = blend(srgb(0x7DB85A), srgb(0x5E9E48), 0.5 + 0.8 * patch);
    return blend(meadow, srgb(0xA9CB78), 0.20 + 0.40 * blades);
}

/// Bark along the trunk.
Colour bark(double u, double v) {
    const double furrow = fractal_noise({10.0 * std::sin(2.0 * std::numbers::pi * u), 3.0 * v,
                                         10.0 * std::cos(2.0 * std::numbers::pi * u)},
                                        3);
    return blend(srgb(0x8A5F3C), srgb(0x5D3D26), 0.5 + 0.9 * furrow);
}

Colour leaves(double u, double v) {
    const Vector3 p = ellipsoid(Vector3::Ones())(u, v);
    const double clump = fractal_noise(5.0 * p, 3);
    const double fine = spots(16.0 * p, 0.5, 0.42);
    return blend(blend(srgb(0x4F9E3A), srgb(0x3B8030), 0.5 + 0.9 * clump), srgb(0x8CC74F),
                 0.45 * fine);
}

MeshPart flattened_disc(double radius_m, const Surface& height) {
    // u around, v from the middle outwards; rows are closer together in the middle.
    MeshPart disc = tessellate(
        [&](double u, double v) {
            const double angle = 2.0 * std::numbers::pi * (u == 1.0 ? 0.0 : u);
            const double r = radius_m * std::pow(v, 1.4);
            const Vector3 p(r * std::sin(angle), 0.0, r * std::cos(angle));
            return Vector3(p + height(p.x(), p.z()));
        },
        64, 32);
    for (std::size_t i = 0; i < disc.uvs.size(); ++i) {
        const Vector3 p = disc.positions[i] / (2.0 * radius_m);
        disc.uvs[i] = {0.5 + p.x(), 0.5 + p.z()};
    }
    if (disc.normals.front().y() < 0.0) {
        disc.turn_inside_out();
    }
    disc.picture = 0;
    disc.roughness = 0.95;
    return disc;
}

Model on_grass(const char* name, MeshPart part, double radius_m) {
    Model model{name, {}, {}};
    model.pictures.push_back(paint(512, 512, [radius_m](double u, double v) {
        return grass(2.0 * radius_m * Vector3(u - 0.5, 0.0, v - 0.5));
    }));
    model.parts = {std::move(part)};
    return model;
}

/// Several balls as one part; each has its own centre and radii.
struct Ball {
    Vector3 centre_m;
    Vector3 radii_m;
};
MeshPart heap(const std::vector<Ball>& balls, double bump, int columns, int rows) {
    MeshPart all;
    for (const Ball& ball : balls) {
        all.append(make_blob(ball.centre_m, ball.radii_m, bump, columns, rows));
    }
    return all;
}

}  // namespace

Model make_ground() {
    // Flat where things fall, gently uneven far out.
    constexpr double kRadius_m = 4.0;
    const auto height = [](double x, double z) {
        const double far = smooth_step(1.2, 3.5, std::hypot(x, z));
        return Vector3(0.0, far * (0.10 + 0.16 * fractal_noise({0.7 * x, 0.0, 0.7 * z}, 2)), 0.0);
    };
    return on_grass("ground", flattened_disc(kRadius_m, height), kRadius_m);
}

Model make_hill() {
    constexpr double kRadius_m = 1.5;
    const auto height = [](double x, double z) {
        const double r = std::hypot(x, z) / kRadius_m;
        const double dome = std::pow(1.0 - std::min(r * r, 1.0), 2.0);
        return Vector3(0.0, 0.50 * dome + 0.05 * dome * fractal_noise({2.0 * x, 0.0, 2.0 * z}, 2),
                       0.0);
    };
    return on_grass("hill", flattened_disc(kRadius_m, height), kRadius_m);
}

Model make_tree() {
    Model model{"tree", {}, {}};
    model.pictures = {paint(128, 256, bark), paint(512, 256, leaves)};
    const auto trunk_curve = [](double t) {
        return Vector3(0.03 * std::sin(2.4 * t), 0.72 * t, 0.0);
    };
    const auto trunk_radius = [](double t) {
        return 0.055 + 0.045 * std::exp(-7.0 * t) - 0.015 * t;
    };
    MeshPart trunk = outward(tessellate(tube(trunk_curve, trunk_radius), 28, 24));
    trunk.picture = 0;
    trunk.roughness = 0.95;
    MeshPart crown = heap({{{0.02, 0.86, 0.0}, {0.27, 0.24, 0.26}},
                           {{-0.21, 0.72, 0.05}, {0.19, 0.17, 0.18}},
                           {{0.24, 0.74, 0.02}, {0.19, 0.17, 0.18}},
                           {{0.03, 0.71, 0.19}, {0.19, 0.16, 0.17}},
                           {{0.0, 0.72, -0.19}, {0.19, 0.16, 0.17}},
                           {{0.04, 1.05, 0.01}, {0.17, 0.15, 0.16}}},
                          0.16, 36, 24);
    crown.picture = 1;
    crown.roughness = 0.9;
    model.parts = {std::move(trunk), std::move(crown)};
    return model;
}

Model make_cloud() {
    MeshPart cloud = heap({{{0.0, 0.02, 0.0}, {0.15, 0.10, 0.10}},
                           {{-0.15, -0.01, 0.01}, {0.10, 0.07, 0.08}},
                           {{0.15, -0.01, 0.0}, {0.11, 0.075, 0.08}},
                           {{-0.07, 0.07, -0.01}, {0.09, 0.08, 0.08}},
                           {{0.08, 0.06, 0.01}, {0.10, 0.085, 0.08}}},
                          0.05, 32, 22);
    cloud.roughness = 1.0;
    return {"cloud", {std::move(cloud)}, {}};
}

Model make_flower() {
    constexpr double kHeight_m = 0.085;
    const auto stalk_curve = [](double t) { return Vector3(0.006 * t * t, kHeight_m * t, 0.0); };
    MeshPart green = outward(tessellate(tube(stalk_curve, [](double) { return 0.0016; }), 10, 10));
    MeshPart leaf = make_leaf(0.035, 0.012);
    Affine at_foot = Affine::at({0.0, 0.012, 0.0});
    at_foot.rotate(AngleAxis(0.7, Vector3::UnitZ()));
    leaf.transform(at_foot);
    green.append(leaf);
    green.colour = srgb(0x4C9A3A);

    // The head looks forwards and up.
    Affine head = Affine::at({0.006, kHeight_m, 0.0});
    head.rotate(AngleAxis(0.9, Vector3::UnitX()));
    MeshPart petals;
    constexpr int kPetals = 9;
    for (int i = 0; i < kPetals; ++i) {
        MeshPart petal = outward(tessellate(ellipsoid({0.0095, 0.0018, 0.0055}), 16, 10));
        Affine X(head);
        X.rotate(AngleAxis(2.0 * std::numbers::pi * i / kPetals, Vector3::UnitY()));
        X.translate(Vector3(0.0135, 0.0, 0.0));
        petal.transform(X);
        petals.append(petal);
    }
    petals.colour = srgb(0xFFFFFF);
    MeshPart heart = outward(tessellate(ellipsoid({0.0068, 0.0042, 0.0068}), 20, 12));
    heart.transform(head);
    heart.colour = srgb(0xF2B01E);
    return {"flower", {std::move(green), std::move(petals), std::move(heart)}, {}};
}

}  // namespace fulcrum::assets
