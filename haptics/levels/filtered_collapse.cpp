#include "haptics/levels/filtered_collapse.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace fulcrum {

namespace {

void add_once(std::vector<std::int32_t>& list, std::int32_t item) {
    if (std::ranges::find(list, item) == list.end()) {
        list.push_back(item);
    }
}

// With one corner, or two, at another place.
PieceTriangle move_corners(const LevelSurface& surface, std::int32_t triangle, std::int32_t kept,
                           std::int32_t gone, const Vector3& place) {
    PieceTriangle places = surface.places(triangle);
    for (std::size_t i = 0; i < 3; ++i) {
        const std::int32_t corner = surface.corners(triangle)[i];
        if (corner == kept || corner == gone) {
            places[i] = place;
        }
    }
    return places;
}

bool has(const TriangleCorners& triangle, std::int32_t corner) {
    return std::ranges::find(triangle, corner) != triangle.end();
}

}  // namespace

bool FilteredCollapse::Waiting::operator>(const Waiting& other) const noexcept {
    return std::tie(length_m, low, high, version) >
           std::tie(other.length_m, other.low, other.high, other.version);
}

FilteredCollapse::FilteredCollapse(LevelSurface& surface, double slack_m)
    : surface_(surface),
      slack_m_(slack_m),
      n_first_(surface.n_pieces()),
      quadrics_(static_cast<std::size_t>(surface.n_corners())),
      versions_(static_cast<std::size_t>(surface.n_corners()), 0) {
    add_quadrics();
    for (std::int32_t corner = 0; corner < surface_.n_corners(); ++corner) {
        surface_.find_ring(corner, ring_);
        for (const std::int32_t other : ring_) {
            if (corner < other) {
                wait(corner, other);
            }
        }
    }
}

void FilteredCollapse::add_quadrics() {
    for (std::int32_t corner = 0; corner < surface_.n_corners(); ++corner) {
        Quadric& quadric = quadrics_[static_cast<std::size_t>(corner)];
        for (const std::int32_t triangle : surface_.triangles_at(corner)) {
            const PieceTriangle places = surface_.places(triangle);
            const PiecePlane plane = PiecePlane::of(places);
            const double area_m2 =
                0.5 * (places[1] - places[0]).cross(places[2] - places[0]).norm();
            quadric.a += area_m2 * plane.normal * plane.normal.transpose();
            quadric.b += area_m2 * plane.offset_m * plane.normal;
        }
    }
}

std::int32_t FilteredCollapse::version_of(std::int32_t one, std::int32_t other) const noexcept {
    return versions_[static_cast<std::size_t>(one)] + versions_[static_cast<std::size_t>(other)];
}

void FilteredCollapse::wait(std::int32_t one, std::int32_t other) {
    waiting_.push({(surface_.place(one) - surface_.place(other)).norm(), std::min(one, other),
                   std::max(one, other), version_of(one, other)});
}

bool FilteredCollapse::go_on_to(std::int32_t n_pieces, LoadPulse& pulse) {
    while (surface_.n_pieces() > n_pieces) {
        if (waiting_.empty() ||
            !pulse.goes_on(kSimplifying * (1.0 - surface_.n_pieces() / n_first_))) {
            return false;
        }
        const Waiting edge = waiting_.top();
        waiting_.pop();
        if (edge.version != version_of(edge.low, edge.high) || !end(edge.low, edge.high)) {
            continue;
        }
        longest_m_ = std::max(longest_m_, edge.length_m);
        ++n_ended_;
        join_around(edge.low);
    }
    return true;
}

bool FilteredCollapse::end(std::int32_t kept, std::int32_t gone) {
    if (!surface_.may_end(kept, gone)) {
        return false;
    }
    collect_star(kept, gone);
    const double slack_m =
        slack_m_ + kRelaxed * (surface_.place(kept) - surface_.place(gone)).norm();
    const Vector3 quadric_point = find_quadric_point(kept, gone);
    const Vector3 filtered = filter(kept, gone, quadric_point);
    const std::array<Vector3, 6> tries{filtered,
                                       0.5 * (filtered + quadric_point),
                                       0.25 * filtered + 0.75 * quadric_point,
                                       quadric_point,
                                       surface_.place(kept),
                                       surface_.place(gone)};
    for (const Vector3& place : tries) {
        if (!may_be_at(kept, gone, place, slack_m)) {
            continue;
        }
        Quadric& quadric = quadrics_[static_cast<std::size_t>(kept)];
        quadric.a += quadrics_[static_cast<std::size_t>(gone)].a;
        quadric.b += quadrics_[static_cast<std::size_t>(gone)].b;
        surface_.end_edge(kept, gone, place);
        ++versions_[static_cast<std::size_t>(kept)];
        ++versions_[static_cast<std::size_t>(gone)];
        surface_.find_ring(kept, ring_);
        for (const std::int32_t corner : ring_) {
            ++versions_[static_cast<std::size_t>(corner)];
        }
        for (const std::int32_t corner : ring_) {
            surface_.find_ring(corner, outer_);
            for (const std::int32_t other : outer_) {
                const bool is_twice = std::ranges::find(ring_, other) != ring_.end();
                if (!is_twice || corner < other) {
                    wait(corner, other);
                }
            }
        }
        return true;
    }
    return false;
}

void FilteredCollapse::collect_star(std::int32_t kept, std::int32_t gone) {
    star_.clear();
    pieces_.clear();
    for (const std::int32_t corner : {kept, gone}) {
        for (const std::int32_t triangle : surface_.triangles_at(corner)) {
            const TriangleCorners& at = surface_.corners(triangle);
            add_once(pieces_, surface_.piece_of(triangle));
            if (!has(at, kept) || !has(at, gone)) {
                star_.push_back(triangle);
            }
        }
    }
}

// The quadric's least, held to the middle where it knows no better: (A + m I) x = b + m middle.
Vector3 FilteredCollapse::find_quadric_point(std::int32_t kept, std::int32_t gone) const {
    constexpr double kHold = 1.0e-3;  // of the quadric's size
    const Quadric& one = quadrics_[static_cast<std::size_t>(kept)];
    const Quadric& other = quadrics_[static_cast<std::size_t>(gone)];
    const Vector3 middle = 0.5 * (surface_.place(kept) + surface_.place(gone));
    Matrix3 a = one.a + other.a;
    const double hold = kHold * a.trace();
    if (!(hold > 0.0)) {
        return middle;
    }
    // About the middle, so that no digits are lost.
    const Vector3 b = one.b + other.b - a * middle;
    a += hold * Matrix3::Identity();
    return middle + a.inverse() * b;
}

Vector3 FilteredCollapse::find_umbrella(std::int32_t corner) {
    surface_.find_ring(corner, outer_);
    Vector3 mean = Vector3::Zero();
    for (const std::int32_t other : outer_) {
        mean += surface_.place(other) / static_cast<double>(outer_.size());
    }
    return mean - surface_.place(corner);
}

Vector3 FilteredCollapse::filter(std::int32_t kept, std::int32_t gone, const Vector3& point) {
    constexpr double kPart = 0.5;
    ring_.clear();
    for (const std::int32_t triangle : star_) {
        for (const std::int32_t corner : surface_.corners(triangle)) {
            if (corner != kept && corner != gone) {
                add_once(ring_, corner);
            }
        }
    }
    const auto n = static_cast<double>(ring_.size());
    Vector3 umbrella = -point;
    Vector3 around = Vector3::Zero();
    for (const std::int32_t corner : ring_) {
        umbrella += surface_.place(corner) / n;
        around += find_umbrella(corner) / n;
    }
    return point + kPart * (umbrella - around);
}

bool FilteredCollapse::turns_over(std::int32_t kept, std::int32_t gone,
                                  const Vector3& place) const {
    constexpr double kLeastCosine = 0.3;
    constexpr double kThinnest = 0.02;  // height over longest edge
    return std::ranges::any_of(star_, [&](std::int32_t triangle) {
        const PieceTriangle before = surface_.places(triangle);
        const PieceTriangle after = move_corners(surface_, triangle, kept, gone, place);
        const Vector3 doubled = (after[1] - after[0]).cross(after[2] - after[0]);
        const double longest2 =
            std::max({(after[1] - after[0]).squaredNorm(), (after[2] - after[0]).squaredNorm(),
                      (after[2] - after[1]).squaredNorm()});
        const Vector3 old_doubled = (before[1] - before[0]).cross(before[2] - before[0]);
        const double size = doubled.norm();
        // A sliver may stay one, but none may become one.
        const bool is_sliver = size < kThinnest * longest2 && size < old_doubled.norm();
        return is_sliver || doubled.dot(old_doubled) < kLeastCosine * size * old_doubled.norm();
    });
}

bool FilteredCollapse::stays_convex(std::int32_t piece, std::int32_t kept, std::int32_t gone,
                                    const Vector3& place, double slack_m) {
    shape_.clear();
    moved_planes_.clear();
    bool has_place = false;
    for (const std::int32_t triangle : surface_.triangles_of(piece)) {
        const TriangleCorners& at = surface_.corners(triangle);
        const bool has_kept = has(at, kept);
        const bool has_gone = has(at, gone);
        if (has_kept && has_gone) {
            continue;
        }
        const PieceTriangle places = move_corners(surface_, triangle, kept, gone, place);
        shape_.add_triangle(places);
        if (has_kept || has_gone) {
            has_place = true;
            moved_planes_.push_back(shape_.planes.back());
        }
        // Corners come as often as triangles have them: no harm.
        shape_.corners.insert(shape_.corners.end(), places.begin(), places.end());
    }
    if (shape_.planes.empty()) {
        return true;
    }
    if (has_place && !shape_.is_behind(place, slack_m)) {
        return false;
    }
    for (const PiecePlane& plane : moved_planes_) {
        if (!shape_.is_before(plane, slack_m)) {
            return false;
        }
    }
    if (shape_.planes.size() == 1 || shape_.is_flat(slack_m)) {
        return true;
    }
    const InnerHull inner(shape_, slack_m);
    return std::ranges::none_of(star_, [&](std::int32_t triangle) {
        return surface_.piece_of(triangle) != piece &&
               inner.is_entered_by(move_corners(surface_, triangle, kept, gone, place));
    });
}

bool FilteredCollapse::may_be_at(std::int32_t kept, std::int32_t gone, const Vector3& place,
                                 double slack_m) {
    return !turns_over(kept, gone, place) && std::ranges::all_of(pieces_, [&](std::int32_t piece) {
        return stays_convex(piece, kept, gone, place, slack_m);
    });
}

void FilteredCollapse::join_around(std::int32_t corner) {
    surface_.find_ring(corner, ring_);
    ring_.push_back(corner);
    for (const std::int32_t one : ring_) {
        surface_.find_ring(one, outer_);
        for (const std::int32_t other : outer_) {
            join_across(one, other);
        }
    }
}

// The pieces on both sides of an edge, unless it is concave.
void FilteredCollapse::join_across(std::int32_t one, std::int32_t other) {
    std::array<std::int32_t, 2> sides{};
    std::size_t n_sides = 0;
    for (const std::int32_t triangle : surface_.triangles_at(one)) {
        if (has(surface_.corners(triangle), other)) {
            if (n_sides == 2) {
                return;
            }
            sides[n_sides++] = triangle;
        }
    }
    if (n_sides != 2) {
        return;
    }
    const std::int32_t piece = surface_.piece_of(sides[0]);
    const std::int32_t beyond = surface_.piece_of(sides[1]);
    const PiecePlane plane = PiecePlane::of(surface_.places(sides[0]));
    const auto is_behind = [&](const Vector3& place) { return plane.height_m(place) <= slack_m(); };
    if (piece != beyond && std::ranges::all_of(surface_.places(sides[1]), is_behind) &&
        may_join(piece, beyond)) {
        surface_.join_pieces(piece, beyond);
    }
}

bool FilteredCollapse::may_join(std::int32_t one, std::int32_t other) {
    constexpr double kFilled = 1.01;  // of the area
    surface_.describe(one, shape_);
    surface_.describe(other, other_shape_);
    const double slack = slack_m();
    const auto is_behind_all = [slack](const PieceShape& planes, const PieceShape& corners) {
        return std::ranges::all_of(corners.corners, [&](const Vector3& corner) {
            return planes.is_behind(corner, slack);
        });
    };
    if (!is_behind_all(shape_, other_shape_) || !is_behind_all(other_shape_, shape_)) {
        return false;
    }
    shape_.corners.insert(shape_.corners.end(), other_shape_.corners.begin(),
                          other_shape_.corners.end());
    shape_.planes.insert(shape_.planes.end(), other_shape_.planes.begin(),
                         other_shape_.planes.end());
    shape_.area_m2 = kFilled * (shape_.area_m2 + other_shape_.area_m2);
    if (shape_.is_flat(slack)) {
        return shape_.fills_its_polygon();
    }
    return !surface_.is_entered(shape_, one, other, slack);
}

}  // namespace fulcrum
