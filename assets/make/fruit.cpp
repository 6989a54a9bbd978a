// Watermelon and apple.
#include "assets/make/models.h"
#include "assets/make/noise.h"
#include "assets/make/parts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fulcrum::assets {
namespace {

// ---- watermelon: lies along x; v runs from its stalk (+x) to its flower end

const Vector3 kMelonRadii_m{0.095, 0.083, 0.086};

Vector3 melon_surface(double u, double v) {
    const Vector3 unit = ellipsoid(Vector3::Ones())(u, v);
    // A little fuller than an ellipsoid, and a shallow dip where the stalk sits.
    const double along = unit.y();
    const double ring = std::sqrt(std::max(0.0, 1.0 - along * along));
    const double full = 1.0 + 0.045 * ring * ring * along * along;
    const double dip = 1.0 - 0.05 * std::exp(-20.0 * (1.0 - std::abs(along)));
    return {kMelonRadii_m.x() * along * dip, kMelonRadii_m.y() * unit.z() * full,
            kMelonRadii_m.z() * unit.x() * full};
}

Colour melon_colour(double u, double v) {
    static const Colour kLight = srgb(0x9CC653);
    static const Colour kPale = srgb(0xC2DC7E);
    static const Colour kDark = srgb(0x1E5A22);
    static const Colour kDeep = srgb(0x0F3B17);
    const Vector3 p = melon_surface(u, v);
    // Ten bands along the melon, their edges pushed about by coarse and fine noise, narrow towards
    // the ends.
    const double wobble = 0.75 * fractal_noise(32.0 * p, 3) + 0.50 * fractal_noise(110.0 * p, 3);
    const double band = std::cos(10.0 * 2.0 * std::numbers::pi * u + 1.9 * wobble);
    const double dark = smooth_step(-0.02, 0.22, band + 0.25 * fractal_noise(260.0 * p, 2));
    const Colour between = blend(kLight, kPale, 0.5 + 0.9 * fractal_noise(70.0 * p, 3));
    const Colour stripe = blend(kDark, kDeep, 0.5 + 0.9 * fractal_noise(90.0 * p, 3));
    // Thin dark veins run through the light bands.
    const double vein = smooth_step(0.80, 0.98, 1.0 - std::abs(fractal_noise(55.0 * p, 3)) * 3.0);
    const Colour light = blend(between, kDark, 0.30 * vein);
    // Around the stalk and the flower end the skin is paler.
    const double end = smooth_step(0.90, 0.99, std::abs(p.x()) / kMelonRadii_m.x());
    return blend(blend(light, stripe, dark), kPale, 0.55 * end);
}

MeshPart melon_stalk() {
    const auto curve = [](double t) {
        return Vector3(0.086 + 0.030 * t - 0.008 * t * t, 0.026 * t * t, 0.0);
    };
    const auto radius = [](double t) {
        const double closed = std::sqrt(std::clamp((1.0 - t) / 0.12, 0.0, 1.0));
        return (0.0085 - 0.0035 * smooth_step(0.0, 0.5, t)) * closed;
    };
    MeshPart stalk = tessellate(tube(curve, radius), 16, 14);
    stalk.colour = srgb(0x7A6A2E);
    stalk.roughness = 0.9;
    return stalk;
}

// ---- apple: profile (radius, height) from the top dimple to the bottom one, in radii

constexpr double kAppleRadius_m = 0.04;

Vector2 apple_profile(double v) {
    static const std::vector<Vector2> kProfile{
        {0.0, 0.50},   {0.07, 0.53},  {0.20, 0.70},   {0.40, 0.80},  {0.64, 0.77},
        {0.86, 0.58},  {0.98, 0.27},  {0.995, -0.05}, {0.90, -0.38}, {0.72, -0.66},
        {0.52, -0.83}, {0.34, -0.88}, {0.17, -0.80},  {0.0, -0.70}};
    Vector2 p = curve_through(kProfile, v);
    p.x() = std::max(p.x(), 0.0);
    return p;
}

Vector3 apple_surface(double u, double v) {
    const Vector3 p = revolve(apple_profile)(u, v);
    // Five soft lobes, plainest at the bottom.
    const double lobes =
        1.0 + 0.035 * smooth_step(0.2, -0.9, p.y()) * std::cos(2.0 * std::numbers::pi * 5.0 * u);
    const double lean = 1.0 + 0.03 * p.x();
    return kAppleRadius_m * Vector3(p.x() * lobes, p.y() * lean, p.z() * lobes);
}

Colour apple_colour(double u, double v) {
    static const Colour kRed = srgb(0xC8161D);
    static const Colour kDarkRed = srgb(0x8E0B17);
    static const Colour kYellow = srgb(0xF2C230);
    static const Colour kGreen = srgb(0xB5B83A);
    const Vector3 p = apple_surface(u, v) / kAppleRadius_m;
    const double ring = std::hypot(p.x(), p.z());
    // Streaks run from pole to pole: noise that is stretched along the meridian.
    const Vector3 meridian(9.0 * p.x() / std::max(ring, 0.15), 1.2 * p.y(),
                           9.0 * p.z() / std::max(ring, 0.15));
    const double streak = fractal_noise(meridian, 3);
    const double shade = fractal_noise(1.6 * p, 2);
    // One cheek saw less sun, and the skin around the stem is yellow-green.
    const double cheek =
        smooth_step(0.25, 1.0, 0.75 * p.x() - 0.35 * p.z() + 0.30 * shade + 0.2 * streak);
    const double crown =
        smooth_step(0.48, 0.12, ring + 0.10 * streak) * smooth_step(0.2, 0.5, p.y());
    Colour c = blend(kRed, kDarkRed, 0.35 + 0.9 * streak);
    c = blend(c, kYellow, 0.85 * cheek * smooth_step(0.08, 0.4, ring) * (0.75 + 0.8 * streak));
    c = blend(c, blend(kYellow, kGreen, 0.6), crown);
    const double below = smooth_step(-0.62, -0.85, p.y()) * smooth_step(0.6, 0.2, ring);
    c = blend(c, kGreen, 0.7 * below);
    return blend(c, srgb(0xF6DDA0), 0.55 * spots(13.0 * p, 0.45, 0.16));
}

MeshPart apple_stem() {
    const auto curve = [](double t) {
        return Vector3(0.004 * t + 0.006 * t * t, 0.019 + 0.026 * t, 0.0);
    };
    const auto radius = [](double t) {
        const double closed = std::sqrt(std::clamp((1.0 - t) / 0.06, 0.0, 1.0));
        return (0.0016 + 0.0011 * smooth_step(0.7, 1.0, t)) * closed;
    };
    MeshPart stem = tessellate(tube(curve, radius), 12, 16);
    stem.colour = srgb(0x5B3A1E);
    stem.roughness = 0.9;
    return stem;
}

}  // namespace

Model make_watermelon() {
    Model model{"watermelon", {}, {}};
    MeshPart skin = tessellate(melon_surface, 96, 60);
    skin.roughness = 0.38;
    skin.picture = 0;
    model.pictures.push_back(paint(1024, 512, melon_colour));
    model.parts = {outward(std::move(skin)), outward(melon_stalk())};
    centre_on_mass(model);
    return model;
}

Model make_apple() {
    Model model{"apple", {}, {}};
    MeshPart skin = tessellate(apple_surface, 80, 64);
    skin.roughness = 0.28;
    skin.picture = 0;
    model.pictures.push_back(paint(768, 512, apple_colour));
    MeshPart leaf = make_leaf(0.040, 0.020);
    Affine X = Affine::Identity();
    X.translate(Vector3(0.0055, 0.036, 0.0));
    X.rotate(AngleAxis(0.55, Vector3::UnitY()));
    X.rotate(AngleAxis(0.30, Vector3::UnitZ()));
    X.rotate(AngleAxis(0.45, Vector3::UnitX()));
    leaf.transform(X);
    leaf.picture = 1;
    model.pictures.push_back(paint_leaf());
    model.parts = {outward(std::move(skin)), outward(apple_stem()), std::move(leaf)};
    centre_on_mass(model);
    return model;
}

}  // namespace fulcrum::assets
