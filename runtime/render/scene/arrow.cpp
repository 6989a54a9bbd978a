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
constexpr double kSlim = 0.55;  // of these, where arrows lie close together

// In newtons; one that cannot be drawn counts for nothing.
double size_of(const ViewForce& force) {
    return force.visible && force.force_W.allFinite() ? compute_length(force.force_W) : 0.0;
}
}  // namespace

ArrowStyle style_of_balance(const std::vector<ViewForce>& forces) {
    double largest_N = 0.0;
    for (const ViewForce& force : forces) {
        largest_N = std::max(largest_N, size_of(force));
    }
    const double scale =
        std::min(kLongestForce_N / std::max(largest_N, kLeastForce_N), kMostStretch);
    return {scale, kSlim};
}

double common_scale(const std::vector<ViewTorque>& torques) {
    double largest_N = kLongestForce_N;
    for (const ViewTorque& torque : torques) {
        largest_N = std::max(largest_N, size_of(torque.force));
    }
    return kLongestForce_N / largest_N;
}

std::optional<Arrow> arrow_for(const ViewForce& force, const Camera& camera,
                               const ArrowStyle& style) {
    if (!force.visible || !force.at_W.allFinite() || !force.force_W.allFinite()) {
        return std::nullopt;
    }
    const double newtons = compute_length(force.force_W);
    if (!(newtons >= kLeastForce_N)) {
        return std::nullopt;
    }
    const double distance_m = camera.distance_m();
    const double head_m = style.girth * kHeadLength * distance_m;
    const double head_radius_m = style.girth * kHeadRadius * distance_m;
    const double shaft_radius_m = style.girth * kShaftRadius * distance_m;
    const double length_m = std::clamp(kLengthPerNewton * style.scale * newtons,
                                       1.25 * style.girth * kHeadLength, kLongestArrow) *
                            distance_m;
    const Vector3 way = compute_direction(force.force_W);
    const Quaternion turn(Quaternion::FromTwoVectors(Vector3::UnitY(), way));

    Arrow arrow;
    const double shaft_m = length_m - 0.9 * head_m;
    const auto shaft = place({force.at_W, turn}, {shaft_radius_m, shaft_m, shaft_radius_m});
    const auto head = place({force.at_W + (length_m - head_m) * way, turn},
                            {head_radius_m, head_m, head_radius_m});
    if (!shaft || !head) {
        return std::nullopt;
    }
    arrow.shaft = *shaft;
    arrow.head = *head;
    arrow.tail_W = force.at_W;
    arrow.tip_W = force.at_W + length_m * way;
    arrow.radius_m = head_radius_m;
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
    const Quaternion turn(Quaternion::FromTwoVectors(Vector3::UnitY(), compute_direction(way)));
    return place({torque.axis_W, turn}, {radius_m, length_m, radius_m});
}

}  // namespace fulcrum::runtime
