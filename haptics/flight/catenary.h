// A line that hangs at rest between two places: its pull in closed form. It stretches, weighs something, and is never stiff.
//
//   l = H L/E + H/w (asinh(V/H) - asinh((V - wL)/H))           E: newtons that would double its length (EA)
//   h = L/E (V - wL/2) + (sqrt(H^2 + V^2) - sqrt(H^2 + (V - wL)^2)) / w
// H the level pull, V the upper end's, w the weight a metre, L the unstretched length, l and h how far the upper end is from
// the lower one, level and up. Newton on (H, V).
//
// It knows neither inertia nor the wind on the line: flights use the segments of line.h, and this is what they are judged by.
//
// Thread: any. Cost: 1 us. No allocation.
// Source: H. Irvine 1981, Cable Structures, section 1.3 (the elastic catenary); for kites NASA Glenn, Beginner's Guide to
// Kites, "Control line equation", without stretch.
#pragma once

#include <optional>

namespace fulcrum {

struct CatenarySettings {
    double length_m = 20.0;         ///< unstretched, above 0
    double weight_N_per_m = 0.004;  ///< above 0
    double stretch_N = 500.0;       ///< EA, above 0
};

struct CatenaryPull {
    double level_N = 0.0;      ///< H, the same all along
    double up_top_N = 0.0;     ///< V: what the upper end carries
    double up_bottom_N = 0.0;  ///< V - wL; negative where it lifts the lower end's holder no more
};

/// Of a line between two places, the upper one `level_m` > 0 away and `up_m` above the lower. Nothing where Newton does not end.
[[nodiscard]] std::optional<CatenaryPull> compute_catenary(const CatenarySettings& settings,
                                                           double level_m, double up_m) noexcept;

}  // namespace fulcrum
