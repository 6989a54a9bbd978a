// A kite as the wind has it: plates, what they weigh and where, the knot of its bridle, its tail.
//
// Design frame K: origin at the foot of the spine, x sideways, y up the spine, z out of the front, which faces the wind. In flight
// the top leans into the wind.
//   diamond   a spine and a cross spar at three quarters of its height; both halves fold back by `fold_rad`
//   delta     a triangle, folded back alike, with a keel under the spine
//   sled      a sheet with two triangular keels in front, from whose tips the line is led
//   box       two square cells, each a third of the height, one edge forward; no lee between their sheets
// Each half, or sheet, is cut into strips along the chord, each a flat plate (flat_plate.h) with the aspect ratio of the whole:
// span^2 over the area that faces forward.
//
// Knot, as NASA has it: a string of length B from the foot over the knot to the top, k of it below the knot:
//   cos A = (k^2 + H^2 - (B - k)^2) / (2 k H),   knot = (0, k cos A, k sin A) in front of the spine
// Inertia: spars by Simpson's rule along their length, which is exact; skin by it along each strip's chord, as if a strip had no
// width, so that the error falls with the square of the strips; the tail as a point
// at the foot, where it hangs; the body frame B is the principal one about the centre of mass (rigid_state.h).
// Tail: drags at the foot like a flag, F = rho/2 (C_D A) |u| u.
//
// Thread: load. Cost: some microseconds.
// Source: NASA Glenn Research Center, Beginner's Guide to Kites: "Kite geometry", "Bridle point", and the weights of its
// KiteModeler for cloth, spars and lines. Flags: S. Hoerner 1965, Fluid-Dynamic Drag, 3-25.
#pragma once

#include "haptics/base/error.h"
#include "haptics/dynamics/rigid_state.h"
#include "haptics/flight/flat_plate.h"

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace fulcrum {

enum class KiteShape : std::uint8_t { diamond, delta, sled, box };
inline constexpr std::array<KiteShape, 4> kKiteShapes{KiteShape::diamond, KiteShape::delta,
                                                      KiteShape::sled, KiteShape::box};

/// A cloth or a spar and what it weighs.
struct KiteMaterial {
    std::string_view name;
    double weight = 0.0;  ///< kg/m^2 of cloth, kg/m of spars
};
inline constexpr std::array<KiteMaterial, 6> kKiteCloths{{{"plastic", 0.0209},
                                                          {"tissue", 0.0201},
                                                          {"nylon", 0.0420},
                                                          {"paper", 0.0564},
                                                          {"silk", 0.0169},
                                                          {"cellophane", 0.0288}}};
inline constexpr std::array<KiteMaterial, 4> kKiteSpars{
    {{"balsa", 0.0044}, {"birch", 0.0241}, {"tube", 0.0234}, {"skewer", 0.0036}}};

/// Fixed at load.
struct KiteSettings {
    KiteShape shape = KiteShape::diamond;
    double height_m = 0.8;              ///< H, 0.1 to 5
    double width_m = 0.75;              ///< tip to tip when unfolded, 0.1 to 5
    double fold_rad = 0.25;             ///< of each half, 0 to 1
    double cloth_kg_per_m2 = 0.0420;    ///< 1e-3 to 2
    double spar_kg_per_m = 0.0044;      ///< 1e-4 to 1
    double bridle_m = 1.0;              ///< B; above H
    double knot_m = 0.68;               ///< k, so that foot, top and knot make a triangle
    double tail_m = 2.0;                ///< 0 to 50
    double tail_kg_per_m = 0.0016;      ///< 0 to 0.1
    double tail_drag_m2_per_m = 0.009;  ///< C_D A a metre: 0.12 of a ribbon of 7.5 cm; 0 to 1
    PlateLaw law = PlateLaw::cross_flow;
    int strips = 6;  ///< of each half or sheet, 1 to 64

    friend bool operator==(const KiteSettings&, const KiteSettings&) = default;
};

struct Kite {
    Inertia inertia{};
    Pose X_KB{};                    ///< centre of mass and principal axes
    std::vector<FlatPlate> plates;  ///< in B
    Vector3 knot_B{Vector3::Zero()};
    Vector3 foot_B{Vector3::Zero()};  ///< where the tail hangs
    std::vector<Vector3> corners_B;   ///< what may touch the ground
    double area_m2 = 0.0;             ///< that faces forward
    double aspect_ratio = 1.0;
    double tail_drag_m2 = 0.0;
    PlateLaw law = PlateLaw::cross_flow;
};

/// "diamond", "delta", "sled", "box".
[[nodiscard]] std::string_view to_string(KiteShape shape) noexcept;
/// The shape, cloth or spar of that name; an error that lists the names where there is none.
[[nodiscard]] Expected<KiteShape> find_kite_shape(std::string_view name);
[[nodiscard]] Expected<KiteMaterial> find_kite_cloth(std::string_view name);
[[nodiscard]] Expected<KiteMaterial> find_kite_spar(std::string_view name);

/// Refuses settings outside the ranges above, NaN, and a bridle that makes no triangle.
[[nodiscard]] Expected<void> validate(const KiteSettings& settings);
/// The knot in K, in front of the spine.
[[nodiscard]] Vector3 compute_knot_K(const KiteSettings& settings) noexcept;
/// Takes settings that `validate` accepted.
[[nodiscard]] Kite make_kite(const KiteSettings& settings);

}  // namespace fulcrum
