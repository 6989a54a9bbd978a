#include "haptics/levels/piece_shape.h"

#include "haptics/collision/convex_depth.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace fulcrum {

namespace {

using FlatPoint = std::pair<Vector2, std::size_t>;

double turn_of(const Vector2& a, const Vector2& b, const Vector2& c) {
    return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

// One side of the hull, from the first point to the last.
template <class Points>
void add_chain(const Points& points, std::vector<FlatPoint>& hull) {
    constexpr double kStraight = 1.0e-12;  // sine of a turn of mere rounding
    const std::size_t bottom = hull.size();
    for (const FlatPoint& point : points) {
        while (hull.size() >= bottom + 2) {
            const Vector2& a = hull[hull.size() - 2].first;
            const Vector2& b = hull.back().first;
            const double size = (b - a).norm() * (point.first - a).norm();
            if (turn_of(a, b, point.first) > kStraight * size) {
                break;
            }
            hull.pop_back();
        }
        hull.push_back(point);
    }
    hull.pop_back();  // it begins the next chain
}

}  // namespace

PiecePlane PiecePlane::of(const PieceTriangle& triangle) noexcept {
    const Vector3 doubled = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
    const double size = doubled.norm();
    if (!(size > 0.0)) {
        return {};
    }
    const Vector3 normal = doubled / size;
    return {normal, normal.dot(triangle[0] + triangle[1] + triangle[2]) / 3.0};
}

void PieceShape::clear() noexcept {
    corners.clear();
    planes.clear();
    area_m2 = 0.0;
}

void PieceShape::add_triangle(const PieceTriangle& triangle) {
    planes.push_back(PiecePlane::of(triangle));
    area_m2 += 0.5 * (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).norm();
}

bool PieceShape::is_behind(const Vector3& point, double slack_m) const noexcept {
    // From the newest on: what bounds a point is near it.
    for (std::size_t i = planes.size(); i-- > 0;) {
        if (planes[i].height_m(point) > slack_m) {
            return false;
        }
    }
    return true;
}

bool PieceShape::is_before(const PiecePlane& plane, double slack_m) const noexcept {
    for (std::size_t i = corners.size(); i-- > 0;) {
        if (plane.height_m(corners[i]) > slack_m) {
            return false;
        }
    }
    return true;
}

bool PieceShape::is_flat(double slack_m) const noexcept {
    const PiecePlane& plane = planes.front();
    return std::ranges::all_of(corners, [&](const Vector3& corner) {
        return std::abs(plane.height_m(corner)) <= slack_m;
    });
}

bool PieceShape::fills_its_polygon() const {
    constexpr double kRounding = 1.0e-6;  // of the area
    const std::vector<Vector3> polygon = find_flat_hull(corners, planes.front().normal);
    Vector3 doubled = Vector3::Zero();
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        doubled += (polygon[i - 1] - polygon[0]).cross(polygon[i] - polygon[0]);
    }
    return 0.5 * doubled.norm() <= (1.0 + kRounding) * area_m2;
}

std::vector<Vector3> find_flat_hull(const std::vector<Vector3>& points, const Vector3& normal) {
    if (points.size() < 3 || !(normal.squaredNorm() > 0.0)) {
        return points;
    }
    const Vector3 along = normal.unitOrthogonal();
    const Vector3 across = normal.cross(along);
    std::vector<FlatPoint> sorted;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vector3 from = points[i] - points[0];
        sorted.emplace_back(Vector2(along.dot(from), across.dot(from)), i);
    }
    std::ranges::sort(sorted, [](const FlatPoint& a, const FlatPoint& b) {
        return std::tie(a.first.x(), a.first.y(), a.second) <
               std::tie(b.first.x(), b.first.y(), b.second);
    });
    std::vector<FlatPoint> hull;
    add_chain(sorted, hull);
    std::ranges::reverse(sorted);
    add_chain(sorted, hull);
    std::vector<Vector3> corners;
    corners.reserve(hull.size());
    for (const FlatPoint& corner : hull) {
        corners.push_back(points[corner.second]);
    }
    return corners;
}

InnerHull::InnerHull(const PieceShape& shape, double slack_m)
    : planes_(shape.planes), points_(shape.corners), slack_m_(slack_m) {
    constexpr double kSmaller = 1.0e-5;
    for (const Vector3& point : points_) {
        middle_ += point / static_cast<double>(points_.size());
    }
    for (Vector3& point : points_) {
        point = middle_ + (1.0 - kSmaller) * (point - middle_);
    }
    lower_ = upper_ = points_.front();
    for (const Vector3& point : points_) {
        lower_ = lower_.cwiseMin(point);
        upper_ = upper_.cwiseMax(point);
    }
    touch_m_ = 0.1 * kSmaller * (upper_ - lower_).norm();
}

bool InnerHull::is_entered_by(const PieceTriangle& triangle) const noexcept {
    const auto is_beyond = [&](const PiecePlane& plane) noexcept {
        return std::ranges::all_of(triangle, [&](const Vector3& corner) {
            return plane.height_m(corner) > -0.01 * touch_m_ - slack_m_;
        });
    };
    if (std::ranges::any_of(planes_, is_beyond)) {
        return false;
    }
    const Vector3 start = (triangle[0] + triangle[1] + triangle[2]) / 3.0 - middle_;
    const HullPair pair =
        find_hull_pair({.points = points_}, {.points = triangle}, Matrix3::Identity(),
                       Vector3::Zero(), start.squaredNorm() > 0.0 ? start : Vector3::UnitX(), 0.0);
    if (pair.is_far || !(slack_m_ > 0.0)) {
        return !pair.is_far;
    }
    const HullView hull{.points = points_};
    const HullView flat{.points = triangle};
    return -find_convex_depth([&](const Vector3& d) noexcept {
                return Vector3(hull.find_support(d) - flat.find_support(-d));
            }).gap_m > slack_m_;
}

}  // namespace fulcrum
