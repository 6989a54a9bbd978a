#include "runtime/render/scene/arrow.h"

#include "haptics/math/length.h"

#include <algorithm>

namespace fulcrum::runtime {

namespace {
// As parts of the camera's distance.
constexpr double kShaftRadius = 0.0095;
constexpr double kArmRadius = 0.006;
constexpr double kHeadRadius = 0.023;
constexpr double kHeadLength = 0.040;
}  // namespace

double common_scale(const std::vector<ViewForce>& forces) {
    double largest_N = kLongestForce_N;
    for (const ViewForce& force : forces) {
        if (force.force_W.allFinite()) {
            largest_N = std::max(largest_N, compute_length(force.force_W));
        }
    }
    return kLongestForce_N / largest_N;
}

double common_scale(const std::vector<ViewTorque>& torques) {
    std::vector<ViewForce> forces;
    for (const ViewTorque& torque : torques) {
        forces.push_back(torque.force);
    }
    return common_scale(forces);
}

std::optional<Arrow> arrow_for(const ViewForce& force, const Camera& camera, double scale) {
    if (!force.visible || !force.at_W.allFinite() || !force.force_W.allFinite()) {
        return std::nullopt;
    }
    const double newtons = compute_length(force.force_W);
    if (!(newtons >= kLeastForce_N)) {
        return std::nullopt;
    }
    const double distance_m = camera.distance_m();
    const double head_m = kHeadLength * distance_m;
    const double length_m =
        std::clamp(kLengthPerNewton * scale * newtons, 1.25 * kHeadLength, kLongestArrow) *
        distance_m;
    const Vector3 way = compute_direction(force.force_W);
    const Quaternion turn(Eigen::Quaterniond::FromTwoVectors(Vector3::UnitY(), way));

    Arrow arrow;
    const double shaft_m = length_m - 0.9 * head_m;
    const auto shaft =
        place({force.at_W, turn}, {kShaftRadius * distance_m, shaft_m, kShaftRadius * distance_m});
    const auto head = place({force.at_W + (length_m - head_m) * way, turn},
                            {kHeadRadius * distance_m, head_m, kHeadRadius * distance_m});
    if (!shaft || !head) {
        return std::nullopt;
    }
    arrow.shaft = *shaft;
    arrow.head = *head;
    arrow.tail_W = force.at_W;
    arrow.tip_W = force.at_W + length_m * way;
    arrow.radius_m = kHeadRadius * distance_m;
    arrow.look = force.look;
    return arrow;
}

std::optional<Placement> arm_for(const ViewTorque& torque, const Camera& camera) {
    const Vector3 way = torque.force.at_W - torque.axis_W;
    if (!way.allFinite()) {
        return std::nullopt;
    }
    const double length_m = compute_length(way);
    const double radius_m = kArmRadius * camera.distance_m();
    if (!(length_m > radius_m)) {
        return std::nullopt;
    }
    const Quaternion turn(
        Eigen::Quaterniond::FromTwoVectors(Vector3::UnitY(), compute_direction(way)));
    return place({torque.axis_W, turn}, {radius_m, length_m, radius_m});
}

}  // namespace fulcrum::runtime
