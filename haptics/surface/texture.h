// How a relief is felt under a contact that is pressed d metres deep into a coupling of stiffness k.
//
// With N the unit normal away from the surface, h the height (0 to H), grad h its slope along the surface, K the gain:
//   perturbed_normal   M = N - grad h + (grad h . N) N
//                      F = k [(d - K h) N + K h M]  where d >= K h,   k d M  elsewhere
//                        = k [d N - min(d, K h) grad h]
//   lateral            F = k d N - K_lat grad h,                     K_lat = K k d
//   height_offset      F = k p (N - K grad h),                       p = max(d - K (H - h), 0)
// M is not made a unit vector, as in the thesis. The first is the gradient of a potential where d >= K h (K k h^2 / 2) and
// the third everywhere (k p^2 / 2); the second, whose strength grows with the pressure, is none: a hand that presses downhill
// and lifts uphill is given energy. energy_loan.h says how much of that is lent.
//
// What is returned is over the coupling's own k d N. Each law is averaged along the stroke after it was applied at every
// sample of it (stroke_filter.h): h grad h has waves of twice the relief's, which would be folded if the relief alone were filtered.
// Waves shorter than 1 / 3.75 of a round's way are taken out of the relief before (a coarser level of texture_map.h).
//
// Thread: haptic loop. Cost: 50 ns at rest, up to 3 us at high speed; no allocation.
// Source: perturbed_normal: C. Basdogan, C.-H. Ho, M. A. Srinivasan 1997, A ray-based haptic rendering technique for
// displaying shape and texture of 3D objects in virtual environments, ASME DSC 61; C.-H. Ho, C. Basdogan, M. A. Srinivasan
// 1999, Efficient point-based rendering techniques for haptic display of virtual objects, Presence 8(5). lateral: M. Minsky,
// M. Ouh-young, O. Steele, F. P. Brooks, M. Behensky 1990, Feeling and seeing: issues in force display, Computer Graphics
// 24(2). The filter, and that K_lat grows with the pressure, are ours.
#pragma once

#include "haptics/surface/texture_map.h"
#include "haptics/surface/texture_settings.h"

#include <cstddef>

namespace fulcrum {

/// A place or a way along the surface, in the texture's coordinates, metres.
struct SurfaceVector {
    double u_m = 0.0;
    double v_m = 0.0;
};

/// What a relief adds to a contact, for each newton a metre of the coupling: force = k (normal_m N + along).
struct TextureOffset {
    double normal_m = 0.0;  ///< along N; never below -depth
    SurfaceVector along{};  ///< along the surface
    /// The relief that is felt: 0 to height_m, but for a hundredth of it and the filter's ripple.
    double height_m = 0.0;
};

/// The law itself at one sample of the relief. `depth_m` 0 or more.
[[nodiscard]] TextureOffset compute_texture_offset(const TextureSettings& settings,
                                                   const HeightSample& relief,
                                                   double depth_m) noexcept;

/// A texture that can be felt. A value of `TextureSettings` that `validate` accepted makes one; many bodies may share it.
class Texture {
  public:
    explicit Texture(const TextureSettings& settings);

    /// `stroke` is the way of the contact in a round. Anything that is not finite gives nothing.
    [[nodiscard]] TextureOffset feel(const SurfaceVector& place, const SurfaceVector& stroke,
                                     double depth_m) const noexcept;
    /// What one bump holds under this pressure at most, joules for each newton a metre of the coupling: for energy_loan.h.
    [[nodiscard]] double bump_m2(double depth_m) const noexcept;
    /// The unfiltered relief.
    [[nodiscard]] HeightSample relief(const SurfaceVector& place) const noexcept;

    [[nodiscard]] const TextureSettings& settings() const noexcept { return settings_; }
    [[nodiscard]] const TextureMap& map() const noexcept { return map_; }
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

  private:
    [[nodiscard]] SurfaceVector turn(const SurfaceVector& v) const noexcept {
        return {cos_ * v.u_m + sin_ * v.v_m, cos_ * v.v_m - sin_ * v.u_m};
    }
    [[nodiscard]] SurfaceVector turn_back(const SurfaceVector& v) const noexcept {
        return {cos_ * v.u_m - sin_ * v.v_m, cos_ * v.v_m + sin_ * v.u_m};
    }
    [[nodiscard]] std::size_t choose_level(const SurfaceVector& stroke) const noexcept;

    TextureSettings settings_;
    double cos_ = 1.0;
    double sin_ = 0.0;
    TextureMap map_;
};

/// What the fingers would measure of a texture, over a whole tile, at rest.
struct TextureFacts {
    double rms_height_m = 0.0;  ///< about the mean
    /// Root mean square of the force along the surface over the pressing force, pressed with `force_N` into `stiffness`.
    double rms_lateral_share = 0.0;
};
/// Of a texture that `validate` accepted; zeros where there is none. Cost: as making it.
[[nodiscard]] TextureFacts measure_texture(const TextureSettings& settings,
                                           double stiffness_N_per_m, double force_N);

}  // namespace fulcrum
