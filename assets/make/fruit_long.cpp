// Banana and egg.
#include "assets/make/models.h"
#include "assets/make/noise.h"
#include "assets/make/parts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fulcrum::assets {
namespace {

// ---- banana: a bent tube in the plane z = 0, v from the stem to the flower end

constexpr double kBananaLength_m = 0.18;
constexpr double kBananaBend_rad = 1.85;
constexpr double kBananaRadius_m = 0.0185;

/// Thickness along the fruit, in radii: a stem that is a little thicker where it was cut, a neck, the body, a tip.
double banana_thickness(double v) {
    const double body = std::sqrt(smooth_step(0.05, 0.42, v) * smooth_step(0.975, 0.58, v));
    const double cut = 0.05 * smooth_step(0.05, 0.0, v);
    const double closed = std::min(1.0, std::min(v, 1.0 - v) / 0.004);
    return closed * (0.25 + cut + 0.74 * body);
}

Vector3 banana_surface(double u, double v) {
    const double angle = kBananaBend_rad * (v - 0.5);
    const double bend_radius = kBananaLength_m / kBananaBend_rad;
    const Vector3 out(std::sin(angle), -std::cos(angle), 0.0);
    const Vector3 spine = bend_radius * out;
    const double around = 2.0 * std::numbers::pi * (u == 1.0 ? 0.0 : u);
    // Five soft edges; the stem and the tip are round.
    const double edges = 0.060 * smooth_step(0.05, 0.25, v) * smooth_step(1.0, 0.85, v);
    const double radius =
        kBananaRadius_m * banana_thickness(v) * (1.0 + edges * std::cos(5.0 * around));
    return spine + radius * (std::cos(around) * out + std::sin(around) * Vector3::UnitZ());
}

Colour banana_colour(double u, double v) {
    static const Colour kYellow = srgb(0xF7CF2C);
    static const Colour kPale = srgb(0xFBE27A);
    static const Colour kGreen = srgb(0xA9B53C);
    static const Colour kBrown = srgb(0x5A3A17);
    static const Colour kBlack = srgb(0x2B1C10);
    const Vector3 p = banana_surface(u, v);
    const double ragged = fractal_noise(140.0 * p, 3);
    Colour c = blend(kYellow, kPale, 0.35 + 0.7 * fractal_noise(45.0 * p, 2));
    // The edges are a little darker, the flats a little paler.
    const double edge = smooth_step(0.55, 1.0, std::cos(5.0 * 2.0 * std::numbers::pi * u));
    c = blend(c, srgb(0xD9A41E), 0.35 * edge);
    c = blend(c, kGreen, 0.75 * smooth_step(0.26, 0.10, v + 0.04 * ragged));
    c = blend(c, kGreen, 0.45 * smooth_step(0.88, 0.95, v + 0.02 * ragged));
    // Few freckles, longer along the fruit than across.
    const Vector3 stretched(60.0 * p.x(), 95.0 * p.y(), 95.0 * p.z());
    const double body = smooth_step(0.16, 0.28, v) * smooth_step(0.92, 0.84, v);
    c = blend(c, kBrown, 0.75 * body * spots(stretched, 0.10, 0.22));
    c = blend(c, kBrown, 0.35 * body * spots(3.1 * stretched, 0.10, 0.3));
    c = blend(c, kBrown, 0.8 * smooth_step(0.035, 0.012, v + 0.006 * ragged));
    c = blend(c, kBlack, smooth_step(0.945, 0.962, v + 0.010 * ragged));
    return blend(c, kBlack, smooth_step(0.008, 0.003, v));
}

// ---- egg: Huegelschaeffer's curve about the y axis, v from the pointed end down

constexpr double kEggLength_m = 0.057;
constexpr double kEggBreadth_m = 0.044;
/// How far the widest place lies from the middle.
constexpr double kEggShift_m = 0.0034;

/// Radius at height x above the middle: (B/2) sqrt((L^2 - 4x^2) / (L^2 + 8wx + 4w^2)).
/// Source: Narushin, Romanov & Griffin 2021, "Egg and math: introducing a universal formula for egg
/// shape".
double egg_radius_m(double x) {
    const double L = kEggLength_m;
    const double w = kEggShift_m;
    return 0.5 * kEggBreadth_m *
           std::sqrt(std::max(0.0, L * L - 4.0 * x * x) / (L * L + 8.0 * w * x + 4.0 * w * w));
}

Vector3 egg_surface(double u, double v) {
    const double height =
        v == 1.0 ? -0.5 * kEggLength_m : 0.5 * kEggLength_m * std::cos(std::numbers::pi * v);
    const double radius = v == 0.0 || v == 1.0 ? 0.0 : egg_radius_m(height);
    return revolve([=](double) { return Vector2(radius, height); })(u, v);
}

Colour egg_colour(double u, double v) {
    static const Colour kShell = srgb(0xE9C79C);
    static const Colour kWarm = srgb(0xDDB07F);
    const Vector3 p = egg_surface(u, v);
    Colour c = blend(kShell, kWarm, 0.45 + 0.6 * fractal_noise(60.0 * p, 3) - 8.0 * p.y());
    c = blend(c, srgb(0xF4DDBE), 0.35 * spots(420.0 * p, 0.35, 0.35));
    // Freckles gather at the blunt end.
    const double share = 0.06 + 0.20 * smooth_step(0.012, -0.022, p.y());
    c = blend(c, srgb(0x8A5A33), 0.75 * spots(260.0 * p, share, 0.30));
    return blend(c, srgb(0x7A4B28), 0.8 * spots(120.0 * p, 0.5 * share, 0.26));
}

}  // namespace

Model make_banana() {
    Model model{"banana", {}, {}};
    // Rows are closer together at both ends, where the shape changes fastest.
    const auto denser_ends = [](double v) {
        return v - 0.10 * std::sin(2.0 * std::numbers::pi * v);
    };
    MeshPart skin =
        tessellate([&](double u, double v) { return banana_surface(u, denser_ends(v)); }, 50, 80);
    for (Vector2& uv : skin.uvs) {
        uv.y() = denser_ends(uv.y());
    }
    skin.roughness = 0.5;
    skin.picture = 0;
    model.pictures.push_back(paint(512, 1024, banana_colour));
    model.parts = {outward(std::move(skin))};
    centre_on_mass(model);
    return model;
}

Model make_egg() {
    Model model{"egg", {}, {}};
    MeshPart shell = tessellate(egg_surface, 72, 56);
    shell.roughness = 0.45;
    shell.picture = 0;
    model.pictures.push_back(paint(512, 512, egg_colour));
    model.parts = {outward(std::move(shell))};
    centre_on_mass(model);
    return model;
}

}  // namespace fulcrum::assets
