// The bucket: a tin toy, sky blue with a dotted band, its handle folded back.
#include "assets/make/models.h"
#include "assets/make/noise.h"
#include "assets/make/parts.h"

#include <cmath>
#include <numbers>

namespace fulcrum::assets {
namespace {

constexpr double kOpening_m = 0.11;  ///< inner radius at the rim
constexpr double kDepth_m = 0.14;    ///< from the rim's plane to the inner bottom
constexpr double kFoot_m = 0.083;    ///< inner radius at the bottom
constexpr double kWall_m = 0.004;
constexpr double kRoll_m = 0.0055;  ///< radius of the rolled rim

/// Outer wall from the middle of the underside up to the rim's roll. Corners are rounded by short
/// steps.
const std::vector<Vector2>& outer_profile() {
    static const std::vector<Vector2> kProfile{
        {0.0, -kDepth_m - kWall_m},
        {0.6 * kFoot_m, -kDepth_m - kWall_m},
        {kFoot_m - 0.002, -kDepth_m - kWall_m},
        {kFoot_m + 0.002, -kDepth_m - kWall_m + 0.0008},
        {kFoot_m + kWall_m, -kDepth_m + 0.001},
        {kFoot_m + kWall_m + 0.0022, -kDepth_m + 0.012},
        {0.5 * (kFoot_m + kOpening_m) + kWall_m, -0.5 * kDepth_m},
        {kOpening_m + kWall_m, 0.0}};
    return kProfile;
}

/// Straight pieces between points, each with its share of v.
Vector2 along_profile(const std::vector<Vector2>& points, double v) {
    const auto last = static_cast<int>(points.size()) - 1;
    const int i = std::min(static_cast<int>(v * last), last - 1);
    const double f = v * last - i;
    const auto at = static_cast<std::size_t>(i);
    return points[at] + f * (points[at + 1] - points[at]);
}

MeshPart outside() {
    MeshPart part =
        tessellate(revolve([](double v) { return along_profile(outer_profile(), v); }), 72, 28);
    // The picture is wrapped around the wall by height.
    for (std::size_t i = 0; i < part.uvs.size(); ++i) {
        part.uvs[i].y() = std::clamp(-part.positions[i].y() / kDepth_m, 0.0, 1.0);
    }
    part.picture = 0;
    part.roughness = 0.35;
    return part;
}

MeshPart inside() {
    static const std::vector<Vector2> kProfile{{kOpening_m, 0.0},
                                               {0.5 * (kFoot_m + kOpening_m), -0.5 * kDepth_m},
                                               {kFoot_m + 0.001, -kDepth_m + 0.010},
                                               {kFoot_m - 0.004, -kDepth_m + 0.0022},
                                               {kFoot_m - 0.012, -kDepth_m},
                                               {0.0, -kDepth_m}};
    MeshPart part =
        tessellate(revolve([](double v) { return along_profile(kProfile, v); }), 72, 25);
    part.colour = srgb(0xBFE0F2);
    part.roughness = 0.45;
    return part;
}

/// A ring about the y axis.
MeshPart ring(double radius_m, double height_m, double thick_m, double tall_m) {
    const Surface surface = revolve([=](double v) {
        const double angle = 2.0 * std::numbers::pi * v;
        return Vector2(radius_m + thick_m * std::cos(angle), height_m + tall_m * std::sin(angle));
    });
    return outward(tessellate(surface, 72, 16));
}

Colour wall_colour(double u, double v) {
    static const Colour kBlue = srgb(0x3AA0DC);
    static const Colour kDeep = srgb(0x2D8AC4);
    static const Colour kBand = srgb(0xF2A900);
    static const Colour kDot = srgb(0xFFF6DC);
    const Colour wall = blend(kBlue, kDeep, 0.5 + 0.5 * fractal_noise({40.0 * u, 6.0 * v, 0.3}, 2));
    const double in_band = smooth_step(0.30, 0.305, v) * smooth_step(0.62, 0.615, v);
    // Dots as round as the wall: about 0.67 m around, 0.14 m tall.
    const double phase = 14.0 * u;
    const double du_m = (phase - std::floor(phase) - 0.5) * 0.67 / 14.0;
    const double dv_m = (v - 0.46) * kDepth_m;
    const double dot = smooth_step(0.0125, 0.0118, std::hypot(du_m, dv_m));
    return blend(wall, blend(kBand, kDot, dot), in_band);
}

/// The wire handle folded back, its two ears, and its wooden grip.
void add_handle(Model& model) {
    constexpr double kReach_m = 0.124;
    constexpr double kTilt_rad = 1.15;  // from upright, to the back
    const auto curve = [](double t) {
        const double angle = std::numbers::pi * t;
        return Vector3(kReach_m * std::cos(angle), 0.118 * std::sin(angle), 0.0);
    };
    MeshPart wire = outward(tessellate(tube(curve, [](double) { return 0.0028; }), 12, 48));
    const auto grip_curve = [](double t) {
        const double angle = std::numbers::pi * (0.39 + 0.22 * t);
        return Vector3(kReach_m * std::cos(angle), 0.118 * std::sin(angle), 0.0);
    };
    const auto grip_radius = [](double t) {
        return 0.0085 * std::pow(std::max(0.0, 1.0 - std::pow(std::abs(2.0 * t - 1.0), 8.0)), 0.5);
    };
    MeshPart grip = outward(tessellate(tube(grip_curve, grip_radius), 18, 30));
    Affine fold = Affine::at({0.0, -0.016, 0.0});
    fold.rotate(AngleAxis(-kTilt_rad, Vector3::UnitX()));
    wire.transform(fold);
    grip.transform(fold);
    for (const double side : {-1.0, 1.0}) {
        MeshPart ear = outward(tessellate(ellipsoid({0.009, 0.011, 0.011}), 20, 14));
        ear.transform(Affine::at({side * 0.117, -0.016, 0.0}));
        wire.append(ear);
    }
    wire.colour = srgb(0x9AA4AD);
    wire.roughness = 0.3;
    grip.colour = srgb(0xB5713A);
    grip.roughness = 0.7;
    model.parts.push_back(std::move(wire));
    model.parts.push_back(std::move(grip));
}

}  // namespace

Model make_bucket() {
    Model model{"bucket", {}, {}};
    model.pictures.push_back(paint(1024, 256, wall_colour));
    // Both sheets were laid from the bottom up or from the rim down; the outer one must look
    // outwards, the inner inwards.
    MeshPart outer = outside();
    MeshPart inner = inside();
    if (outer.normals[outer.normals.size() / 2].dot(outer.positions[outer.positions.size() / 2]) <
        0.0) {
        outer.turn_inside_out();
    }
    const std::size_t floor_corner = inner.normals.size() - 1;
    if (inner.normals[floor_corner].y() < 0.0) {
        inner.turn_inside_out();
    }
    MeshPart rim = ring(kOpening_m + 0.5 * kWall_m, 0.0, kRoll_m, kRoll_m);
    rim.append(ring(kFoot_m + kWall_m, -kDepth_m + 0.002, 0.004, 0.006));
    rim.colour = srgb(0xF7FBFF);
    rim.roughness = 0.3;
    model.parts = {std::move(outer), std::move(inner), std::move(rim)};
    add_handle(model);
    return model;
}

}  // namespace fulcrum::assets
