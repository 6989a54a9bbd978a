// What the lesson on materials is played with: a cloth, and things that are made of metal, wood and rock.
#include "assets/make/models.h"
#include "assets/make/noise.h"
#include "assets/make/parts.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace fulcrum::assets {
namespace {

/// A closed box with rounded edges about `centre`, rounded as much as a finger notices.
MeshPart block(const Vector3& centre_m, const Vector3& half_m) {
    const Surface ball = ellipsoid(Vector3::Ones());
    const auto surface = [=](double u, double v) {
        const Vector3 unit = ball(u, v);
        const double longest = std::pow(
            unit.unaryExpr([](double x) { return std::pow(std::abs(x), 12.0); }).sum(), 1.0 / 12.0);
        return Vector3(centre_m + (unit / longest).cwiseProduct(half_m));
    };
    return outward(tessellate(surface, 28, 18));
}

/// A closed turned thing about y: its profile (radius, height) begins and ends on the axis.
MeshPart turned(std::vector<Vector2> profile, int around = 40, int along = 32) {
    return outward(tessellate(
        revolve([points = std::move(profile)](double v) { return curve_through(points, v); }),
        around, along));
}

MeshPart moved(MeshPart part, const Vector3& by_m) {
    part.transform(Affine::at(by_m));
    return part;
}

/// A flat fin that stands out from the hull, seen from the side a swept-back wing.
MeshPart fin(double turn_rad) {
    const Surface ball = ellipsoid(Vector3(0.026, 0.030, 0.004));
    const auto surface = [=](double u, double v) {
        const Vector3 p = ball(u, v) + Vector3(0.036, -0.045, 0.0);
        const Vector3 swept(p.x(), p.y() - 0.5 * p.x(), p.z());
        return Vector3(AngleAxis(turn_rad, Vector3::UnitY()) * swept);
    };
    return outward(tessellate(surface, 28, 16));
}

/// The model with one colour for what has none of its own: the material's look is what shows.
Model finish(const char* name, std::vector<MeshPart> parts) {
    return {name, std::move(parts), {}};
}

}  // namespace

Model make_cloth() {
    // Draped over a box from -1 to 1: flat on top, over a soft edge down to the floor, in folds.
    const auto surface = [](double u, double v) {
        const double angle = 2.0 * std::numbers::pi * (u == 1.0 ? 0.0 : u);
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        // A square with round corners at each height.
        const double square =
            1.0 / std::pow(std::pow(std::abs(c), 6.0) + std::pow(std::abs(s), 6.0), 1.0 / 6.0);
        const double down = std::max(0.0, v - 0.45) / 0.55;
        const double out = v < 0.45 ? v / 0.45 : 1.0;
        const double folds = down * (0.10 * std::sin(10.0 * angle) + 0.05 * std::sin(17.0 * angle));
        const double edge = smooth_step(0.85, 1.0, out);
        const double radius = square * out * (1.06 + 0.20 * down * down + folds);
        const double y = 1.07 - 0.05 * edge - 2.06 * down;
        return Vector3(radius * c, y, radius * s);
    };
    MeshPart top = tessellate(surface, 128, 36);
    if (top.normals[0].y() < 0.0) {
        top.turn_inside_out();
    }
    top.picture = 0;
    top.roughness = 0.9;
    Model model{"cloth", {std::move(top)}, {}};
    // Sky blue checks, of two brightnesses, so that its folds are seen.
    model.pictures.push_back(paint(256, 128, [](double u, double v) {
        const bool check = (static_cast<int>(u * 24.0) + static_cast<int>(v * 12.0)) % 2 == 0;
        return blend(srgb(0x7FA9D6), srgb(0x5C86BE), check ? 1.0 : 0.0);
    }));
    return model;
}

Model make_spaceship() {
    MeshPart hull = turned({{0.0, -0.075},
                            {0.016, -0.074},
                            {0.022, -0.060},
                            {0.031, -0.030},
                            {0.033, 0.005},
                            {0.027, 0.040},
                            {0.014, 0.068},
                            {0.004, 0.082},
                            {0.0, 0.084}});
    std::vector<MeshPart> parts{std::move(hull)};
    for (int i = 0; i < 3; ++i) {
        parts.push_back(fin(2.0 * std::numbers::pi * i / 3.0 + 0.5 * std::numbers::pi));
    }
    MeshPart window = moved(outward(tessellate(ellipsoid(Vector3(0.012, 0.012, 0.006)), 32, 20)),
                            {0.0, 0.022, 0.028});
    window.colour = srgb(0x35546E);
    parts.push_back(std::move(window));
    return finish("spaceship", std::move(parts));
}

Model make_table() {
    std::vector<MeshPart> parts{block({0.0, 0.048, 0.0}, {0.085, 0.009, 0.055})};
    for (const double x : {-0.068, 0.068}) {
        for (const double z : {-0.040, 0.040}) {
            parts.push_back(block({x, -0.010, z}, {0.009, 0.052, 0.009}));
        }
    }
    return finish("table", std::move(parts));
}

Model make_statue() {
    // A pawn-like figure with arms on a pedestal.
    std::vector<MeshPart> parts{block({0.0, -0.066, 0.0}, {0.042, 0.014, 0.042})};
    parts.push_back(turned({{0.0, -0.056},
                            {0.028, -0.055},
                            {0.026, -0.030},
                            {0.018, 0.0},
                            {0.024, 0.026},
                            {0.012, 0.040},
                            {0.0, 0.042}}));
    parts.push_back(
        moved(outward(tessellate(ellipsoid(Vector3(0.016, 0.020, 0.016)), 32, 20)), {0, 0.056, 0}));
    for (const double side : {-1.0, 1.0}) {
        const Surface arm = tube(
            [=](double t) {
                return Vector3(side * (0.020 + 0.018 * std::sin(std::numbers::pi * t)),
                               0.030 - 0.052 * t, 0.012 * t);
            },
            [](double t) {
                return 0.0075 * std::sqrt(std::max(0.0, 1.0 - std::pow(2 * t - 1, 8)));
            });
        parts.push_back(outward(tessellate(arm, 20, 24)));
    }
    return finish("statue", std::move(parts));
}

Model make_bell() {
    std::vector<MeshPart> parts{turned({{0.0, -0.030},
                                        {0.040, -0.044},
                                        {0.048, -0.050},
                                        {0.040, -0.030},
                                        {0.030, 0.0},
                                        {0.024, 0.028},
                                        {0.010, 0.042},
                                        {0.0, 0.044}})};
    parts.push_back(
        moved(outward(tessellate(ellipsoid(Vector3(0.011, 0.011, 0.011)), 24, 16)), {0, 0.050, 0}));
    return finish("bell", std::move(parts));
}

Model make_chair() {
    std::vector<MeshPart> parts{block({0.0, -0.005, 0.0}, {0.042, 0.007, 0.042}),
                                block({0.0, 0.045, -0.036}, {0.042, 0.045, 0.006})};
    for (const double x : {-0.034, 0.034}) {
        for (const double z : {-0.034, 0.034}) {
            parts.push_back(block({x, -0.045, z}, {0.007, 0.038, 0.007}));
        }
    }
    return finish("chair", std::move(parts));
}

Model make_castle() {
    std::vector<MeshPart> parts{block({0.0, -0.030, 0.0}, {0.060, 0.040, 0.045})};
    for (const double x : {-0.055, 0.055}) {
        parts.push_back(turned({{0.0, -0.070},
                                {0.022, -0.069},
                                {0.020, -0.030},
                                {0.019, 0.030},
                                {0.026, 0.034},
                                {0.026, 0.048},
                                {0.010, 0.070},
                                {0.0, 0.076}}));
        parts.back() = moved(std::move(parts.back()), {x, 0.0, 0.02});
    }
    for (const double x : {-0.024, 0.0, 0.024}) {
        parts.push_back(block({x, 0.015, 0.036}, {0.008, 0.010, 0.008}));
    }
    return finish("castle", std::move(parts));
}

}  // namespace fulcrum::assets
