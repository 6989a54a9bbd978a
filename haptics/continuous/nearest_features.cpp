#include "haptics/continuous/nearest_features.h"

#include "haptics/math/orientation.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

// The square of the sine of an angle: a triangle or a pair of edges below it says nothing about its plane.
constexpr double kFlatSquare = 1.0e-24;

double divide_within(double over, double under) noexcept {
    return under > 0.0 ? std::clamp(over / under, 0.0, 1.0) : 0.0;
}

Vector3 find_on_segment(const Vector3& point, const Vector3& a, const Vector3& b) noexcept {
    const Vector3 along = b - a;
    return a + divide_within(along.dot(point - a), along.squaredNorm()) * along;
}

Vector3 find_on_border(const Vector3& point, const Triangle& t) noexcept {
    Vector3 best = find_on_segment(point, t[0], t[1]);
    for (const Vector3& other :
         {find_on_segment(point, t[1], t[2]), find_on_segment(point, t[2], t[0])}) {
        if ((other - point).squaredNorm() < (best - point).squaredNorm()) {
            best = other;
        }
    }
    return best;
}

// By the signs of the three areas that the point's foot makes with the edges.
Vector3 find_on_triangle(const Vector3& point, const Triangle& t) noexcept {
    const Vector3 ab = t[1] - t[0];
    const Vector3 ac = t[2] - t[0];
    const Vector3 normal = ab.cross(ac);
    const double square = normal.squaredNorm();
    if (!(square > kFlatSquare * ab.squaredNorm() * ac.squaredNorm())) {
        return find_on_border(point, t);
    }
    const Vector3 ap = point - t[0];
    const double w = normal.dot(ab.cross(ap));
    const double v = normal.dot(ap.cross(ac));
    if (v >= 0.0 && w >= 0.0 && v + w <= square) {
        return point - (normal.dot(ap) / square) * normal;
    }
    return find_on_border(point, t);
}

void put_on_edges(const Vector3& a, const Vector3& b, const Vector3& p, const Vector3& q,
                  NearFeatures& near) noexcept {
    const Vector3 first = b - a;
    const Vector3 second = q - p;
    const Vector3 between = a - p;
    const double first_square = first.squaredNorm();
    const double second_square = second.squaredNorm();
    const double both = first.dot(second);
    const double along_first = first.dot(between);
    const double along_second = second.dot(between);
    const double sine_square = first_square * second_square - both * both;
    double s = 0.0;
    if (sine_square > kFlatSquare * first_square * second_square) {
        s = divide_within(both * along_second - along_first * second_square, sine_square);
    }
    // One from the other, twice: each is exact where the pair's own equations are not.
    double t = 0.0;
    for (int i = 0; i < 2; ++i) {
        t = divide_within(both * s + along_second, second_square);
        s = divide_within(both * t - along_first, first_square);
    }
    near.on_fixed = a + s * first;
    near.on_moving = p + t * second;
}

// Strictly from one side of the plane to the other, through the triangle or its border.
bool pierces(const Vector3& p, const Vector3& q, const Triangle& t) noexcept {
    if (orientation(t[0], t[1], t[2], p) * orientation(t[0], t[1], t[2], q) >= 0) {
        return false;
    }
    const int first = orientation(p, q, t[0], t[1]);
    const int second = orientation(p, q, t[1], t[2]);
    const int third = orientation(p, q, t[2], t[0]);
    return first * second >= 0 && second * third >= 0 && third * first >= 0;
}

bool edges_pierce(const Triangle& edges_of, const Triangle& face) noexcept {
    return pierces(edges_of[0], edges_of[1], face) || pierces(edges_of[1], edges_of[2], face) ||
           pierces(edges_of[2], edges_of[0], face);
}

}  // namespace

NearFeatures find_nearest_of(FeaturePair pair, std::uint8_t fixed_feature,
                             std::uint8_t moving_feature, const Triangle& fixed,
                             const Triangle& moving) noexcept {
    NearFeatures near;
    near.pair = pair;
    near.fixed_feature = fixed_feature;
    near.moving_feature = moving_feature;
    if (pair == FeaturePair::face_vertex) {
        near.on_moving = moving[moving_feature];
        near.on_fixed = find_on_triangle(near.on_moving, fixed);
    } else if (pair == FeaturePair::vertex_face) {
        near.on_fixed = fixed[fixed_feature];
        near.on_moving = find_on_triangle(near.on_fixed, moving);
    } else {
        put_on_edges(fixed[fixed_feature], fixed[(fixed_feature + 1U) % 3U], moving[moving_feature],
                     moving[(moving_feature + 1U) % 3U], near);
    }
    near.distance_m = (near.on_moving - near.on_fixed).norm();
    return near;
}

NearFeatures find_nearest_features(const Triangle& fixed, const Triangle& moving) noexcept {
    NearFeatures best;
    const auto offer = [&](FeaturePair pair, std::uint8_t i, std::uint8_t j) {
        const NearFeatures near = find_nearest_of(pair, i, j, fixed, moving);
        if (near.distance_m < best.distance_m) {
            best = near;
        }
    };
    for (std::uint8_t i = 0; i < 3; ++i) {
        offer(FeaturePair::face_vertex, 0, i);
        offer(FeaturePair::vertex_face, i, 0);
    }
    for (std::uint8_t i = 0; i < 3; ++i) {
        for (std::uint8_t j = 0; j < 3; ++j) {
            offer(FeaturePair::edge_edge, i, j);
        }
    }
    return best;
}

bool do_cross(const Triangle& fixed, const Triangle& moving) noexcept {
    return edges_pierce(moving, fixed) || edges_pierce(fixed, moving);
}

}  // namespace fulcrum
