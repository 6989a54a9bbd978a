#include "haptics/flight/flat_plate.h"

#include "haptics/math/length.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fulcrum {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kLongestRatio = 50.0;  // beyond it a plate is as good as endless

// The coefficient along the normal, the same times the share of the chord by which it acts upstream of the middle, and what the
// law has along the plane.
struct PlateCoefficients {
    double normal = 0.0;
    double lever = 0.0;
    double along = 0.0;
};

PlateCoefficients compute_cross_flow(double aspect_ratio, double sine, double cosine) noexcept {
    const double attached = compute_lift_slope(aspect_ratio) * sine * cosine;
    return {attached + compute_broadside_drag(aspect_ratio) * sine * sine, 0.25 * attached};
}

PlateCoefficients compute_separated(double aspect_ratio, double sine, double cosine) noexcept {
    const double coefficient = compute_broadside_drag(aspect_ratio) * sine;
    return {coefficient, coefficient * 0.75 * cosine / (4.0 + kPi * sine)};
}

PlateCoefficients compute_thin_plate(double aspect_ratio, double sine, double cosine) noexcept {
    const double angle_rad = std::atan2(sine, cosine);
    const double lift = 2.0 * kPi * angle_rad / (1.0 + 2.0 * angle_rad / aspect_ratio);
    const double drag = 1.28 * sine + lift * lift / (0.7 * kPi * aspect_ratio);
    const double normal = lift * cosine + drag * sine;
    return {normal, 0.25 * normal, drag * cosine - lift * sine};
}

PlateCoefficients compute_coefficients(PlateLaw law, double aspect_ratio, double sine,
                                       double cosine) noexcept {
    switch (law) {
        case PlateLaw::separated:
            return compute_separated(aspect_ratio, sine, cosine);
        case PlateLaw::thin_plate:
            return compute_thin_plate(aspect_ratio, sine, cosine);
        case PlateLaw::cross_flow:
            break;
    }
    return compute_cross_flow(aspect_ratio, sine, cosine);
}

}  // namespace

std::string_view to_string(PlateLaw law) noexcept {
    constexpr std::array<std::string_view, 3> kNames{"cross flow", "separated", "thin plate"};
    return kNames[static_cast<std::size_t>(law)];
}

double compute_lift_slope(double aspect_ratio) noexcept {
    return 2.0 * kPi * aspect_ratio / (2.0 + std::sqrt(aspect_ratio * aspect_ratio + 4.0));
}

double compute_broadside_drag(double aspect_ratio) noexcept {
    return 1.11 + 0.018 * std::min(aspect_ratio, kLongestRatio);
}

double compute_normal_coefficient(PlateLaw law, double aspect_ratio, double angle_rad) noexcept {
    return compute_coefficients(law, aspect_ratio, std::sin(angle_rad), std::cos(angle_rad)).normal;
}

// With s = n.u, t = u - s n, L = |t|, dL = t/L, c the chord:
//   F/q = s (K L + C_90 |s|) n + C_f L t,   tau/q = -(chord/4) K s (c.t) (c x n),   q = rho/2 A
//   dF/q = n ((K L + 2 C_90 |s|) n^T + K s dL^T) + C_f (L (1 - n n^T) + t dL^T)
//   dtau/q = -(chord/4) K (c x n) ((c.t) n^T + s (c - (c.n) n)^T)
PlateSlopes compute_cross_flow_slopes(const FlatPlate& plate, double density_kg_per_m3,
                                      const Vector3& flow) noexcept {
    const Vector3& n = plate.normal;
    const Vector3& c = plate.chord;
    const double across = n.dot(flow);
    const Vector3 along = flow - across * n;
    const double length = compute_length(along);
    const Vector3 by_length = length > 0.0 ? Vector3(along / length) : Vector3::Zero();
    const double lift = compute_lift_slope(plate.aspect_ratio);
    const double drag = compute_broadside_drag(plate.aspect_ratio);
    const double q = 0.5 * density_kg_per_m3 * plate.area_m2;
    const Vector3 by_normal =
        (lift * length + 2.0 * drag * std::abs(across)) * n + lift * across * by_length;
    const Vector3 by_lever = c.dot(along) * n + across * (c - c.dot(n) * n);
    PlateSlopes slopes;
    slopes.force = q * (n * by_normal.transpose() +
                        kPlateFriction * (length * (Matrix3::Identity() - n * n.transpose()) +
                                          along * by_length.transpose()));
    slopes.torque = (-0.25 * plate.chord_m * lift * q) * c.cross(n) * by_lever.transpose();
    return slopes;
}

PlateForce compute_plate_force(PlateLaw law, const FlatPlate& plate, double density_kg_per_m3,
                               const Vector3& flow) noexcept {
    const double speed_m_per_s = compute_length(flow);
    if (!(speed_m_per_s > 0.0)) {
        return {};
    }
    // Across and along.
    const double across_m_per_s = plate.normal.dot(flow);
    const Vector3 along = flow - across_m_per_s * plate.normal;
    const double along_m_per_s = compute_length(along);
    const PlateCoefficients coefficients =
        compute_coefficients(law, plate.aspect_ratio, std::abs(across_m_per_s) / speed_m_per_s,
                             along_m_per_s / speed_m_per_s);
    const double scale_N = 0.5 * density_kg_per_m3 * plate.area_m2;
    const double pressure_N =
        std::copysign(scale_N * speed_m_per_s * speed_m_per_s, across_m_per_s);
    PlateForce result;
    result.force = pressure_N * coefficients.normal * plate.normal +
                   scale_N * kPlateFriction * along_m_per_s * along;
    // What the law has along the plane; the normal force acts upstream of the middle, as far as the stream goes along the chord.
    if (along_m_per_s > 0.0) {
        result.force +=
            scale_N * coefficients.along * speed_m_per_s * speed_m_per_s / along_m_per_s * along;
        const double upstream_m = -plate.chord_m * plate.chord.dot(along) / along_m_per_s;
        result.torque =
            upstream_m * pressure_N * coefficients.lever * plate.chord.cross(plate.normal);
    }
    return result;
}

}  // namespace fulcrum
