// Ring and bowl: closed surfaces with a hollow, each of one sheet.
#include "assets/make/models.h"
#include "assets/make/parts.h"

#include <cmath>
#include <numbers>

namespace fulcrum::assets {
namespace {}  // namespace

Model make_ring() {
    constexpr double kMiddle_m = 0.064;
    constexpr double kTube_m = 0.016;
    MeshPart ring = outward(tessellate(revolve([](double v) {
                                           const double angle = 2.0 * std::numbers::pi * v;
                                           return Vector2(kMiddle_m + kTube_m * std::cos(angle),
                                                          kTube_m * std::sin(angle));
                                       }),
                                       64, 24));
    ring.colour = srgb(0xD8433B);
    ring.roughness = 0.35;
    return {"ring", {std::move(ring)}, {}};
}

Model make_bowl() {
    constexpr double kOuter_m = 0.1;
    constexpr double kInner_m = 0.088;
    // From the middle of the foot out and up, round the rim, and down to the middle inside.
    const auto profile = [](double v) {
        constexpr double kRim = 0.06;  // of v, about the middle
        const double rim_m = 0.5 * (kOuter_m - kInner_m);
        if (std::abs(v - 0.5) < kRim) {
            const double angle = std::numbers::pi * (v - 0.5 + kRim) / (2.0 * kRim);
            return Vector2(kInner_m + rim_m + rim_m * std::cos(angle), rim_m * std::sin(angle));
        }
        const bool is_outside = v < 0.5;
        const double share = (is_outside ? v : 1.0 - v) / (0.5 - kRim);
        const double radius_m = is_outside ? kOuter_m : kInner_m;
        const double angle = 0.5 * std::numbers::pi * share;
        // The foot is flat below.
        const double low_m = is_outside ? -0.94 * kOuter_m : -kInner_m;
        return Vector2(radius_m * std::sin(angle), std::max(-radius_m * std::cos(angle), low_m));
    };
    MeshPart bowl = outward(tessellate(revolve(profile), 72, 60));
    bowl.colour = srgb(0x2E9E8F);
    bowl.roughness = 0.4;
    return {"bowl", {std::move(bowl)}, {}};
}

}  // namespace fulcrum::assets
