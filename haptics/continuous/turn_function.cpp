#include "haptics/continuous/turn_function.h"

#include <cmath>

namespace fulcrum {
namespace {

IntervalVector box_of(const Vector3& v) noexcept {
    return {Interval::at(v.x()), Interval::at(v.y()), Interval::at(v.z())};
}

IntervalVector subtract(const IntervalVector& a, const IntervalVector& b) noexcept {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

IntervalVector subtract(const Vector3& a, const Vector3& b) noexcept {
    return subtract(box_of(a), box_of(b));
}

Interval multiply(const IntervalVector& a, const IntervalVector& b) noexcept {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

IntervalVector cross(const IntervalVector& a, const IntervalVector& b) noexcept {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// An upper bound of the length.
double find_most(const IntervalVector& v) noexcept {
    const Interval square =
        Interval::at(v[0].greatest_magnitude()) * Interval::at(v[0].greatest_magnitude()) +
        Interval::at(v[1].greatest_magnitude()) * Interval::at(v[1].greatest_magnitude()) +
        Interval::at(v[2].greatest_magnitude()) * Interval::at(v[2].greatest_magnitude());
    return interval_details::round_up(std::sqrt(square.upper));
}

// v(t) = a + cos b + sin c.
struct TurningVector {
    IntervalVector a, b, c;
};

// Of a vector that the body carries along, from what it is at the start.
TurningVector carry(const InBetweenMotion& motion, const IntervalVector& start) noexcept {
    const IntervalVector axis = box_of(motion.axis_A());
    const Interval along = multiply(axis, start);
    const IntervalVector a{axis[0] * along, axis[1] * along, axis[2] * along};
    return {a, subtract(start, a), cross(axis, start)};
}

// Between two corners at the start.
IntervalVector find_edge(const PointPath& from, const PointPath& to) noexcept {
    const IntervalVector axial = subtract(to.a, from.a);
    const IntervalVector round = subtract(to.b, from.b);
    return {axial[0] + round[0], axial[1] + round[1], axial[2] + round[2]};
}

IntervalVector find_start(const PointPath& corner, const Vector3& from) noexcept {
    const IntervalVector axial = subtract(corner.a, from);
    const IntervalVector round = box_of(corner.b);
    return {axial[0] + round[0], axial[1] + round[1], axial[2] + round[2]};
}

// What the paths' rounding makes of f.
void widen_by(double error, TurnFunction& f) noexcept {
    f.constant = f.constant + Interval{-error, error};
}

TurnFunction make_of_moving_corner(const InBetweenMotion& motion, const Triangle& fixed,
                                   const PointPath& corner) noexcept {
    const IntervalVector normal = cross(subtract(fixed[1], fixed[0]), subtract(fixed[2], fixed[0]));
    TurnFunction f;
    f.constant = multiply(normal, subtract(corner.a, fixed[0]));
    f.linear = multiply(normal, box_of(motion.travel_A()));
    f.cosine = multiply(normal, box_of(corner.b));
    f.sine = multiply(normal, box_of(corner.c));
    f.per_m = find_most(normal);
    return f;
}

TurnFunction make_of_moving_face(const InBetweenMotion& motion, const Vector3& corner,
                                 const MovingTriangle& moving, const SweepBounds& bounds) noexcept {
    const IntervalVector first = find_edge(moving.corners[0], moving.corners[1]);
    const IntervalVector second = find_edge(moving.corners[0], moving.corners[2]);
    const IntervalVector normal = cross(first, second);
    const TurningVector n = carry(motion, normal);
    const IntervalVector way = box_of(-motion.travel_A());
    const IntervalVector from_pivot = subtract(corner, motion.pivot_start_A());
    TurnFunction f;
    f.constant = multiply(n.a, from_pivot) -
                 multiply(normal, find_start(moving.corners[0], motion.pivot_start_A()));
    f.linear = multiply(n.a, way);
    f.cosine = multiply(n.b, from_pivot);
    f.cosine_linear = multiply(n.b, way);
    f.sine = multiply(n.c, from_pivot);
    f.sine_linear = multiply(n.c, way);
    f.per_m = find_most(normal);
    // Edges err by slacks, so the normal by their products.
    const double edges_m = find_most(first) + find_most(second);
    widen_by(16.0 * edges_m * (edges_m + bounds.length_m) * bounds.slack_m, f);
    return f;
}

TurnFunction make_of_edges(const InBetweenMotion& motion, const Vector3& a, const Vector3& b,
                           const PointPath& p, const PointPath& q,
                           const SweepBounds& bounds) noexcept {
    const IntervalVector held = subtract(b, a);
    const IntervalVector edge = find_edge(p, q);
    const TurningVector m = carry(motion, edge);
    const TurningVector moment = carry(motion, cross(edge, find_start(p, motion.pivot_start_A())));
    const IntervalVector start = cross(subtract(motion.pivot_start_A(), a), held);
    const IntervalVector way = cross(box_of(motion.travel_A()), held);
    TurnFunction f;
    f.constant = multiply(m.a, start) + multiply(held, moment.a);
    f.linear = multiply(m.a, way);
    f.cosine = multiply(m.b, start) + multiply(held, moment.b);
    f.cosine_linear = multiply(m.b, way);
    f.sine = multiply(m.c, start) + multiply(held, moment.c);
    f.sine_linear = multiply(m.c, way);
    const double held_m = find_most(held);
    const double edge_m = find_most(edge);
    f.per_m = interval_details::round_up(held_m * edge_m);
    widen_by(16.0 * held_m * (edge_m + bounds.length_m) * bounds.slack_m, f);
    return f;
}

}  // namespace

TurnFunction make_turn_function(const InBetweenMotion& motion, const Triangle& fixed,
                                const MovingTriangle& moving, FeaturePair pair,
                                std::size_t fixed_feature, std::size_t moving_feature,
                                const SweepBounds& bounds) noexcept {
    TurnFunction f;
    if (pair == FeaturePair::face_vertex) {
        f = make_of_moving_corner(motion, fixed, moving.corners[moving_feature]);
    } else if (pair == FeaturePair::vertex_face) {
        f = make_of_moving_face(motion, fixed[fixed_feature], moving, bounds);
    } else {
        f = make_of_edges(motion, fixed[fixed_feature], fixed[(fixed_feature + 1) % 3],
                          moving.corners[moving_feature], moving.corners[(moving_feature + 1) % 3],
                          bounds);
    }
    f.angle_rad = motion.angle_rad();
    return f;
}

}  // namespace fulcrum
