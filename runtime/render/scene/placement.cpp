#include "runtime/render/scene/placement.h"

#include <algorithm>

namespace fulcrum::runtime {

namespace {
constexpr double kFurthestPlace_m = 1e6;
constexpr double kLeastScale = 1e-6;
constexpr double kLeastQuaternion = 1e-6;
}  // namespace

std::optional<Placement> place(const Pose& pose_W, const Vector3& scale) {
    if (!is_finite(pose_W) || !scale.allFinite() ||
        pose_W.position.cwiseAbs().maxCoeff() > kFurthestPlace_m ||
        scale.cwiseAbs().minCoeff() < kLeastScale ||
        scale.cwiseAbs().maxCoeff() > 1.0 / kLeastScale) {
        return std::nullopt;
    }
    const double length = pose_W.orientation.coeffs().norm();
    if (!(length > kLeastQuaternion) || !std::isfinite(length)) {
        return std::nullopt;
    }
    const Matrix3 turn = pose_W.orientation.normalized().toRotationMatrix();
    Placement placement;
    placement.world_from_model.topLeftCorner<3, 3>() = (turn * scale.asDiagonal()).cast<float>();
    placement.world_from_model.topRightCorner<3, 1>() = pose_W.position.cast<float>();
    placement.normal_from_model = (turn * scale.cwiseInverse().asDiagonal()).cast<float>();
    placement.mirrored = scale.prod() < 0.0;
    return placement;
}

Bounds bounds_of(const Placement& placement, const Vector3f& lowest, const Vector3f& highest) {
    const Vector3f middle = 0.5F * (lowest + highest);
    const Vector3f half = 0.5F * (highest - lowest);
    const Matrix3f turn = placement.world_from_model.topLeftCorner<3, 3>();
    const Vector3f centre = turn * middle + placement.world_from_model.topRightCorner<3, 1>();
    const Vector3f half_W = turn.cwiseAbs() * half;
    Bounds bounds;
    bounds.centre_W = centre.cast<double>();
    // The smaller of the turned box and the longest side's ball, so that a turning fruit's mark
    // does not swell.
    const Matrix3f sides = turn * half.asDiagonal();
    const double longest = static_cast<double>(
        std::max({sides.col(0).norm(), sides.col(1).norm(), sides.col(2).norm()}));
    bounds.radius_m = longest;
    bounds.enclosing_radius_m = static_cast<double>(half_W.norm());
    bounds.half_width_m = std::min(static_cast<double>(std::max(half_W.x(), half_W.z())), longest);
    bounds.lowest_m = bounds.centre_W.y() - static_cast<double>(half_W.y());
    return bounds;
}

}  // namespace fulcrum::runtime
