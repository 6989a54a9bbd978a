// The Sun and its planets, each a ball of 1 m radius drawn at a body's radius, and the lever with a toy Earth.
//
// Their surfaces are painted from noise, with what a telescope shows of each: craters, bands, storms, ice at the poles. Where
// the Earth's land lies is drawn by hand on a grid of ten degrees, and its coasts are made ragged by noise.
#include "assets/make/planets.h"

#include "assets/make/models.h"
#include "assets/make/noise.h"
#include "assets/make/parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

namespace fulcrum::assets {
namespace {

// A colour at a place of the unit ball, +Y its north pole.
using Painter = Colour (*)(const Vector3& p);

// Land on a grid of ten degrees: rows from the north pole, columns from 180 degrees west.
constexpr std::array<std::string_view, 18> kLand{
    "..........######....................", "......#####.####........#..###......",
    "#########.##.#..#..#################", ".....####.##.....###############.#..",
    "......######.....################...", "......#####......##.############....",
    ".......##........#######.#####......", "........##......#######..#..#.#.....",
    "..........###....######....#.#......", "..........#####....###......#..##...",
    "...........###.....####.......###...", "...........###.....###.......#####..",
    "...........##......##..........##..#", "...........#......................#.",
    "...........#........................", "...........##........#############..",
    "..###########...###################.", "####################################"};

double land_at(int row, int column) {
    const auto y = static_cast<std::size_t>(std::clamp(row, 0, 17));
    const auto x = static_cast<std::size_t>((column % 36 + 36) % 36);
    return kLand[y][x] == '#' ? 1.0 : 0.0;
}

// 0 on the sea to 1 on land, smooth between the grid's middles.
double land(const Vector3& p) {
    const double latitude = std::asin(std::clamp(p.y(), -1.0, 1.0));
    const double longitude = std::atan2(-p.z(), p.x());
    const double row = (0.5 - latitude / std::numbers::pi) * 18.0 - 0.5;
    const double column = (0.5 + longitude / (2.0 * std::numbers::pi)) * 36.0 - 0.5;
    const int y = static_cast<int>(std::floor(row));
    const int x = static_cast<int>(std::floor(column));
    const double fy = row - y;
    const double fx = column - x;
    return (1.0 - fy) * ((1.0 - fx) * land_at(y, x) + fx * land_at(y, x + 1)) +
           fy * ((1.0 - fx) * land_at(y + 1, x) + fx * land_at(y + 1, x + 1));
}

// Round holes of several sizes: dark floors, light rims.
double craters(const Vector3& p) {
    double shade = 0.0;
    for (const double scale : {4.0, 9.0, 19.0}) {
        const Vector3 q = scale * p + Vector3::Constant(31.0 + scale);
        const double floor = spots(q, 0.55, 0.34);
        const double rim = spots(q, 0.55, 0.44) - floor;
        shade += 0.5 * rim - 0.75 * floor;
    }
    return std::clamp(shade, -1.0, 1.0);
}

// Bands along the parallels, made wavy: 0 to 1.
double bands(const Vector3& p, double number, double waves) {
    const double wave = waves * fractal_noise({3.0 * p.x(), 9.0 * p.y(), 3.0 * p.z()}, 4);
    return 0.5 + 0.5 * std::sin(number * (p.y() + wave));
}

Colour paint_sun(const Vector3& p) {
    const double grain = 0.5 + 0.5 * fractal_noise(9.0 * p, 4);
    const double dark = spots(5.0 * p + Vector3::Constant(3.0), 0.10, 0.20);
    return blend(blend(srgb(0xF59B1E), srgb(0xFFE680), grain), srgb(0xA85A10), 0.8 * dark);
}

Colour paint_mercury(const Vector3& p) {
    const Colour ground =
        blend(srgb(0x7D756C), srgb(0xA89F93), 0.5 + 0.5 * fractal_noise(5.0 * p, 4));
    const double pit = craters(p);
    return pit > 0.0 ? blend(ground, srgb(0xD8D0C4), pit)
                     : blend(ground, srgb(0x4A453F), -0.8 * pit);
}

Colour paint_venus(const Vector3& p) {
    const double swirl = fractal_noise({2.0 * p.x() + p.y(), 5.0 * p.y(), 2.0 * p.z() - p.y()}, 5);
    return blend(srgb(0xC98F45), srgb(0xF4DDA6), std::clamp(0.5 + 0.8 * swirl, 0.0, 1.0));
}

Colour paint_mars(const Vector3& p) {
    const double dark = smooth_step(0.05, 0.45, fractal_noise(2.6 * p + Vector3::Constant(7.0), 5));
    Colour ground = blend(srgb(0xC96B3B), srgb(0x7A3B22), dark);
    ground = blend(ground, srgb(0xE09A66), 0.4 + 0.4 * fractal_noise(14.0 * p, 3));
    const double ragged = 0.05 * fractal_noise(8.0 * p, 3);
    const double ice =
        smooth_step(0.90, 0.95, p.y() + ragged) + smooth_step(0.94, 0.97, -p.y() + ragged);
    return blend(ground, srgb(0xF7F3EE), std::min(ice, 1.0));
}

Colour paint_jupiter(const Vector3& p) {
    const double band = bands(p, 17.0, 0.06);
    Colour cloud = blend(srgb(0xA86F4A), srgb(0xEFE0C4), band);
    cloud = blend(cloud, srgb(0xC99A72),
                  0.35 + 0.3 * fractal_noise({4.0 * p.x(), 20.0 * p.y(), 4.0 * p.z()}, 4));
    // The great red spot, 22 degrees south.
    const double latitude = (std::asin(std::clamp(p.y(), -1.0, 1.0)) + 0.38) / 0.14;
    const double longitude = (std::atan2(p.z(), p.x()) - 1.2) / 0.26;
    return blend(cloud, srgb(0xB5472D),
                 1.0 - smooth_step(0.6, 1.0, std::hypot(latitude, longitude)));
}

Colour paint_saturn(const Vector3& p) {
    return blend(srgb(0xC6A66B), srgb(0xF0DFB0), bands(p, 14.0, 0.012));
}

Colour paint_uranus(const Vector3& p) {
    return blend(srgb(0x9ED6DC), srgb(0xC8EEF0), 0.5 + 0.3 * p.y() + 0.1 * bands(p, 9.0, 0.01));
}

Colour paint_neptune(const Vector3& p) {
    Colour cloud = blend(srgb(0x2F5FC4), srgb(0x5B8DE8), bands(p, 8.0, 0.05));
    const double white =
        smooth_step(0.35, 0.6, fractal_noise({3.0 * p.x(), 16.0 * p.y(), 3.0 * p.z()}, 4));
    cloud = blend(cloud, srgb(0xE6EEFA), 0.7 * white);
    const double latitude = (std::asin(std::clamp(p.y(), -1.0, 1.0)) + 0.35) / 0.13;
    const double longitude = (std::atan2(p.z(), p.x()) - 1.0) / 0.22;
    return blend(cloud, srgb(0x1B3A86),
                 1.0 - smooth_step(0.6, 1.0, std::hypot(latitude, longitude)));
}

// Saturn's rings: flat, with the dark division between the two bright ones.
MeshPart make_rings() {
    constexpr double kInner = 1.24;
    constexpr double kOuter = 2.27;
    constexpr double kHalfThick = 0.006;
    MeshPart rings =
        outward(tessellate(revolve([](double v) {
                               // Out along the top, back along the bottom.
                               const double way = v < 0.5 ? 2.0 * v : 2.0 - 2.0 * v;
                               const double side = std::sin(2.0 * std::numbers::pi * v);
                               return Vector2(kInner + (kOuter - kInner) * way, kHalfThick * side);
                           }),
                           96, 24));
    rings.roughness = 0.8;
    rings.picture = 1;
    return rings;
}

Picture paint_rings() {
    return paint(4, 512, [](double, double v) {
        const double r = 1.24 + 1.03 * (v < 0.5 ? 2.0 * v : 2.0 - 2.0 * v);
        const double fine = 0.5 + 0.5 * noise({60.0 * r, 0.5, 0.5});
        Colour ice = blend(srgb(0xB79C6E), srgb(0xF2E4C4), fine);
        ice = blend(srgb(0x7C6A4C), ice, smooth_step(1.45, 1.58, r));  // the dim inner ring
        const double gap = smooth_step(1.93, 1.96, r) - smooth_step(2.01, 2.04, r);  // Cassini's
        return blend(ice, srgb(0x3A3226), gap);
    });
}

Model make_ball_of(const char* name, Painter painter) {
    const Surface ball = ellipsoid(Vector3::Ones());
    MeshPart part = outward(tessellate(ball, 64, 44));
    part.roughness = 0.75;
    part.picture = 0;
    return {name,
            {std::move(part)},
            {paint(1024, 512, [&](double u, double v) { return painter(ball(u, v)); })}};
}

// A beam of wood along x, 1.16 m long, its middle in the origin.
MeshPart make_beam() {
    const Vector3 half(0.58, 0.02, 0.05);
    const auto surface = [half](double u, double v) {
        const Vector3 unit = ellipsoid(Vector3::Ones())(u, v);
        const double longest = std::pow(
            unit.unaryExpr([](double x) { return std::pow(std::abs(x), 14.0); }).sum(), 1.0 / 14.0);
        return Vector3((unit / longest).cwiseProduct(half));
    };
    MeshPart beam = outward(tessellate(surface, 96, 48));
    beam.colour = srgb(0xC58F52);
    beam.roughness = 0.7;
    return beam;
}

}  // namespace

Colour paint_earth(const Vector3& p) {
    const double ragged = 0.30 * fractal_noise(7.0 * p, 5);
    const double shore = land(p) + ragged;
    const double latitude = std::abs(p.y());
    const Colour sea = blend(srgb(0x1C5FA8), srgb(0x2F86C9), 0.5 + 0.5 * fractal_noise(3.0 * p, 3));
    // Green where it rains, sand in the belts of deserts, grey-green towards the poles.
    const double dry =
        smooth_step(0.28, 0.40, latitude) * (1.0 - smooth_step(0.48, 0.60, latitude));
    Colour ground = blend(srgb(0x3E8F3A), srgb(0xD9BC7A),
                          std::clamp(0.75 * dry + 0.5 * fractal_noise(4.0 * p, 3), 0.0, 1.0));
    ground = blend(ground, srgb(0x6F8C5C), smooth_step(0.75, 0.88, latitude));
    Colour colour = blend(sea, ground, smooth_step(0.47, 0.53, shore));
    const double ice = smooth_step(0.93, 0.97, latitude + 0.2 * ragged * (1.0 - latitude)) +
                       (p.y() < -0.86 ? smooth_step(0.45, 0.55, shore) : 0.0);
    colour = blend(colour, srgb(0xF6FAFC), std::min(ice, 1.0));
    const double cloud =
        smooth_step(0.22, 0.55, fractal_noise({3.0 * p.x(), 6.0 * p.y(), 3.0 * p.z()}, 5));
    return blend(colour, srgb(0xFFFFFF), 0.75 * cloud);
}

Model make_sun() {
    return make_ball_of("sun", paint_sun);
}
Model make_mercury() {
    return make_ball_of("mercury", paint_mercury);
}
Model make_venus() {
    return make_ball_of("venus", paint_venus);
}
Model make_earth() {
    return make_ball_of("earth", paint_earth);
}
Model make_mars() {
    return make_ball_of("mars", paint_mars);
}
Model make_jupiter() {
    return make_ball_of("jupiter", paint_jupiter);
}
Model make_uranus() {
    return make_ball_of("uranus", paint_uranus);
}
Model make_neptune() {
    return make_ball_of("neptune", paint_neptune);
}

Model make_saturn() {
    Model saturn = make_ball_of("saturn", paint_saturn);
    saturn.parts.push_back(make_rings());
    saturn.pictures.push_back(paint_rings());
    return saturn;
}

Model make_lever() {
    Model lever = make_earth();
    lever.name = "lever";
    // The toy Earth stands on the left end.
    constexpr double kRadius_m = 0.10;
    Affine to_end = Affine::Identity();
    to_end.translate(Vector3(-0.5, 0.02 + 0.97 * kRadius_m, 0.0));
    to_end.scale(kRadius_m);
    lever.parts[0].transform(to_end);
    lever.parts.push_back(make_beam());
    return lever;
}

Model make_support() {
    // A wedge whose edge lies along z in the origin, 0.3 m tall.
    const auto surface = [](double u, double v) {
        const Vector3 unit = ellipsoid(Vector3::Ones())(u, v);
        const double longest = std::pow(
            unit.unaryExpr([](double x) { return std::pow(std::abs(x), 14.0); }).sum(), 1.0 / 14.0);
        const Vector3 box = unit / longest;
        const double width = 0.006 + 0.07 * (0.5 - 0.5 * box.y());
        return Vector3(width * box.x(), -0.15 + 0.15 * box.y(), 0.09 * box.z());
    };
    MeshPart wedge = outward(tessellate(surface, 64, 48));
    wedge.colour = srgb(0x5B7F95);
    wedge.roughness = 0.6;
    return {"support", {std::move(wedge)}, {}};
}

Model make_handles() {
    constexpr double kReach_m = 0.24;
    constexpr double kHalf_m = 0.015;  // of a spoke's width
    constexpr double kHalfHeight_m = 0.05;
    MeshPart part;
    // A rectangle from corner to corner, counter-clockwise as seen from outside.
    const auto add = [&](const std::array<Vector3, 4>& corners) {
        const auto first = static_cast<std::uint32_t>(part.positions.size());
        for (const Vector3& corner : corners) {
            part.positions.push_back(corner);
            part.normals.push_back(
                (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized());
            part.uvs.emplace_back(0.5, 0.5);
        }
        for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U}) {
            part.indices.push_back(first + corner);
        }
    };
    const Vector3 up = kHalfHeight_m * Vector3::UnitY();
    for (int i = 0; i < 4; ++i) {
        const Vector3 along = i % 2 == 0 ? Vector3(i - 1, 0.0, 0.0) : Vector3(0.0, 0.0, 2 - i);
        const Vector3 side = kHalf_m * Vector3::UnitY().cross(along);
        // Its corners, each sum one number along each axis, so that spokes share them to the last bit.
        const Vector3 near_left = kHalf_m * along + side;
        const Vector3 near_right = kHalf_m * along - side;
        const Vector3 far_left = kReach_m * along + side;
        const Vector3 far_right = kReach_m * along - side;
        add({near_left + up, near_right + up, far_right + up, far_left + up});
        add({near_left - up, far_left - up, far_right - up, near_right - up});
        add({near_left - up, near_left + up, far_left + up, far_left - up});
        add({near_right - up, far_right - up, far_right + up, near_right + up});
        add({far_left - up, far_left + up, far_right + up, far_right - up});
    }
    const Vector3 x(kHalf_m, 0.0, 0.0);
    const Vector3 z(0.0, 0.0, kHalf_m);
    add({up - x - z, up - x + z, up + x + z, up + x - z});
    add({-up - x - z, -up + x - z, -up + x + z, -up - x + z});
    part.colour = srgb(0xC9A24B);
    part.roughness = 0.35;
    return {"handles", {std::move(part)}, {}};
}

}  // namespace fulcrum::assets
