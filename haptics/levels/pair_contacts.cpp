#include "haptics/levels/pair_contacts.h"

#include "haptics/collision/convex_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fulcrum {

namespace {

constexpr double kRound = 0.5;      // a mean normal that is shorter says little
constexpr double kFacing = 0.3;     // cosine by which pieces face each other for certain
constexpr double kAsDeep = 1.0e-6;  // of d: what rounding leaves

// Is a direction within the cone, 15 degrees wider?
bool is_in_cone(const LevelNode& node, const Vector3& normal, const Vector3& direction) noexcept {
    constexpr double kWiderCosine = 0.9659258262890683;
    constexpr double kWiderSine = 0.25881904510252074;
    const double length = normal.norm();
    if (node.cone_cosine <= -kWiderCosine || !(length > 0.0)) {
        return true;
    }
    const double sine = std::sqrt(std::max(0.0, 1.0 - node.cone_cosine * node.cone_cosine));
    return normal.dot(direction) >= length * (node.cone_cosine * kWiderCosine - sine * kWiderSine);
}

// A hull's points as `find_far_corner` asks for them: each one's height along a direction, and some few of them themselves.
struct PointsAsTheyAre {
    std::span<const Vector3> points;
    Vector3 up;
    [[nodiscard]] double height_m(std::size_t i) const noexcept { return up.dot(points[i]); }
    [[nodiscard]] const Vector3& operator()(std::size_t i) const noexcept { return points[i]; }
};
struct PlacedPoints {
    const PlacedHull& hull;
    Vector3 up;
    [[nodiscard]] double height_m(std::size_t i) const noexcept { return up.dot(hull.point(i)); }
    [[nodiscard]] Vector3 operator()(std::size_t i) const noexcept { return hull.point(i); }
};
// Of many: heights in their own frame, for most are not in the band.
struct TurnedPoints {
    std::span<const Vector3> points;
    const PlacedHull& hull;
    Vector3 up_B;
    double origin_m;
    [[nodiscard]] double height_m(std::size_t i) const noexcept {
        return origin_m + up_B.dot(points[i]);
    }
    [[nodiscard]] Vector3 operator()(std::size_t i) const noexcept { return hull.point(i); }
};

}  // namespace

// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): filled as far as there are points
PlacedHull::PlacedHull(const HullView& hull, const Matrix3& turn, const Vector3& shift) noexcept
    : hull_(hull), turn_(turn), shift_(shift), is_large_(hull.points.size() > kClimbFrom) {
    if (is_large_) {
        return;
    }
    for (std::size_t i = 0; i < hull.points.size(); ++i) {
        points_[i] = place(hull.points[i]);
    }
    placed_.points = std::span(points_).first(hull.points.size());
}

HullPair PlacedHull::find_nearest(const Vector3& point, const Vector3& start, double enough_m,
                                  std::int32_t at) const noexcept {
    if (!is_large_) {
        return find_nearest_in_hull(placed_, point, start, enough_m);
    }
    HullPair near = find_nearest_in_hull(hull_, turn_.transpose() * (point - shift_),
                                         turn_.transpose() * start, enough_m, at);
    near.on_first = place(near.on_first);
    return near;
}

PairContacts::PairContacts(const PiecesNear& pieces, const HullPair& found) noexcept
    : pieces_(pieces),
      tool_(pieces.tool_hull, pieces.turn, pieces.shift),
      tool_normal_(pieces.turn * pieces.tool.normal_B) {
    const double least_m = 1.0e-7 * (pieces.object.radius_m + pieces.tool.radius_m);
    bool is_behind = false;
    if (found.gap_m > least_m) {
        normal_ = (found.on_second - found.on_first) / found.gap_m;
        depth_m_ = -found.gap_m;
        const bool looks = pieces.object.normal_B.norm() >= kRound || tool_normal_.norm() >= kRound;
        is_behind = looks && found.gap_m <= pieces.within_m && do_both_look(-normal_, kFacing) &&
                    are_thin();
        if (is_behind) {
            normal_ = -normal_;
            depth_m_ = found.gap_m;
        }
    } else {
        find_way_out(found);
    }
    if (!has_such_normal()) {
        return;
    }
    const bool do_meet = !(found.gap_m > least_m);
    if (!is_behind) {
        add_corners_of_tool();
        add_corners_of_object();
    }
    add_nearest(
        {do_meet ? Vector3(found.on_second - 0.5 * depth_m_ * normal_) : found.on_second, depth_m_},
        do_meet);
}

// Where faces lie on each other it is any of their points, and would jump from corner to corner: corners that are as deep say more.
void PairContacts::add_nearest(const PairPoint& point, bool do_meet) noexcept {
    const double near2 = pieces_.spread_m * pieces_.spread_m;
    const double as_deep_m = point.depth_m - kAsDeep * pieces_.within_m;
    int n_as_deep = 0;
    for (const PairPoint& corner : points()) {
        if (corner.depth_m > as_deep_m) {
            ++n_as_deep;
            if ((corner.place_O - point.place_O).squaredNorm() < near2) {
                return;
            }
        }
    }
    if (n_as_deep >= 3) {
        return;
    }
    if (!do_meet || n_ <= kCorners) {
        points_[n_++] = point;
    }
}

// Behind a thin piece that looks one way is the inside of its body. Behind a thick one may be a hole, to whose wall the piece's hull reaches from
// the other side of the body; and what came there through the piece is deeper than d.
bool PairContacts::are_thin() const noexcept {
    const double object_m = normal_.dot(pieces_.object_hull.find_support(normal_)) -
                            normal_.dot(pieces_.object_hull.find_support(-normal_));
    const double tool_m =
        normal_.dot(tool_.find_support(normal_)) - normal_.dot(tool_.find_support(-normal_));
    return (object_m <= pieces_.within_m || pieces_.object.normal_B.norm() < kRound) &&
           (tool_m <= pieces_.within_m || tool_normal_.norm() < kRound);
}

double PairContacts::measure_depth_m(const Vector3& normal) const noexcept {
    return normal.dot(pieces_.object_hull.find_support(normal)) -
           normal.dot(tool_.find_support(-normal));
}

// The way of least translation, where both surfaces look so or end in an edge that does; else of the ways in which they look the least, unless
// that is far longer: then they cross at a border, and the contact is a neighbour's.
void PairContacts::find_way_out(const HullPair& found) noexcept {
    constexpr double kFarLonger = 4.0;
    HullCorners at = pieces_.corners;
    const auto find_support = [&](const Vector3& d) noexcept {
        return Vector3(tool_.find_support(d, at.second) -
                       pieces_.object_hull.find_support(-d, at.first));
    };
    normal_ = (found.is_held ? find_convex_depth(find_support, found.held)
                             : find_convex_depth(find_support))
                  .normal;
    depth_m_ = measure_depth_m(normal_);
    if (has_such_normal()) {
        return;
    }
    double least_m = kFarLonger * depth_m_;
    const auto try_way = [&](const Vector3& way) noexcept {
        const double length = way.norm();
        if (!(length > 0.0)) {
            return;
        }
        const Vector3 normal = way / length;
        const double depth_m = measure_depth_m(normal);
        if (do_both_look(normal, kFacing) && depth_m < least_m) {
            least_m = depth_m;
            normal_ = normal;
            depth_m_ = depth_m;
        }
    };
    const Vector3& out = pieces_.object.normal_B;
    const bool object_looks = out.norm() >= kRound;
    const bool tool_looks = tool_normal_.norm() >= kRound;
    if (object_looks) {
        try_way(out);
    }
    if (tool_looks) {
        try_way(-tool_normal_);
    }
    if (object_looks && tool_looks) {
        try_way(out - tool_normal_);
    }
}

// Does the object's piece look along the normal, and the tool's against it? One that is round looks everywhere.
bool PairContacts::do_both_look(const Vector3& normal, double least) const noexcept {
    const auto looks = [least](double cosine, double length) noexcept {
        return length < kRound || cosine >= least * length;
    };
    return looks(pieces_.object.normal_B.dot(normal), pieces_.object.normal_B.norm()) &&
           looks(-tool_normal_.dot(normal), tool_normal_.norm());
}

// Of the pieces beside a corner that touches one at least looks along the normal, for it is within their normals.
bool PairContacts::has_such_normal() const noexcept {
    // Of what is above many pieces the mean says less than the cone.
    const bool are_pieces = pieces_.object.n_children + pieces_.tool.n_children == 0;
    return (!are_pieces || do_both_look(normal_, 0.0)) &&
           is_in_cone(pieces_.object, pieces_.object.normal_B, normal_) &&
           is_in_cone(pieces_.tool, tool_normal_, -normal_);
}

template <class PointAt>
bool PairContacts::find_far_corner(std::size_t n_points, double lowest_m, const PointAt& point_at,
                                   Vector3& corner) const noexcept {
    double farthest2 = pieces_.spread_m * pieces_.spread_m;
    double lowest_seen_m = std::numeric_limits<double>::infinity();
    bool is_found = false;
    const double band_m = pieces_.within_m + std::max(depth_m_, 0.0);
    for (std::size_t i = 0; i < n_points; ++i) {
        const double height_m = point_at.height_m(i);
        if (height_m > lowest_m + band_m) {
            continue;
        }
        const Vector3& place = point_at(i);
        // The first is the deepest; of both ends of an edge, the first.
        if (n_tried_ == 0) {
            if (height_m < lowest_seen_m - kAsDeep * pieces_.within_m) {
                lowest_seen_m = height_m;
                corner = place;
                is_found = true;
            }
            continue;
        }
        double nearest2 = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < n_tried_; ++k) {
            nearest2 = std::min(nearest2, (place - tried_[k]).squaredNorm());
        }
        if (nearest2 > farthest2) {
            farthest2 = nearest2;
            corner = place;
            is_found = true;
        }
    }
    return is_found;
}

void PairContacts::add_corners_of_tool() noexcept {
    if (2.0 * pieces_.tool.radius_m < pieces_.spread_m) {
        return;
    }
    if (tool_.is_large()) {
        add_corners_of_tool(TurnedPoints{pieces_.tool_hull.points, tool_,
                                         pieces_.turn.transpose() * normal_,
                                         normal_.dot(pieces_.shift)});
    } else {
        add_corners_of_tool(PlacedPoints{tool_, normal_});
    }
}

template <class PointAt>
void PairContacts::add_corners_of_tool(const PointAt& point_at) noexcept {
    const double lowest_m = normal_.dot(tool_.find_support(-normal_));
    const double highest_m = normal_.dot(pieces_.object_hull.find_support(normal_));
    Vector3 corner;
    for (std::size_t i = 0; i < kCorners; ++i) {
        if (!find_far_corner(tool_.size(), lowest_m, point_at, corner)) {
            return;
        }
        tried_[n_tried_++] = corner;
        const HullPair near = find_nearest_in_hull(pieces_.object_hull, corner, normal_,
                                                   pieces_.within_m, pieces_.corners.first);
        if (near.is_far) {
            continue;
        }
        if (near.gap_m == 0.0) {
            points_[n_++] = {corner, highest_m - normal_.dot(corner)};
        } else if (near.gap_m <= pieces_.within_m &&
                   normal_.dot(corner - near.on_first) > 0.5 * near.gap_m) {
            points_[n_++] = {corner, -normal_.dot(corner - near.on_first)};
        }
    }
}

void PairContacts::add_corners_of_object() noexcept {
    if (2.0 * pieces_.object.radius_m < pieces_.spread_m) {
        return;
    }
    const PointsAsTheyAre point_at{pieces_.object_hull.points, -normal_};
    const double highest_m = normal_.dot(pieces_.object_hull.find_support(normal_));
    const double lowest_m = normal_.dot(tool_.find_support(-normal_));
    Vector3 corner;
    for (std::size_t i = 0; i < kCorners; ++i) {
        if (!find_far_corner(point_at.points.size(), -highest_m, point_at, corner)) {
            return;
        }
        tried_[n_tried_++] = corner;
        const HullPair near =
            tool_.find_nearest(corner, -normal_, pieces_.within_m, pieces_.corners.second);
        if (near.is_far) {
            continue;
        }
        const Vector3& on_tool = near.on_first;
        if (near.gap_m == 0.0) {
            const double depth_m = normal_.dot(corner) - lowest_m;
            points_[n_++] = {corner - depth_m * normal_, depth_m};
        } else if (near.gap_m <= pieces_.within_m &&
                   normal_.dot(on_tool - corner) > 0.5 * near.gap_m) {
            points_[n_++] = {on_tool, -normal_.dot(on_tool - corner)};
        }
    }
}

}  // namespace fulcrum
