// The force of moving air on a thin flat plate, at any angle.
//
// The air passes the plate at u = s n + t: s along the normal n, t in the plate's plane; a is the angle between u and the
// plane, sin a = |s| / |u|. The plate is pushed along its normal, the way the air blows, and rubbed along its plane:
//   F = rho/2 A (C_N(a) |u|^2 sign(s) n + C_A(a) |u|^2 t/|t| + C_f |t| t)      C_N from the middle of the chord upstream by
//                                                                              l(a) chord cos(sweep), the rest in the middle
// Three laws for C_N, C_A and l, by name; C_A = 0 but for the last:
//   cross_flow   C_N = K sin a cos a + C_90 sin^2 a     potential flow, which acts at the quarter chord, and the drag of the
//                l C_N = K/4 sin a cos a                cross flow, which acts in the middle. Good from 0 to 90 degrees
//   separated    C_N = C_90 sin a,  l = 3 cos a / (16 + 4 pi sin a)      a plate with dead air behind it at every angle
//   thin_plate   C_L = 2 pi a / (1 + 2 a / AR),  C_D = 1.28 sin a + C_L^2 / (0.7 pi AR)     NASA's KiteModeler: for small
//                C_N = C_L cos a + C_D sin a,  C_A = C_D cos a - C_L sin a,  l = 1/4       angles; above some 30 degrees it
//                                                                                          lifts far too much
//   K = 2 pi AR / (2 + sqrt(AR^2 + 4)),  C_90 = 1.11 + 0.018 AR up to AR = 50
// What air a plate drags along (its added mass), and what lies in another's lee, are left out.
//
// Thread: any. Cost: some 10 ns, thin_plate 40. No allocation.
// Source: C_N of cross_flow: A. Flax, H. Lawrence 1951, The aerodynamics of low-aspect-ratio wings and wing-body
// combinations; S. Hoerner, H. Borst 1975, Fluid-Dynamic Lift, chapter XVII. K: H. Helmbold 1942. C_90: L. Viterna, R.
// Corrigan 1982, Fixed pitch rotor performance of large horizontal axis wind turbines (and with their C_L, C_D the law of
// separated). l of separated: Lord Rayleigh 1876, On the resistance of fluids. thin_plate: NASA Glenn Research Center,
// Beginner's Guide to Kites, "Downwash effects on a kite". That the force of the first two is normal to the plate but for friction: X. Ortiz,
// D. Rival, D. Wood 2015, Forces and moments on flat plates of small aspect ratio, Energies 8.
#pragma once

#include "haptics/base/error.h"
#include "haptics/math/spatial.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace fulcrum {

enum class PlateLaw : std::uint8_t { cross_flow, separated, thin_plate };
inline constexpr std::array<PlateLaw, 3> kPlateLaws{PlateLaw::cross_flow, PlateLaw::separated,
                                                    PlateLaw::thin_plate};

/// Both sides of a smooth cloth.
inline constexpr double kPlateFriction = 0.02;

/// A plate in the frame of what it belongs to.
struct FlatPlate {
    Vector3 middle{Vector3::Zero()};   ///< of its chord, metres
    Vector3 chord{Vector3::UnitX()};   ///< unit, from the leading edge to the trailing one
    Vector3 normal{Vector3::UnitZ()};  ///< unit, across the chord
    double chord_m = 1.0;              ///< above 0
    double area_m2 = 1.0;              ///< above 0
    double aspect_ratio = 1.0;  ///< span^2 / area of the whole surface that it is part of; above 0
};

/// What the air does to a plate.
struct PlateForce {
    Vector3 force{Vector3::Zero()};   ///< newtons
    Vector3 torque{Vector3::Zero()};  ///< newton metres, about the middle of the chord
};

/// "cross flow", "separated", "thin plate".
[[nodiscard]] std::string_view to_string(PlateLaw law) noexcept;

/// K: of the lift by the angle, a radian, of a wing of that aspect ratio.
[[nodiscard]] double compute_lift_slope(double aspect_ratio) noexcept;
/// C_90: the drag of a plate that stands across the stream.
[[nodiscard]] double compute_broadside_drag(double aspect_ratio) noexcept;
/// C_N at an angle of 0 to pi/2.
[[nodiscard]] double compute_normal_coefficient(PlateLaw law, double aspect_ratio,
                                                double angle_rad) noexcept;

/// How a plate's force and torque change with the flow.
struct PlateSlopes {
    Matrix3 force;   ///< newton seconds a metre
    Matrix3 torque;  ///< newton seconds
};
/// Of cross_flow, whose force is s (K L + C_90 |s|) n + C_f L t of the flow s n + t, L = |t|, and so has slopes in closed form; where the
/// flow stands still along the plate those of t/L are left out, as a step to either side of it has them on the average.
[[nodiscard]] PlateSlopes compute_cross_flow_slopes(const FlatPlate& plate,
                                                    double density_kg_per_m3,
                                                    const Vector3& flow) noexcept;

/// Of air of that density that passes at `flow` m/s, in the plate's frame. Still air does nothing.
[[nodiscard]] PlateForce compute_plate_force(PlateLaw law, const FlatPlate& plate,
                                             double density_kg_per_m3,
                                             const Vector3& flow) noexcept;

}  // namespace fulcrum
