#include "runtime/render/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fulcrum::runtime {

namespace {

constexpr double kLeastAngle_deg = 5.0;
constexpr double kMostAngle_deg = 120.0;
constexpr double kLeastDistance_m = 1e-6;
constexpr double kFurthest_m = 1e6;       // beyond it single precision draws nonsense
constexpr double kNarrowest = 4.0 / 3.0;  // width / height below which the angle grows
constexpr double kNearPlane = 0.03;       // of the distance to the target
constexpr double kFarPlane = 60.0;        // of the distance to the target
constexpr double kSteep = 0.35;           // sideways part of a view that counts as steep
constexpr double kAlongPlane = 1e-6;      // a ray closer to the plane's direction misses it

bool usable(const Vector3& point) {
    return point.allFinite() && point.cwiseAbs().maxCoeff() < kFurthest_m;
}

}  // namespace

Camera::Camera(const CameraDescription& description, int width_px, int height_px,
               double target_height)
    : width_px_(std::max(width_px, 1)),
      height_px_(std::max(height_px, 1)),
      centre_y_px_(target_height * height_px_) {
    const CameraDescription standard;
    const bool placed = usable(description.eye_W) && usable(description.target_W);
    eye_W_ = placed ? description.eye_W : standard.eye_W;
    target_W_ = placed ? description.target_W : standard.target_W;
    if ((target_W_ - eye_W_).norm() < kLeastDistance_m) {
        eye_W_ = target_W_ + Vector3::UnitZ();
    }

    // Looking straight up or down, the top of the picture is away from +Z.
    forward_W_ = (target_W_ - eye_W_).normalized();
    const Vector3 sideways = forward_W_.cross(Vector3::UnitY());
    right_W_ = sideways.norm() > 1e-6 ? sideways.normalized() : Vector3::UnitX();
    up_W_ = right_W_.cross(forward_W_);

    const double asked_deg = std::isfinite(description.vertical_angle_deg)
                                 ? description.vertical_angle_deg
                                 : standard.vertical_angle_deg;
    const double angle_rad =
        std::clamp(asked_deg, kLeastAngle_deg, kMostAngle_deg) * std::numbers::pi / 180.0;
    const double seen_height_px = std::min(height_px_, width_px_ / kNarrowest);
    focal_px_ = 0.5 * seen_height_px / std::tan(0.5 * angle_rad);
}

std::optional<ScreenPoint> Camera::project(const Vector3& point_W) const {
    if (!usable(point_W)) {
        return std::nullopt;
    }
    const Vector3 from_eye = point_W - eye_W_;
    const double depth_m = forward_W_.dot(from_eye);
    if (depth_m <= kNearPlane * distance_m()) {
        return std::nullopt;
    }
    const double scale = px_per_m(depth_m);
    return ScreenPoint{{0.5 * width_px_ + scale * right_W_.dot(from_eye),
                        centre_y_px_ - scale * up_W_.dot(from_eye)},
                       depth_m};
}

Vector3 Camera::unproject(const ScreenPoint& point) const {
    const double scale = 1.0 / px_per_m(point.depth_m);
    return eye_W_ + point.depth_m * forward_W_ +
           scale * (point.position_px.x() - 0.5 * width_px_) * right_W_ -
           scale * (point.position_px.y() - centre_y_px_) * up_W_;
}

Ray Camera::ray(const Vector2& position_px) const {
    return {eye_W_, (unproject({position_px, 1.0}) - eye_W_).normalized()};
}

Matrix4f Camera::clip_from_world() const {
    const double near_m = kNearPlane * distance_m();
    const double far_m = kFarPlane * distance_m();
    Matrix4 view = Matrix4::Identity();
    view.block<1, 3>(0, 0) = right_W_.transpose();
    view.block<1, 3>(1, 0) = up_W_.transpose();
    view.block<1, 3>(2, 0) = -forward_W_.transpose();
    view.block<3, 1>(0, 3) = -view.block<3, 3>(0, 0) * eye_W_;

    Matrix4 clip = Matrix4::Zero();
    clip(0, 0) = focal_px_ / (0.5 * width_px_);
    clip(1, 1) = focal_px_ / (0.5 * height_px_);
    clip(1, 2) = 2.0 * centre_y_px_ / height_px_ - 1.0;
    clip(2, 2) = (near_m + far_m) / (near_m - far_m);
    clip(2, 3) = 2.0 * near_m * far_m / (near_m - far_m);
    clip(3, 2) = -1.0;
    return (clip * view).cast<float>();
}

// Upright, so that moving the pointer up moves the hand up, not towards the wall.
Vector3 pointer_plane_normal(const Camera& camera) {
    const Vector3& forward = camera.forward_W();
    const Vector3 level(forward.x(), 0.0, forward.z());
    return level.norm() > kSteep ? Vector3(level.normalized()) : forward;
}

std::optional<Vector3> pointer_on_plane(const Camera& camera, const Vector2& position_px,
                                        double wheel_m) {
    const Vector3 normal = pointer_plane_normal(camera);
    const Vector3 on_plane = camera.target_W() + wheel_m * normal;
    const Ray ray = camera.ray(position_px);
    const double towards = normal.dot(ray.direction_W);
    const double distance_m = normal.dot(on_plane - ray.origin_W) / towards;
    if (!(std::abs(towards) > kAlongPlane) || !(distance_m > 0.0) || !std::isfinite(distance_m)) {
        return std::nullopt;
    }
    return ray.origin_W + distance_m * ray.direction_W;
}

}  // namespace fulcrum::runtime
