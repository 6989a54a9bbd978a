// Ghost, star, plank, sphere, box, cylinder, capsule.
#include "assets/make/models.h"
#include "assets/make/noise.h"
#include "assets/make/parts.h"

#include <cmath>
#include <numbers>

namespace fulcrum::assets {
namespace {

constexpr double kGhostRadius_m = 0.02;

/// Distance from the middle to the star's outline, at an angle from its top point: straight edges between points (R)
/// and corners (R/2), r = R c sin b / (R sin a + c sin(b - a)); the points are rounded by keeping a off 0.
double star_outline(double angle) {
    constexpr double kPoint_m = 0.0525;
    constexpr double kCorner_m = 0.5 * kPoint_m;
    constexpr double kHalfPoint_rad = std::numbers::pi / 5.0;
    constexpr double kRounding_rad = 0.05;
    const double turn = angle / (2.0 * kHalfPoint_rad);
    const double off = std::abs(turn - std::floor(turn + 0.5)) * 2.0 * kHalfPoint_rad;
    const double a = std::min(std::hypot(off, kRounding_rad), kHalfPoint_rad);
    return kPoint_m * kCorner_m * std::sin(kHalfPoint_rad) /
           (kPoint_m * std::sin(a) + kCorner_m * std::sin(kHalfPoint_rad - a));
}

// A surface of revolution in quarters of two colours: one sees how it turns.
Model make_striped(const char* name, const std::function<Vector2(double v)>& profile) {
    MeshPart part = outward(tessellate(revolve(profile), 48, 20));
    part.picture = 0;
    part.roughness = 0.45;
    Model model{name, {}, {}};
    model.pictures.push_back(paint(256, 4, [](double u, double /*v*/) {
        return static_cast<int>(4.0 * u) % 2 == 0 ? srgb(0x4C9A6A) : srgb(0xF3EFE2);
    }));
    model.parts = {std::move(part)};
    return model;
}

}  // namespace

Model make_ghost() {
    MeshPart ball = outward(tessellate(ellipsoid(Vector3::Constant(kGhostRadius_m)), 72, 40));
    ball.colour = blend(srgb(0xE8743B), srgb(0xDDE6F2), 0.6);
    ball.roughness = 0.4;
    ball.alpha = 0.40;
    return {"ghost", {std::move(ball)}, {}};
}

Model make_star() {
    // v runs from the middle of the front over the rim to the middle of the back; puffy like a
    // cushion.
    const auto surface = [](double u, double v) {
        const double angle = 2.0 * std::numbers::pi * (u == 1.0 ? 0.0 : u);
        const double reach = v == 1.0 ? 0.0 : std::sin(std::numbers::pi * v);
        const double puff = 0.017 * std::cos(std::numbers::pi * v);
        // Near the middle it is round, towards the rim a star.
        const double r =
            reach * (0.034 + (star_outline(angle) - 0.034) * smooth_step(0.1, 1.0, reach));
        return Vector3(r * std::sin(angle), r * std::cos(angle), puff);
    };
    MeshPart star = outward(tessellate(surface, 160, 36));
    star.colour = srgb(0xF6B914);
    star.roughness = 0.35;
    return {"star", {std::move(star)}, {}};
}

Model make_sphere() {
    MeshPart ball = outward(tessellate(ellipsoid(Vector3::Ones()), 96, 48));
    ball.picture = 0;
    ball.roughness = 0.45;
    // The picture's seam lies at the back.
    ball.transform(Affine(AngleAxis(std::numbers::pi, Vector3::UnitY())));
    // Twelve spots, on the corners of an icosahedron: one sees how it turns.
    const double golden = 0.5 * (1.0 + std::sqrt(5.0));
    const auto spot = [golden](const Vector3& p) {
        double nearest = -1.0;
        for (const double a : {-1.0, 1.0}) {
            for (const double b : {-golden, golden}) {
                for (const Vector3& corner :
                     {Vector3(0, a, b), Vector3(a, b, 0), Vector3(b, 0, a)}) {
                    nearest = std::max(nearest, p.dot(corner.normalized()));
                }
            }
        }
        return smooth_step(0.955, 0.965, nearest);
    };
    const auto on_ball = ellipsoid(Vector3::Ones());
    Model model{"sphere", {}, {}};
    model.pictures.push_back(paint(512, 256, [&](double u, double v) {
        return blend(srgb(0x3E86C6), srgb(0xF3EFE2), spot(on_ball(u, v)));
    }));
    model.parts = {std::move(ball)};
    return model;
}

Model make_box() {
    MeshPart faces;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            const Vector3 out = side * Vector3::Unit(axis);
            const Vector3 right = Vector3::Unit((axis + 1) % 3);
            const Vector3 up = out.cross(right);
            const auto first = static_cast<std::uint32_t>(faces.positions.size());
            for (const double v : {-1.0, 1.0}) {
                for (const double u : {-1.0, 1.0}) {
                    faces.positions.emplace_back(out + u * right + v * up);
                    faces.normals.push_back(out);
                    faces.uvs.emplace_back(0.5 + 0.5 * u, 0.5 - 0.5 * v);
                }
            }
            for (const std::uint32_t corner : {0U, 1U, 3U, 0U, 3U, 2U}) {
                faces.indices.push_back(first + corner);
            }
        }
    }
    faces.picture = 0;
    faces.roughness = 0.6;
    Model model{"box", {}, {}};
    model.pictures.push_back(paint(128, 128, [](double u, double v) {
        const double edge = std::min(std::min(u, 1.0 - u), std::min(v, 1.0 - v));
        return blend(srgb(0xB77B3E), srgb(0xE0B068), smooth_step(0.05, 0.07, edge));
    }));
    model.parts = {std::move(faces)};
    return model;
}

Model make_cylinder() {
    constexpr double kRadius_m = 0.04;
    constexpr double kHalf_m = 0.08;
    constexpr double kRim_m = 0.001;  // rounded, so that it catches the light
    // Over the top to its rim, round it, down the side and so on: each stretch in as many rows as it needs.
    return make_striped("cylinder", [](double v) {
        const double w = std::abs(2.0 * v - 1.0);  // 1 at a pole, 0 half way down
        const double side = v < 0.5 ? 1.0 : -1.0;
        if (w > 0.7) {
            return Vector2((kRadius_m - kRim_m) * (1.0 - w) / 0.3, side * kHalf_m);
        }
        const double turn = 0.5 * std::numbers::pi * (0.7 - std::max(w, 0.5)) / 0.2;
        const double down = w < 0.5 ? w / 0.5 : 1.0;
        return Vector2(kRadius_m - kRim_m * (1.0 - std::sin(turn)),
                       side * (down * (kHalf_m - kRim_m) + kRim_m * std::cos(turn)));
    });
}

Model make_capsule() {
    constexpr double kRadius_m = 0.04;
    constexpr double kStraight_m = 0.06;  // to each side
    return make_striped("capsule", [](double v) {
        const double w = std::abs(2.0 * v - 1.0);
        const double side = v < 0.5 ? 1.0 : -1.0;
        const double turn = 0.5 * std::numbers::pi * std::max(w - 0.3, 0.0) / 0.7;
        const double straight = std::min(w / 0.3, 1.0);
        return Vector2(kRadius_m * std::cos(turn),
                       side * (kStraight_m * straight + kRadius_m * std::sin(turn)));
    });
}

Model make_plank() {
    // A rounded box: each direction u, v pushed towards the box by a high power.
    const Vector3 half(0.45, 0.0125, 0.10);
    const auto surface = [half](double u, double v) {
        const Vector3 unit = ellipsoid(Vector3::Ones())(u, v);
        const double longest = std::pow(
            unit.unaryExpr([](double x) { return std::pow(std::abs(x), 14.0); }).sum(), 1.0 / 14.0);
        return Vector3((unit / longest).cwiseProduct(half) - Vector3(0.0, half.y(), 0.0));
    };
    const auto wood = [](const Vector3& p) {
        const double rings =
            26.0 * p.z() + 1.1 * fractal_noise({2.5 * p.x(), 8.0 * p.y(), 9.0 * p.z()}, 3);
        const double grain = 0.5 + 0.5 * std::sin(2.0 * std::numbers::pi * rings);
        const double fibre = fractal_noise({12.0 * p.x(), 120.0 * p.y(), 220.0 * p.z()}, 2);
        return blend(srgb(0xD9A25F), srgb(0xB77B3E), 0.65 * grain + 0.35 * fibre);
    };
    Model model{"plank", {}, {}};
    MeshPart board = outward(tessellate(surface, 96, 48));
    // Laid on from above: x along u, z along v.
    for (std::size_t i = 0; i < board.uvs.size(); ++i) {
        board.uvs[i] = {0.5 + board.positions[i].x() / 0.92, 0.5 + board.positions[i].z() / 0.22};
    }
    board.picture = 0;
    board.roughness = 0.7;
    model.pictures.push_back(paint(512, 128, [&](double u, double v) {
        return wood({0.92 * (u - 0.5), 0.0, 0.22 * (v - 0.5)});
    }));
    model.parts = {std::move(board)};
    return model;
}

}  // namespace fulcrum::assets
