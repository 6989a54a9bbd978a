#include "haptics/collision/contact_shadow.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fulcrum {
namespace {

using Place = Shadow::Place;

// The cosine below which a face looks across the normal.
constexpr double kAcross = 0.05;
// The sine of the angle below which two segments share a stretch.
constexpr double kAlongside = 0.05;
// A segment's shadow shorter than this, of the segment's length, is a point.
constexpr double kEndOn = 1.0e-3;
// What lies no more than this outside an edge, of the shadow's size, lies on it.
constexpr double kOnEdge = 1.0e-9;

Place operator-(const Place& a, const Place& b) noexcept {
    return {a.x - b.x, a.y - b.y};
}
double cross(const Place& a, const Place& b) noexcept {
    return a.x * b.y - a.y * b.x;
}
double dot(const Place& a, const Place& b) noexcept {
    return a.x * b.x + a.y * b.y;
}
Place between(const Place& a, const Place& b, double part) noexcept {
    return {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)};
}

std::size_t nth(int i) noexcept {
    return static_cast<std::size_t>(i);
}

void make_point(const Place& place, double height, Shadow& shadow) noexcept {
    shadow.corners[0] = place;
    shadow.count = 1;
    shadow.height = height;
    shadow.slope_x = 0.0;
    shadow.slope_y = 0.0;
}

// Heights along a segment's shadow.
void slope_segment(double first, double second, double length_m, double sign,
                   Shadow& shadow) noexcept {
    const Place along = shadow.corners[1] - shadow.corners[0];
    const double square = dot(along, along);
    if (!(square > kEndOn * kEndOn * length_m * length_m)) {
        const bool is_first = sign * first > sign * second;
        make_point(shadow.corners[is_first ? 0 : 1], is_first ? first : second, shadow);
        return;
    }
    const double slope = (second - first) / square;
    shadow.slope_x = slope * along.x;
    shadow.slope_y = slope * along.y;
    shadow.height =
        first - shadow.slope_x * shadow.corners[0].x - shadow.slope_y * shadow.corners[0].y;
}

// A polygon while it is cut. edges[i] goes from corner i to the next.
// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): filled as it grows
struct Cut {
    std::array<Place, kMostShared> corners;
    std::array<std::uint8_t, kMostShared> edges;
    int count = 0;

    void add(const Place& corner, std::uint8_t edge) noexcept {
        if (count < kMostShared) {
            corners[nth(count)] = corner;
            edges[nth(count)] = edge;
            ++count;
        }
    }
};

// How far a place is inside the edge from `a` along `along`, times its length.
double inside_of(const Place& a, const Place& along, const Place& place) noexcept {
    return cross(along, place - a);
}

double part_to_edge(double from, double to) noexcept {
    return from / (from - to);
}

void cut_by_edge(const Cut& cut, const Place& from, const Place& to, std::uint8_t edge,
                 Cut& result) noexcept {
    result.count = 0;
    const Place along = to - from;
    const double least = -kOnEdge * dot(along, along);
    for (int i = 0; i < cut.count; ++i) {
        const int next = i + 1 < cut.count ? i + 1 : 0;
        const double here = inside_of(from, along, cut.corners[nth(i)]);
        const double there = inside_of(from, along, cut.corners[nth(next)]);
        const bool is_in = here >= least;
        if (is_in) {
            result.add(cut.corners[nth(i)], cut.edges[nth(i)]);
        }
        if (is_in != (there >= least)) {
            // Along an edge that nearly coincides the other may be crossed far beyond its ends.
            const double part = std::clamp(part_to_edge(here, there), 0.0, 1.0);
            const Place crossing = between(cut.corners[nth(i)], cut.corners[nth(next)], part);
            // Where the border is left the cutting edge goes on, where it is met the polygon's own.
            result.add(crossing, is_in ? edge : cut.edges[nth(i)]);
        }
    }
}

std::uint16_t pair_of(std::uint8_t before, std::uint8_t after) noexcept {
    return static_cast<std::uint16_t>(before << 8 | after);
}

void add_corner(const Shadow& upper, const Shadow& lower, const Place& place, std::uint16_t feature,
                SharedCorners& shared) noexcept {
    shared.corners[nth(shared.count++)] = {place, upper.height_over(place),
                                           lower.height_over(place), feature};
}

void share_faces(const Shadow& upper, const Shadow& lower, SharedCorners& shared) noexcept {
    Cut one;
    Cut other;
    for (int i = 0; i < upper.count; ++i) {
        one.add(upper.corners[nth(i)], static_cast<std::uint8_t>(i));
    }
    Cut* cut = &one;
    Cut* result = &other;
    for (int i = 0; i < lower.count && cut->count > 0; ++i) {
        const int next = i + 1 < lower.count ? i + 1 : 0;
        cut_by_edge(*cut, lower.corners[nth(i)], lower.corners[nth(next)],
                    static_cast<std::uint8_t>(kMostCorners + i), *result);
        std::swap(cut, result);
    }
    for (int i = 0; i < cut->count; ++i) {
        const int before = i > 0 ? i - 1 : cut->count - 1;
        add_corner(upper, lower, cut->corners[nth(i)],
                   pair_of(cut->edges[nth(before)], cut->edges[nth(i)]), shared);
    }
}

// The part of a segment inside a polygon, as shares of its length.
struct Stretch {
    double from = 0.0;
    double to = 1.0;
    std::uint8_t from_edge = 0;
    std::uint8_t to_edge = 1;

    /// Keeps what is inside of an edge: `here` and `there` are the ends' sides of it.
    void cut(double here, double there, std::uint8_t edge) noexcept {
        if (here < 0.0 && there < 0.0) {
            to = -1.0;
        } else if (here < 0.0 && part_to_edge(here, there) > from) {
            from = part_to_edge(here, there);
            from_edge = edge;
        } else if (there < 0.0 && part_to_edge(here, there) < to) {
            to = part_to_edge(here, there);
            to_edge = edge;
        }
    }
};

void add_stretch(const Shadow& upper, const Shadow& lower, const Shadow& segment,
                 const Stretch& stretch, SharedCorners& shared) noexcept {
    if (stretch.to < stretch.from) {
        return;
    }
    const Place& a = segment.corners[0];
    const Place& b = segment.corners[1];
    add_corner(upper, lower, between(a, b, stretch.from), pair_of(stretch.from_edge, 254), shared);
    if (stretch.to > stretch.from) {
        add_corner(upper, lower, between(a, b, stretch.to), pair_of(stretch.to_edge, 255), shared);
    }
}

void share_segment_and_face(const Shadow& upper, const Shadow& lower, const Shadow& segment,
                            const Shadow& face, SharedCorners& shared) noexcept {
    Stretch stretch;
    for (int i = 0; i < face.count; ++i) {
        const int next = i + 1 < face.count ? i + 1 : 0;
        const Place along = face.corners[nth(next)] - face.corners[nth(i)];
        const double on_edge = kOnEdge * dot(along, along);
        stretch.cut(inside_of(face.corners[nth(i)], along, segment.corners[0]) + on_edge,
                    inside_of(face.corners[nth(i)], along, segment.corners[1]) + on_edge,
                    static_cast<std::uint8_t>(kMostCorners + i));
    }
    add_stretch(upper, lower, segment, stretch, shared);
}

void share_segments(const Shadow& upper, const Shadow& lower, SharedCorners& shared) noexcept {
    const Place& a = upper.corners[0];
    const Place& c = lower.corners[0];
    const Place along = upper.corners[1] - a;
    const Place other = lower.corners[1] - c;
    const double turn = cross(along, other);
    const double lengths = std::sqrt(dot(along, along) * dot(other, other));
    if (std::abs(turn) > kAlongside * lengths) {
        const double part = cross(c - a, other) / turn;
        const double of_other = cross(c - a, along) / turn;
        if (std::min(part, of_other) >= 0.0 && std::max(part, of_other) <= 1.0) {
            add_corner(upper, lower, between(a, upper.corners[1], part), pair_of(0, 0), shared);
        }
        return;
    }
    // Between the lower one's ends, as seen along it.
    const double length = dot(other, other);
    Stretch stretch;
    const double here = dot(a - c, other);
    const double there = dot(upper.corners[1] - c, other);
    stretch.cut(here, there, kMostCorners);
    stretch.cut(length - here, length - there, kMostCorners + 1);
    add_stretch(upper, lower, upper, stretch, shared);
}

// How far a place is outside a shadow: of a face, beyond the edge that it is farthest beyond.
double find_outside(const Shadow& shadow, const Place& place) noexcept {
    if (shadow.count <= 2) {
        const Place& a = shadow.corners[0];
        const Place along = shadow.count == 2 ? shadow.corners[1] - a : Place{0.0, 0.0};
        const double square = dot(along, along);
        const double part =
            square > 0.0 ? std::clamp(dot(place - a, along) / square, 0.0, 1.0) : 0.0;
        const Place away = place - Place{a.x + part * along.x, a.y + part * along.y};
        return std::sqrt(dot(away, away));
    }
    double outside = 0.0;
    for (int i = 0; i < shadow.count; ++i) {
        const Place& a = shadow.corners[nth(i)];
        const Place along = shadow.corners[nth(i + 1 < shadow.count ? i + 1 : 0)] - a;
        const double length = std::sqrt(dot(along, along));
        if (length > 0.0) {
            outside = std::max(outside, -inside_of(a, along, place) / length);
        }
    }
    return outside;
}

}  // namespace

SharedCorner find_nearest_corner(const Shadow& upper, const Shadow& lower) noexcept {
    Place best = upper.corners[0];
    double least = find_outside(lower, best);
    const auto take = [&](const Shadow& from, const Shadow& other) noexcept {
        for (int i = 0; i < from.count; ++i) {
            if (const double here = find_outside(other, from.corners[nth(i)]); here < least) {
                least = here;
                best = from.corners[nth(i)];
            }
        }
    };
    take(upper, lower);
    take(lower, upper);
    return {best, upper.height_over(best), lower.height_over(best), 1};
}

// The world's axis that is farthest from the normal gives u.
ShadowFrame ShadowFrame::across(const Vector3& normal) noexcept {
    int axis = 0;
    normal.cwiseAbs().minCoeff(&axis);
    const Vector3 u = compute_direction(Vector3(Vector3::Unit(axis).cross(normal)));
    return {u, normal.cross(u), normal};
}

void make_shadow(const SupportFeature& feature, const Matrix3& turn_WB, const Vector3& place,
                 const ShadowFrame& frame, double sign, Shadow& shadow) noexcept {
    const Vector3 u = turn_WB.transpose() * frame.u;
    const Vector3 v = turn_WB.transpose() * frame.v;
    const Vector3 n = turn_WB.transpose() * frame.n;
    const double x = frame.u.dot(place);
    const double y = frame.v.dot(place);
    const double z = frame.n.dot(place);
    const bool is_face = feature.count > 2;
    for (int i = 0; i < feature.count; ++i) {
        // Faces run counter-clockwise from outside: the upper one's the other way round.
        const Vector3& corner =
            feature.corners_B[nth(is_face && sign < 0.0 ? feature.count - 1 - i : i)];
        shadow.corners[nth(i)] = {x + u.dot(corner), y + v.dot(corner)};
    }
    shadow.count = feature.count;
    const double height = z + n.dot(feature.corners_B[0]);
    if (feature.count == 1) {
        return make_point(shadow.corners[0], height, shadow);
    }
    if (feature.count == 2) {
        const double length_m = (feature.corners_B[1] - feature.corners_B[0]).norm();
        return slope_segment(height, z + n.dot(feature.corners_B[1]), length_m, sign, shadow);
    }
    const double facing = n.dot(feature.normal_B);
    if (std::abs(facing) < kAcross) {
        const auto begin = feature.corners_B.begin();
        const Vector3 farthest = *std::max_element(
            begin, begin + feature.count,
            [&](const Vector3& a, const Vector3& b) { return sign * n.dot(a) < sign * n.dot(b); });
        return make_point({x + u.dot(farthest), y + v.dot(farthest)}, z + n.dot(farthest), shadow);
    }
    shadow.slope_x = -u.dot(feature.normal_B) / facing;
    shadow.slope_y = -v.dot(feature.normal_B) / facing;
    const Vector3& first = feature.corners_B[0];
    shadow.height =
        height - shadow.slope_x * (x + u.dot(first)) - shadow.slope_y * (y + v.dot(first));
}

void find_shared_corners(const Shadow& upper, const Shadow& lower, SharedCorners& shared) noexcept {
    shared.count = 0;
    if (upper.count == 1 || lower.count == 1) {
        const Shadow& point = upper.count == 1 ? upper : lower;
        add_corner(upper, lower, point.corners[0], 0, shared);
    } else if (upper.count == 2 && lower.count == 2) {
        share_segments(upper, lower, shared);
    } else if (upper.count == 2) {
        share_segment_and_face(upper, lower, upper, lower, shared);
    } else if (lower.count == 2) {
        share_segment_and_face(upper, lower, lower, upper, shared);
    } else {
        share_faces(upper, lower, shared);
    }
}

}  // namespace fulcrum
