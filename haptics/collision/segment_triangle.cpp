#include "haptics/collision/segment_triangle.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fulcrum {

namespace {

// The plane of a triangle as seen from a point off it: orientations in the plane are then orientations in space.
class PlaneView {
  public:
    explicit PlaneView(const PreparedTriangle& triangle) noexcept
        : triangle_(triangle), eye_(triangle.a) {
        // Along the normal's largest component, far enough not to be rounded away.
        int axis = 0;
        triangle.doubled_area.cwiseAbs().maxCoeff(&axis);
        const double step =
            largest_component(triangle.b - triangle.a) + largest_component(triangle.a);
        eye_[axis] += triangle.doubled_area[axis] > 0.0 ? step : -step;
    }

    // +1 when x, y, z run counter-clockwise as seen from the front.
    [[nodiscard]] int turn(const Vector3& x, const Vector3& y, const Vector3& z) const noexcept {
        return orientation(x, y, z, eye_);
    }

    [[nodiscard]] bool contains(const Vector3& point) const noexcept {
        return turn(triangle_.a, triangle_.b, point) >= 0 &&
               turn(triangle_.b, triangle_.c, point) >= 0 &&
               turn(triangle_.c, triangle_.a, point) >= 0;
    }

    // Where the segment crosses the edge u v, from 0 to 1; 2 when it does not.
    [[nodiscard]] double cross_edge(const Vector3& from, const Vector3& to, const Vector3& u,
                                    const Vector3& v) const noexcept {
        const int u_turn = turn(from, to, u);
        const int v_turn = turn(from, to, v);
        // A segment along the edge's line meets the edge's neighbours at its corners.
        const bool along = u_turn == 0 && v_turn == 0;
        if (along || u_turn * v_turn > 0 || turn(u, v, from) * turn(u, v, to) > 0) {
            return 2.0;
        }
        const Vector3 normal = triangle_.doubled_area.cross(v - u);
        const double height_from = normal.dot(from - u);
        const double fall = normal.dot(from - to);
        return fall == 0.0 ? 0.0 : std::clamp(height_from / fall, 0.0, 1.0);
    }

  private:
    const PreparedTriangle& triangle_;
    Vector3 eye_;
};

// A point as seen from a segment's start, with its largest coordinate.
struct Offset {
    const Vector3* point;
    double x;
    double y;
    double z;
    double largest;
};

// On which side of an edge a segment's line passes: the orientation of both's ends. It is written out, for three edges share what
// they begin with, and numbers that stay in registers need not wait for memory.
class LineView {
  public:
    LineView(const Vector3& from, const Vector3& to) noexcept : from_(from), way_(offset(to)) {}

    [[nodiscard]] Offset offset(const Vector3& point) const noexcept {
        const double x = point.x() - from_.x();
        const double y = point.y() - from_.y();
        const double z = point.z() - from_.z();
        return {&point, x, y, z, std::max(std::max(std::abs(x), std::abs(y)), std::abs(z))};
    }
    // orientation(from, to, u, v)
    [[nodiscard]] int turn(const Offset& u, const Offset& v) const noexcept {
        const double determinant = (way_.y * u.z - way_.z * u.y) * v.x +
                                   (way_.z * u.x - way_.x * u.z) * v.y +
                                   (way_.x * u.y - way_.y * u.x) * v.z;
        if (std::abs(determinant) > kDeterminantError * way_.largest * u.largest * v.largest) {
            return determinant > 0.0 ? 1 : -1;
        }
        return orientation_exact(from_, *way_.point, *u.point, *v.point);
    }

  private:
    const Vector3& from_;
    Offset way_;
};

// A segment almost in the triangle's plane has heights of mere rounding; still it can only meet the triangle where it is
// within its box. A search that goes by boxes may rely on that.
double clamp_to_box(const PreparedTriangle& triangle, const Vector3& from, const Vector3& to,
                    double t) noexcept {
    const Vector3 lower = triangle.a.cwiseMin(triangle.b).cwiseMin(triangle.c);
    const Vector3 upper = triangle.a.cwiseMax(triangle.b).cwiseMax(triangle.c);
    double t_enter = 0.0;
    double t_leave = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double rate = to[axis] - from[axis];
        if (rate != 0.0) {
            const double t_lower = (lower[axis] - from[axis]) / rate;
            const double t_upper = (upper[axis] - from[axis]) / rate;
            t_enter = std::max(t_enter, std::min(t_lower, t_upper));
            t_leave = std::min(t_leave, std::max(t_lower, t_upper));
        }
    }
    return std::min(std::max(std::min(t, t_leave), t_enter), 1.0);
}

// The segment lies in the triangle's plane.
SegmentHit meet_coplanar(const PreparedTriangle& triangle, const Vector3& from,
                         const Vector3& to) noexcept {
    const PlaneView view(triangle);
    if (view.contains(from)) {
        return {0.0, triangle.index, 0};
    }
    const double t = std::min({view.cross_edge(from, to, triangle.a, triangle.b),
                               view.cross_edge(from, to, triangle.b, triangle.c),
                               view.cross_edge(from, to, triangle.c, triangle.a)});
    return t <= 1.0 ? SegmentHit{clamp_to_box(triangle, from, to, t), triangle.index, 0}
                    : SegmentHit{};
}

}  // namespace

SegmentHit meet_in_plane(const PreparedTriangle& triangle, const Vector3& from, const Vector3& to,
                         double height_from, double height_to, int side_from,
                         int side_to) noexcept {
    if (side_from == 0 && side_to == 0) {
        return meet_coplanar(triangle, from, to);
    }
    const LineView view(from, to);
    const Offset a = view.offset(triangle.a);
    const Offset b = view.offset(triangle.b);
    const Offset c = view.offset(triangle.c);
    const int past_ab = view.turn(a, b);
    const int past_bc = view.turn(b, c);
    const int past_ca = view.turn(c, a);
    const bool any_left = past_ab > 0 || past_bc > 0 || past_ca > 0;
    const bool any_right = past_ab < 0 || past_bc < 0 || past_ca < 0;
    if (any_left && any_right) {
        return {};
    }
    // An end in the plane has no height, whatever rounding says.
    const double above = side_from == 0 ? 0.0 : std::abs(height_from);
    const double below = side_to == 0 ? 0.0 : std::abs(height_to);
    const double t = above + below > 0.0 ? above / (above + below) : 0.0;
    return {clamp_to_box(triangle, from, to, t), triangle.index,
            side_from != 0 ? side_from : -side_to};
}

}  // namespace fulcrum
