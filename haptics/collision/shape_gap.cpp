#include "haptics/collision/shape_gap.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fulcrum {

namespace {

// A normal does not turn further than this, radians, before it is looked at anew.
constexpr double kFarthestTurn = 0.5;

// Round a centre that lies `apart` away.
Gap round_gap(const Vector3& apart, double radius_m) noexcept {
    const double distance_m = apart.norm();
    if (!(distance_m > 0.0)) {
        return {.normal_B = Vector3::UnitY(), .gap_m = -radius_m};
    }
    return {.normal_B = apart / distance_m,
            .gap_m = distance_m - radius_m,
            .curvature_per_m = 1.0 / distance_m};
}

// How far a coordinate that lies `beyond` a border goes along a direction until it is back at it.
double way_back(double beyond, double rate) noexcept {
    return beyond > 0.0 && rate < 0.0 ? beyond / -rate : std::numeric_limits<double>::infinity();
}

double sign_of(double x) noexcept {
    return x < 0.0 ? -1.0 : 1.0;
}

// A cylinder as seen in the half plane through its axis and a point.
struct Profile {
    Vector3 outwards{Vector3::UnitX()};  // unit, across the axis
    double from_axis_m = 0.0;
    double beyond_side_m = 0.0;
    double beyond_end_m = 0.0;
    double end = 1.0;  // which: the sign of y
};

Profile find_profile(const CylinderShape& cylinder, const Vector3& p) noexcept {
    Profile profile;
    profile.from_axis_m = std::hypot(p.x(), p.z());
    if (profile.from_axis_m > 0.0) {
        profile.outwards = Vector3(p.x(), 0.0, p.z()) / profile.from_axis_m;
    }
    profile.beyond_side_m = profile.from_axis_m - cylinder.radius_m;
    profile.beyond_end_m = std::abs(p.y()) - cylinder.half_height_m;
    profile.end = sign_of(p.y());
    return profile;
}

}  // namespace

Gap find_gap(const SphereShape& sphere, const Vector3& p_B) noexcept {
    return round_gap(p_B, sphere.radius_m);
}

Gap find_gap(const BoxShape& box, const Vector3& p_B) noexcept {
    const Vector3 beyond = p_B.cwiseAbs() - box.half_size_m;
    const int n_beyond =
        (beyond.x() > 0.0 ? 1 : 0) + (beyond.y() > 0.0 ? 1 : 0) + (beyond.z() > 0.0 ? 1 : 0);
    if (n_beyond <= 1) {
        // Over a face, or under it.
        int axis = 0;
        const double gap_m = beyond.maxCoeff(&axis);
        return {.normal_B = sign_of(p_B[axis]) * Vector3::Unit(axis), .gap_m = gap_m};
    }
    Vector3 apart = beyond.cwiseMax(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        apart[axis] *= sign_of(p_B[axis]);
    }
    Gap gap = round_gap(apart, 0.0);
    for (int axis = 0; axis < 3 && n_beyond == 2; ++axis) {
        if (!(beyond[axis] > 0.0)) {
            gap.straight_B = Vector3::Unit(axis);
        }
    }
    return gap;
}

Gap find_gap(const CapsuleShape& capsule, const Vector3& p_B) noexcept {
    const double along = std::clamp(p_B.y(), -capsule.half_length_m, capsule.half_length_m);
    Gap gap = round_gap(p_B - along * Vector3::UnitY(), capsule.radius_m);
    if (!(gap.curvature_per_m > 0.0)) {
        gap.normal_B = Vector3::UnitX();  // on the axis, where no way out is shorter
    }
    if (std::abs(p_B.y()) <= capsule.half_length_m) {
        gap.straight_B = Vector3::UnitY();
    }
    return gap;
}

Gap find_gap(const CylinderShape& cylinder, const Vector3& p_B) noexcept {
    const Profile p = find_profile(cylinder, p_B);
    const Vector3 up = p.end * Vector3::UnitY();
    if (p.beyond_side_m > 0.0 && p.beyond_end_m > 0.0) {
        Gap gap = round_gap(p.beyond_side_m * p.outwards + p.beyond_end_m * up, 0.0);
        gap.straight_B = p.outwards.cross(Vector3::UnitY());  // nearly: the rim is a ring
        return gap;
    }
    if (p.beyond_side_m > p.beyond_end_m) {
        return {.normal_B = p.outwards,
                .gap_m = p.beyond_side_m,
                .curvature_per_m = p.from_axis_m > 0.0 ? 1.0 / p.from_axis_m : 0.0,
                .straight_B = Vector3::UnitY()};
    }
    return {.normal_B = up, .gap_m = p.beyond_end_m};
}

double find_bend(const SphereShape& /*sphere*/, const Vector3& p_B,
                 const Vector3& /*direction_B*/) noexcept {
    return kFarthestTurn * p_B.norm();
}

double find_bend(const BoxShape& box, const Vector3& p_B, const Vector3& direction_B) noexcept {
    const Vector3 beyond = p_B.cwiseAbs() - box.half_size_m;
    double way_m = kFarthestTurn * beyond.cwiseMax(0.0).norm();
    for (int axis = 0; axis < 3; ++axis) {
        way_m = std::min(way_m, way_back(beyond[axis], direction_B[axis] * sign_of(p_B[axis])));
    }
    return way_m;
}

double find_bend(const CapsuleShape& capsule, const Vector3& p_B,
                 const Vector3& direction_B) noexcept {
    const double beyond_m = std::abs(p_B.y()) - capsule.half_length_m;
    const Vector3 apart(p_B.x(), std::max(beyond_m, 0.0), p_B.z());
    return std::min(kFarthestTurn * apart.norm(),
                    way_back(beyond_m, direction_B.y() * sign_of(p_B.y())));
}

double find_bend(const CylinderShape& cylinder, const Vector3& p_B,
                 const Vector3& direction_B) noexcept {
    const Profile p = find_profile(cylinder, p_B);
    if (p.beyond_end_m > 0.0 && p.beyond_side_m > 0.0) {
        return std::min({kFarthestTurn * std::hypot(p.beyond_side_m, p.beyond_end_m),
                         way_back(p.beyond_side_m, direction_B.dot(p.outwards)),
                         way_back(p.beyond_end_m, direction_B.y() * p.end)});
    }
    return kFarthestTurn * p.from_axis_m;
}

double bounding_radius_m(const SphereShape& sphere) noexcept {
    return sphere.radius_m;
}
double bounding_radius_m(const BoxShape& box) noexcept {
    return box.half_size_m.norm();
}
double bounding_radius_m(const CapsuleShape& capsule) noexcept {
    return capsule.radius_m + capsule.half_length_m;
}
double bounding_radius_m(const CylinderShape& cylinder) noexcept {
    return std::hypot(cylinder.radius_m, cylinder.half_height_m);
}

}  // namespace fulcrum
