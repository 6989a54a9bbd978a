#include "haptics/collision/contact_axis.h"

#include "haptics/collision/convex_depth.h"
#include "haptics/collision/shape_gap.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fulcrum {
namespace {

using ShapeKind = ContactShape::Kind;

// `which` of a product of two boxes' edges: this + 2 (3 i + j) + (1 where it looks the other way).
constexpr std::int32_t kFirstEdge = 1000;
// The square of the sine below which two edges are parallel, and their product no direction.
constexpr double kParallel = 1.0e-8;
// Cores nearer than this, of the size, are sought as if they met: the direction between nearly equal points is noise.
constexpr double kNearlyMeet = 1.0e-6;

double find_smaller_size(const PlacedShape& first, const PlacedShape& second) noexcept {
    return std::min(first.shape->bounding_radius_m, second.shape->bounding_radius_m);
}

Vector3 or_upwards(const Vector3& v) noexcept {
    return v.squaredNorm() > 0.0 ? v : Vector3(Vector3::UnitY());
}

// ---- Two boxes. In the first's frame: t from the second's centre to the first's, f_j = R.col(j) the second's axes.

struct BoxPair {
    Matrix3 R;
    Matrix3 size_R;  // |R_ij|
    Vector3 t;       // along the first's axes
    Vector3 u;       // along the second's
    Vector3 a;
    Vector3 b;
    Vector3 reach_a;  // of both boxes along the first's axes
    Vector3 reach_b;  // along the second's
};

BoxPair make_box_pair(const PlacedShape& first, const PlacedShape& second) noexcept {
    BoxPair pair;
    const Vector3 apart = first.place - second.place;
    pair.R = first.turn_WB.transpose() * second.turn_WB;
    pair.size_R = pair.R.cwiseAbs();
    pair.t = first.turn_WB.transpose() * apart;
    pair.u = second.turn_WB.transpose() * apart;
    pair.a = first.shape->core.half_m;
    pair.b = second.shape->core.half_m;
    pair.reach_a = pair.a + pair.size_R * pair.b;
    pair.reach_b = pair.b + pair.size_R.transpose() * pair.a;
    return pair;
}

struct EdgeAxis {
    double length = 0.0;  // of e_i x f_j
    double along = 0.0;   // t . (e_i x f_j)
    double reach = 0.0;
};

EdgeAxis find_edge_axis(const BoxPair& pair, int i, int j) noexcept {
    const int i1 = (i + 1) % 3;
    const int i2 = (i + 2) % 3;
    const int j1 = (j + 1) % 3;
    const int j2 = (j + 2) % 3;
    const double square = 1.0 - pair.R(i, j) * pair.R(i, j);
    if (!(square > kParallel)) {
        return {};
    }
    return {.length = std::sqrt(square),
            .along = pair.t[i2] * pair.R(i1, j) - pair.t[i1] * pair.R(i2, j),
            .reach = pair.a[i1] * pair.size_R(i2, j) + pair.a[i2] * pair.size_R(i1, j) +
                     pair.b[j1] * pair.size_R(i, j2) + pair.b[j2] * pair.size_R(i, j1)};
}

constexpr double kNoGap = -std::numeric_limits<double>::infinity();

// The gap along one candidate, as `which` names it.
double find_gap_along(const BoxPair& pair, std::int32_t which) noexcept {
    if (which >= kFirstEdge) {
        const int edges = (which - kFirstEdge) / 2;
        const EdgeAxis axis = find_edge_axis(pair, edges / 3, edges % 3);
        const double sign = (which - kFirstEdge) % 2 == 0 ? 1.0 : -1.0;
        return axis.length > 0.0 ? (sign * axis.along - axis.reach) / axis.length : kNoGap;
    }
    const std::int32_t face = which > 0 ? which - 1 : -1 - which;
    if (which == 0 || face > 5) {
        return kNoGap;
    }
    // The first's face looks at the second, against the normal.
    const double sign = (face % 2 == 0) == (which < 0) ? 1.0 : -1.0;
    const int axis = face / 2;
    return which > 0 ? sign * pair.t[axis] - pair.reach_a[axis]
                     : sign * pair.u[axis] - pair.reach_b[axis];
}

Vector3 find_box_normal(const PlacedShape& first, const PlacedShape& second,
                        std::int32_t which) noexcept {
    if (which >= kFirstEdge) {
        const int edges = (which - kFirstEdge) / 2;
        const Vector3 normal = first.turn_WB.col(edges / 3).cross(second.turn_WB.col(edges % 3));
        return (which % 2 == 0 ? 1.0 : -1.0) * compute_direction(normal);
    }
    return which > 0 ? Vector3(first.turn_WB * -find_face_normal(*first.shape, which - 1))
                     : Vector3(second.turn_WB * find_face_normal(*second.shape, -1 - which));
}

struct BoxChoice {
    double gap_m = kNoGap;
    std::int32_t which = 0;

    void take(double gap, std::int32_t other, double better_m) noexcept {
        if (gap > gap_m + better_m) {
            gap_m = gap;
            which = other;
        }
    }
};

void try_faces(const BoxPair& pair, double prefer_m, BoxChoice& best) noexcept {
    BoxChoice of_second;
    for (int i = 0; i < 3; ++i) {
        best.take(std::abs(pair.t[i]) - pair.reach_a[i], 1 + 2 * i + (pair.t[i] < 0.0 ? 0 : 1),
                  0.0);
        of_second.take(std::abs(pair.u[i]) - pair.reach_b[i],
                       -1 - 2 * i - (pair.u[i] < 0.0 ? 1 : 0), 0.0);
    }
    best.take(of_second.gap_m, of_second.which, prefer_m);
}

void try_edges(const BoxPair& pair, double prefer_m, BoxChoice& best) noexcept {
    BoxChoice of_edges;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            const EdgeAxis axis = find_edge_axis(pair, i, j);
            const double most = of_edges.which == 0 ? best.gap_m : of_edges.gap_m;
            if (std::abs(axis.along) - axis.reach > most * axis.length && axis.length > 0.0) {
                of_edges.gap_m = (std::abs(axis.along) - axis.reach) / axis.length;
                of_edges.which = kFirstEdge + 2 * (3 * i + j) + (axis.along < 0.0 ? 1 : 0);
            }
        }
    }
    best.take(of_edges.gap_m, of_edges.which, prefer_m);
}

ContactAxis find_box_axis(const PlacedShape& first, const PlacedShape& second, double margin_m,
                          std::int32_t last) noexcept {
    const BoxPair pair = make_box_pair(first, second);
    const double prefer_m = kPrefer * find_smaller_size(first, second);
    const double last_m = find_gap_along(pair, last);
    BoxChoice best{last_m, last};
    if (!(last_m > margin_m)) {
        best = {};
        try_faces(pair, prefer_m, best);
        if (!(best.gap_m > margin_m)) {
            try_edges(pair, prefer_m, best);
        }
        if (last_m >= best.gap_m - prefer_m) {
            best = {last_m, last};
        }
    }
    return {find_box_normal(first, second, best.which), best.gap_m, best.which};
}

// ---- A sphere's centre has a distance in closed form.

bool has_closed_form(ShapeKind kind) noexcept {
    return kind == ShapeKind::sphere || kind == ShapeKind::box || kind == ShapeKind::capsule ||
           kind == ShapeKind::cylinder;
}

Gap find_point_gap(const ContactShape& shape, const Vector3& p_B) noexcept {
    const Vector3& half_m = shape.core.half_m;
    switch (shape.kind) {
        case ShapeKind::box:
            return find_gap(BoxShape{half_m}, p_B);
        case ShapeKind::capsule:
            return find_gap(CapsuleShape{shape.core.radius_m, half_m.y()}, p_B);
        case ShapeKind::cylinder:
            return find_gap(CylinderShape{half_m.x(), half_m.y()}, p_B);
        default:
            return find_gap(SphereShape{shape.core.radius_m}, p_B);
    }
}

ContactAxis find_sphere_axis(const PlacedShape& sphere, const PlacedShape& other) noexcept {
    const Vector3 p_B = other.turn_WB.transpose() * (sphere.place - other.place);
    const Gap gap = find_point_gap(*other.shape, p_B);
    return {other.turn_WB * gap.normal_B, gap.gap_m - sphere.shape->core.radius_m, 0};
}

ContactAxis find_half_space_axis(const PlacedShape& body, const PlacedShape& ground) noexcept {
    const Vector3 up = ground.turn_WB.col(1);
    const Vector3 lowest = body.find_support(-up);
    return {up, up.dot(lowest - ground.place) - body.shape->core.radius_m, -1};
}

// ---- Any two.

// Two segments that cross: along both their products there is no overlap of the cores.
bool find_crossing_axis(const PlacedShape& first, const PlacedShape& second,
                        Vector3& normal) noexcept {
    if (first.shape->kind != ShapeKind::capsule || second.shape->kind != ShapeKind::capsule) {
        return false;
    }
    const Vector3 across = first.turn_WB.col(1).cross(second.turn_WB.col(1));
    const Vector3 apart = first.place - second.place;
    const bool is_parallel = !(across.squaredNorm() > kParallel);
    normal = compute_direction(is_parallel ? Vector3(second.turn_WB.col(0)) : across);
    normal *= apart.dot(normal) < 0.0 ? -1.0 : 1.0;
    return true;
}

class AxisSearch {
  public:
    AxisSearch(const PlacedShape& first, const PlacedShape& second) noexcept
        : first_(first), second_(second) {}

    /// Of the bodies, along a unit vector.
    [[nodiscard]] double find_gap_along(const Vector3& normal) const noexcept {
        return normal.dot(find_support(Vector3(-normal))) - radii_m();
    }
    [[nodiscard]] ContactAxis find_free() const noexcept {
        const auto support = [this](const Vector3& d) noexcept { return find_support(d); };
        ConvexGap found = find_convex_gap(or_upwards(first_.place - second_.place), support);
        if (!(found.gap_m > kNearlyMeet * find_smaller_size(first_, second_))) {
            Vector3 crossing;
            if (find_crossing_axis(first_, second_, crossing)) {
                found = {crossing, crossing.dot(find_support(Vector3(-crossing)))};
            } else {
                found = find_convex_depth(support);
            }
        }
        return {found.normal, found.gap_m - radii_m(), 0};
    }
    /// The normal that `which` names; zero where it names none.
    [[nodiscard]] Vector3 find_normal(std::int32_t which) const noexcept {
        return which > 0 ? Vector3(first_.turn_WB * -find_face_normal(*first_.shape, which - 1))
                         : Vector3(second_.turn_WB * find_face_normal(*second_.shape, -1 - which));
    }
    /// Takes a face's normal instead where it is nearly as good.
    void prefer_face(std::int32_t which, double least_m, ContactAxis& axis) const noexcept {
        const Vector3 normal = find_normal(which);
        const double gap_m = find_gap_along(normal);
        if (normal.squaredNorm() > 0.0 && gap_m >= least_m) {
            axis = {normal, gap_m, which};
        }
    }
    void prefer_faces(std::int32_t last, ContactAxis& axis) const noexcept {
        const double prefer_m = kPrefer * find_smaller_size(first_, second_);
        const double least_m = axis.gap_m - prefer_m;
        const Vector3 normal = axis.normal_W;
        const AlignedFace of_second =
            find_aligned_face(*second_.shape, second_.turn_WB.transpose() * normal);
        const AlignedFace of_first =
            find_aligned_face(*first_.shape, first_.turn_WB.transpose() * -normal);
        prefer_face(-1 - of_second.face, least_m, axis);
        prefer_face(1 + of_first.face, least_m, axis);
        prefer_face(last, least_m - prefer_m, axis);
    }

  private:
    [[nodiscard]] Vector3 find_support(const Vector3& direction) const noexcept {
        return first_.find_support(direction) - second_.find_support(Vector3(-direction));
    }
    [[nodiscard]] double radii_m() const noexcept {
        return first_.shape->core.radius_m + second_.shape->core.radius_m;
    }

    const PlacedShape& first_;
    const PlacedShape& second_;
};

ContactAxis find_any_axis(const PlacedShape& first, const PlacedShape& second, double margin_m,
                          std::int32_t last) noexcept {
    const AxisSearch search(first, second);
    if (const Vector3 normal = search.find_normal(last); normal.squaredNorm() > 0.0) {
        if (const double gap_m = search.find_gap_along(normal); gap_m > margin_m) {
            return {normal, gap_m, last};
        }
    }
    ContactAxis axis = search.find_free();
    if (!(axis.gap_m > margin_m)) {
        search.prefer_faces(last, axis);
    }
    return axis;
}

ContactAxis find_turned(const ContactAxis& axis) noexcept {
    return {Vector3(-axis.normal_W), axis.gap_m, -axis.which};
}

}  // namespace

ContactAxis find_contact_axis(const PlacedShape& first, const PlacedShape& second, double margin_m,
                              std::int32_t last) noexcept {
    const ShapeKind a = first.shape->kind;
    const ShapeKind b = second.shape->kind;
    if (a == ShapeKind::half_space && b == ShapeKind::half_space) {
        return {.gap_m = std::numeric_limits<double>::infinity()};
    }
    if (b == ShapeKind::half_space) {
        return find_half_space_axis(first, second);
    }
    if (a == ShapeKind::half_space) {
        return find_turned(find_half_space_axis(second, first));
    }
    if (a == ShapeKind::box && b == ShapeKind::box) {
        return find_box_axis(first, second, margin_m, last);
    }
    if (a == ShapeKind::sphere && has_closed_form(b)) {
        return find_sphere_axis(first, second);
    }
    if (b == ShapeKind::sphere && has_closed_form(a)) {
        return find_turned(find_sphere_axis(second, first));
    }
    return find_any_axis(first, second, margin_m, last);
}

}  // namespace fulcrum
