// The camera as mathematics: world point to pixel and back, and where the pointer points.
//
//   depth d = forward . (p_W - eye_W)
//   x_px = w/2 + f (right . (p_W - eye_W)) / d,  y_px = c h - f (up . (p_W - eye_W)) / d,
//   f = (h/2) / tan(angle/2)
//   c = kTargetHeight: the target is seen above the middle, for the words stand at the bottom.
//   Pixels count from the top left corner, +x right, +y down; a pixel's centre is at .5.
//
// Thread: any; a value. Cost: a few dozen multiplications.
// Source: R. Hartley and A. Zisserman, Multiple View Geometry in Computer Vision, 2nd ed., 2003,
// section 6.1 (pinhole camera).
#pragma once

#include "haptics/math/spatial.h"
#include "runtime/scene/description.h"

#include <optional>

namespace fulcrum::runtime {

/// Where the target is seen, as a part of the picture's height from the top.
inline constexpr double kTargetHeight = 0.43;

/// A place on the screen and how far into the picture it lies.
struct ScreenPoint {
    Vector2 position_px{Vector2::Zero()};
    double depth_m = 0.0;  ///< along the viewing direction, > 0
};

/// A half-line from the eye.
struct Ray {
    Vector3 origin_W{Vector3::Zero()};
    Vector3 direction_W{-Vector3::UnitZ()};  ///< unit length
};

/// A pinhole camera for a picture of a given size.
class Camera {
  public:
    /// What is not finite falls back to the description's defaults; the angle is kept within 5 to
    /// 120 degrees; an eye on its target looks along -Z. Sizes below 1 pixel count as 1. In a
    /// picture narrower than 4:3 the angle grows, so that as much is seen from left to right.
    /// `target_height` is where the target is seen, 0 top to 1 bottom.
    Camera(const CameraDescription& description, int width_px, int height_px,
           double target_height = kTargetHeight);

    /// Where a point is seen; nothing when it lies behind the eye or is not finite.
    [[nodiscard]] std::optional<ScreenPoint> project(const Vector3& point_W) const;
    /// The point seen at a place of the screen at a depth; inverse of `project`.
    [[nodiscard]] Vector3 unproject(const ScreenPoint& point) const;
    /// From the eye through a place of the screen.
    [[nodiscard]] Ray ray(const Vector2& position_px) const;

    /// World to clip space, as OpenGL has it (-w <= z <= w).
    [[nodiscard]] Matrix4f clip_from_world() const;

    [[nodiscard]] const Vector3& eye_W() const { return eye_W_; }
    [[nodiscard]] const Vector3& target_W() const { return target_W_; }
    [[nodiscard]] const Vector3& forward_W() const { return forward_W_; }
    [[nodiscard]] const Vector3& right_W() const { return right_W_; }
    [[nodiscard]] const Vector3& up_W() const { return up_W_; }
    [[nodiscard]] double distance_m() const { return (target_W_ - eye_W_).norm(); }
    /// Pixels that a metre across the view takes at this depth.
    [[nodiscard]] double px_per_m(double depth_m) const { return focal_px_ / depth_m; }

    /// So many dots are drawn for a pixel's side that is shown (PictureQuality::scale); 1 before.
    void draw_dots(double per_px) { dots_per_px_ = per_px; }
    [[nodiscard]] double dots_per_m(double depth_m) const {
        return dots_per_px_ * px_per_m(depth_m);
    }

  private:
    Vector3 eye_W_;
    Vector3 target_W_;
    Vector3 forward_W_;
    Vector3 right_W_;
    Vector3 up_W_;
    double width_px_ = 1.0;
    double height_px_ = 1.0;
    double centre_y_px_ = 0.5;
    double focal_px_ = 1.0;
    double dots_per_px_ = 1.0;
};

/// The unit normal of the pointer's plane, away from the eye: level, or along the view when looking steeply down or up.
[[nodiscard]] Vector3 pointer_plane_normal(const Camera& camera);

/// Where the pointer is in the world: on the upright plane through the camera's target that faces
/// the camera (when looking steeply down or up, the plane across the view), moved `wheel_m` away
/// from the eye. Nothing when the pointer's ray runs along the plane or away from it.
[[nodiscard]] std::optional<Vector3> pointer_on_plane(const Camera& camera,
                                                      const Vector2& position_px, double wheel_m);

}  // namespace fulcrum::runtime
