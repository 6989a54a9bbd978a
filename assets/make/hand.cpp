// Hands in gloves that point: the pupil's, and the program's own, which shows what to do.
#include "assets/make/models.h"
#include "assets/make/parts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace fulcrum::assets {
namespace {

/// A finger from its tip over the middle to where it ends in the palm, round at both ends.
MeshPart make_finger(const Vector3& tip, const Vector3& bend, const Vector3& root,
                     double radius_m) {
    const auto along = [=](double t) -> Vector3 {
        // The quadratic Bezier curve through both ends.
        return (1.0 - t) * (1.0 - t) * tip + 2.0 * t * (1.0 - t) * bend + t * t * root;
    };
    const auto radius = [=](double t) {
        // The share of its length that each round end takes.
        constexpr double kEnd = 0.16;
        const double from_end = std::min(t, 1.0 - t) / kEnd;
        return from_end >= 1.0 ? radius_m
                               : radius_m * std::sqrt(std::max(from_end * (2.0 - from_end), 0.0));
    };
    return outward(tessellate(tube(along, radius), 10, 12));
}

// A right hand: the first finger points up, its tip, round with a radius of 9.5 mm, is the origin, the thumb is on the right, and the others
// are bent to the front.
Model make_pointing_hand(const char* name, std::uint32_t glove_colour, std::uint32_t cuff_colour) {
    MeshPart glove = make_finger({0.0, 0.0, 0.0}, {0.0, 0.03, 0.0}, {0.006, 0.07, 0.006}, 0.0095);
    // The others are bent into the palm.
    for (const double x : {0.022, 0.038, 0.052}) {
        glove.append(make_finger({x, 0.05, 0.026}, {x, 0.028, 0.022}, {x, 0.075, 0.0}, 0.0092));
    }
    glove.append(
        make_finger({-0.012, 0.05, 0.032}, {-0.03, 0.06, 0.02}, {0.0, 0.095, 0.0}, 0.0098));
    MeshPart palm = outward(tessellate(ellipsoid(Vector3(0.036, 0.036, 0.018)), 20, 12));
    palm.transform(Affine::at({0.027, 0.088, 0.004}));
    glove.append(palm);
    glove.colour = srgb(glove_colour);
    glove.roughness = 0.7;
    MeshPart cuff = outward(tessellate(ellipsoid(Vector3(0.031, 0.015, 0.022)), 24, 10));
    cuff.transform(Affine::at({0.027, 0.124, 0.004}));
    cuff.colour = srgb(cuff_colour);
    cuff.roughness = 0.6;
    Affine up;
    up.rotate(AngleAxis(std::numbers::pi, Vector3::UnitZ()));
    glove.transform(up);
    cuff.transform(up);
    return {name, {std::move(glove), std::move(cuff)}, {}};
}

}  // namespace

Model make_hand() {
    return make_pointing_hand("hand", 0xFFF6E3, 0x0072B2);
}

Model make_cursor() {
    return make_pointing_hand("cursor", 0xFF8400, 0xFFF6E3);
}

}  // namespace fulcrum::assets
