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

}  // namespace

PairContacts::PairContacts(const PiecesNear& pieces, const HullPair& found) noexcept
    : pieces_(pieces), tool_normal_(pieces.turn * pieces.tool.normal_B) {
    const double least_m = 1.0e-7 * (pieces.object.radius_m + pieces.tool.radius_m);
    bool is_behind = false;
    if (found.gap_m > least_m) {
        normal_ = (found.on_second - found.on_first) / found.gap_m;
        depth_m_ = -found.gap_m;
        const bool looks = pieces.object.normal_B.norm() >= kRound || tool_normal_.norm() >= kRound;
        is_behind = looks && found.gap_m <= pieces.within_m && do_both_look(-normal_, kFacing);
        if (is_behind) {
            normal_ = -normal_;
            depth_m_ = found.gap_m;
        }
    } else {
        find_way_out();
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

double PairContacts::measure_depth_m(const Vector3& normal) const noexcept {
    return -measure_along(pieces_.object_hull, pieces_.tool_hull, pieces_.turn, pieces_.shift,
                          normal);
}

// The way of least translation, where both surfaces look so or end in an edge that does; else of the ways in which they look the least, unless
// that is far longer: then they cross at a border, and the contact is a neighbour's.
void PairContacts::find_way_out() noexcept {
    constexpr double kFarLonger = 4.0;
    HullCorners at = pieces_.corners;
    normal_ = find_convex_depth([&](const Vector3& d) noexcept {
                  return Vector3(pieces_.turn * pieces_.tool_hull.find_support(
                                                    pieces_.turn.transpose() * d, at.second) +
                                 pieces_.shift - pieces_.object_hull.find_support(-d, at.first));
              }).normal;
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

template <class ToObject>
bool PairContacts::find_far_corner(const HullView& hull, double lowest_m, double sign,
                                   const ToObject& to_object, Vector3& corner) const noexcept {
    double farthest2 = pieces_.spread_m * pieces_.spread_m;
    double lowest_seen_m = std::numeric_limits<double>::infinity();
    bool is_found = false;
    const double band_m = pieces_.within_m + std::max(depth_m_, 0.0);
    const Vector3 origin = to_object(Vector3(Vector3::Zero()));
    const double origin_m = sign * normal_.dot(origin);
    // In the hull's own frame: most are not in the band.
    const Vector3 up = sign * Vector3(normal_.dot(to_object(Vector3::UnitX()) - origin),
                                      normal_.dot(to_object(Vector3::UnitY()) - origin),
                                      normal_.dot(to_object(Vector3::UnitZ()) - origin));
    for (const Vector3& point : hull.points) {
        const double height_m = origin_m + up.dot(point);
        if (height_m > lowest_m + band_m) {
            continue;
        }
        const Vector3 place = to_object(point);
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
        for (std::size_t i = 0; i < n_tried_; ++i) {
            nearest2 = std::min(nearest2, (place - tried_[i]).squaredNorm());
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
    const auto to_object = [this](const Vector3& point) noexcept {
        return Vector3(pieces_.turn * point + pieces_.shift);
    };
    const double lowest_m =
        normal_.dot(to_object(pieces_.tool_hull.find_support(pieces_.turn.transpose() * -normal_)));
    const double highest_m = normal_.dot(pieces_.object_hull.find_support(normal_));
    Vector3 corner;
    for (std::size_t i = 0; i < kCorners; ++i) {
        if (!find_far_corner(pieces_.tool_hull, lowest_m, 1.0, to_object, corner)) {
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
    const auto to_object = [](const Vector3& point) noexcept { return point; };
    const double highest_m = normal_.dot(pieces_.object_hull.find_support(normal_));
    const double lowest_m = normal_.dot(
        pieces_.turn * pieces_.tool_hull.find_support(pieces_.turn.transpose() * -normal_) +
        pieces_.shift);
    Vector3 corner;
    for (std::size_t i = 0; i < kCorners; ++i) {
        if (!find_far_corner(pieces_.object_hull, -highest_m, -1.0, to_object, corner)) {
            return;
        }
        tried_[n_tried_++] = corner;
        const HullPair near = find_nearest_in_hull(
            pieces_.tool_hull, pieces_.turn.transpose() * (corner - pieces_.shift),
            pieces_.turn.transpose() * -normal_, pieces_.within_m, pieces_.corners.second);
        if (near.is_far) {
            continue;
        }
        const Vector3 on_tool = pieces_.turn * near.on_first + pieces_.shift;
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
