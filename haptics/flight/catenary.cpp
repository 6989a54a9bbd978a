#include "haptics/flight/catenary.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

// Where the upper end lies under a pull (H, V).
struct Reach {
    double level_m;
    double up_m;
};

Reach compute_reach(const CatenarySettings& line, double H, double V) noexcept {
    const double w = line.weight_N_per_m;
    const double bottom = V - w * line.length_m;
    const double level =
        H * line.length_m / line.stretch_N + H / w * (std::asinh(V / H) - std::asinh(bottom / H));
    const double up = line.length_m / line.stretch_N * (V - 0.5 * w * line.length_m) +
                      (std::hypot(H, V) - std::hypot(H, bottom)) / w;
    return {level, up};
}

// A first guess: of a slack line the parabola's sag, of a taut one its stretch.
double guess_level_N(const CatenarySettings& line, double level_m, double up_m) noexcept {
    const double chord_m = std::hypot(level_m, up_m);
    const double spare_m = line.length_m - chord_m;
    if (spare_m > 1.0e-6 * line.length_m) {
        return line.weight_N_per_m * level_m * std::sqrt(chord_m / (24.0 * spare_m));
    }
    return std::max(line.stretch_N * -spare_m / line.length_m, line.weight_N_per_m * chord_m) *
           level_m / chord_m;
}

}  // namespace

std::optional<CatenaryPull> compute_catenary(const CatenarySettings& settings, double level_m,
                                             double up_m) noexcept {
    constexpr int kMostSteps = 200;
    double H = guess_level_N(settings, level_m, up_m);
    double V = 0.5 * settings.weight_N_per_m * settings.length_m + H * up_m / level_m;
    for (int i = 0; i < kMostSteps; ++i) {
        const Reach reach = compute_reach(settings, H, V);
        const double missing_level = level_m - reach.level_m;
        const double missing_up = up_m - reach.up_m;
        // A light line's reach is the small difference of what H/w multiplies.
        const double tolerance_m =
            1.0e-12 * settings.length_m + 1.0e-15 * std::hypot(H, V) / settings.weight_N_per_m;
        if (std::max(std::abs(missing_level), std::abs(missing_up)) <= tolerance_m) {
            return CatenaryPull{H, V, V - settings.weight_N_per_m * settings.length_m};
        }
        // The Jacobian, Irvine's by hand.
        const double w = settings.weight_N_per_m;
        const double bottom = V - w * settings.length_m;
        const double top_N = std::hypot(H, V);
        const double bottom_N = std::hypot(H, bottom);
        const double slack = settings.length_m / settings.stretch_N;
        const double level_by_H = slack + (std::asinh(V / H) - std::asinh(bottom / H)) / w -
                                  (V / top_N - bottom / bottom_N) / w;
        const double level_by_V = H / w * (1.0 / top_N - 1.0 / bottom_N);
        const double up_by_V = slack + (V / top_N - bottom / bottom_N) / w;
        const double determinant = level_by_H * up_by_V - level_by_V * level_by_V;
        const double change_H = (up_by_V * missing_level - level_by_V * missing_up) / determinant;
        const double change_V =
            (level_by_H * missing_up - level_by_V * missing_level) / determinant;
        // H stays above 0.
        const double share = change_H < -0.5 * H ? -0.5 * H / change_H : 1.0;
        H += share * change_H;
        V += share * change_V;
        if (!std::isfinite(H) || !std::isfinite(V)) {
            return std::nullopt;
        }
    }
    return std::nullopt;
}

}  // namespace fulcrum
