// The set of impulses that one contact may have, and the point of it nearest to a given impulse.
//
//   cone      |p_t| <= mu p_n                          Coulomb's law, alike in all directions
//   pyramid   |p_t1| <= mu p_n,  |p_t2| <= mu p_n      a square one; holds up to sqrt(2) more along its diagonals
// The nearest point p of q in the set has, with s the directions in which it is at the bound (none, t / |t|, or those axes where
// |q_i| > mu p_n) and k their number,
//   p_n = (q_n + mu sum |q_s|) / (1 + k mu^2),   p_s = mu p_n,   the rest of t as it is;   all zero where p_n <= 0
// and as derivative the projection onto (1, mu s) and onto what is free, and in the cone the turning mu p_n / |q_t| (I - t t^T).
//
// Thread: any. Cost: some 20 multiplications and a square root.
#pragma once

#include "haptics/math/spatial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace fulcrum {

enum class FrictionShape : std::uint8_t { cone, pyramid };

/// How an impulse lies in its set.
struct ImpulseState {
    bool pressed = false;
    bool slips = false;         ///< at the bound in any direction
    std::array<int, 2> side{};  ///< of a pyramid: 0 within, else the sign at the bound
    [[nodiscard]] bool operator==(const ImpulseState&) const noexcept = default;
};

inline ImpulseState project_onto_cone(double friction, Vector3& q) noexcept {
    const double n = q.x();
    const double t = std::sqrt(q.y() * q.y() + q.z() * q.z());
    if (friction > 0.0 && n > 0.0 && t <= friction * n) {
        return {true, false, {}};
    }
    const double pressed = (n + friction * t) / (1.0 + friction * friction);
    if (!(pressed > 0.0)) {
        q.setZero();
        return {};
    }
    const double scale = t > 0.0 ? friction * pressed / t : 0.0;
    q = {pressed, scale * q.y(), scale * q.z()};
    return {true, true, {}};
}

inline ImpulseState project_onto_pyramid(double friction, Vector3& q) noexcept {
    // The axis that is further out reaches its bound first.
    const double t1 = std::abs(q.y());
    const double t2 = std::abs(q.z());
    const double far = std::max(t1, t2);
    const double square = friction * friction;
    double pressed = q.x();
    std::array<bool, 2> bound{};
    if (!(friction > 0.0 && pressed > 0.0 && far <= friction * pressed)) {
        pressed = (q.x() + friction * far) / (1.0 + square);
        bound = {t1 >= t2, t2 > t1};
        if (std::min(t1, t2) >= friction * pressed) {
            pressed = (q.x() + friction * (t1 + t2)) / (1.0 + 2.0 * square);
            bound = {true, true};
        }
    }
    if (!(pressed > 0.0)) {
        q.setZero();
        return {};
    }
    ImpulseState state{true, bound[0] || bound[1], {}};
    for (int i = 0; i < 2; ++i) {
        const auto axis = static_cast<std::size_t>(i);
        if (bound[axis]) {
            state.side[axis] = std::signbit(q[i + 1]) ? -1 : 1;
            q[i + 1] = state.side[axis] * friction * pressed;
        }
    }
    q.x() = pressed;
    return state;
}

/// q becomes the nearest impulse of the set.
inline ImpulseState project_impulse(FrictionShape shape, double friction, Vector3& q) noexcept {
    return shape == FrictionShape::cone ? project_onto_cone(friction, q)
                                        : project_onto_pyramid(friction, q);
}

/// The derivative of the nearest impulse `p` by `q`, symmetric, between 0 and 1.
inline Matrix3 compute_projection_slope(FrictionShape shape, double friction,
                                        const ImpulseState& state, const Vector3& q,
                                        const Vector3& p) noexcept {
    if (!state.pressed) {
        return Matrix3::Zero();
    }
    if (!state.slips) {
        return Matrix3::Identity();
    }
    Matrix3 slope = Matrix3::Zero();
    Vector3 edge(1.0, 0.0, 0.0);
    if (shape == FrictionShape::cone) {
        const double t = std::sqrt(q.y() * q.y() + q.z() * q.z());
        const double turning = t > 0.0 ? friction * p.x() / t : 0.0;
        const Vector3 side = t > 0.0 ? Vector3(0.0, q.y() / t, q.z() / t) : Vector3(0.0, 1.0, 0.0);
        edge += friction * side;
        const Vector3 across(0.0, -side.z(), side.y());
        slope = turning * across * across.transpose();
    } else {
        for (int i = 0; i < 2; ++i) {
            const int side = state.side[static_cast<std::size_t>(i)];
            edge[i + 1] = friction * side;
            slope(i + 1, i + 1) = side == 0 ? 1.0 : 0.0;
        }
    }
    return slope + edge * edge.transpose() / edge.squaredNorm();
}

/// mu times the slip: what the convex law lifts by where it slips, m/s.
inline double compute_lift(FrictionShape shape, double friction, const Vector3& u) noexcept {
    return friction * (shape == FrictionShape::cone ? std::sqrt(u.y() * u.y() + u.z() * u.z())
                                                    : std::abs(u.y()) + std::abs(u.z()));
}

/// Its derivative by u where it slips.
inline Vector3 compute_lift_slope(FrictionShape shape, double friction, const ImpulseState& state,
                                  const Vector3& u) noexcept {
    if (shape == FrictionShape::pyramid) {
        return {0.0, state.side[0] == 0 ? 0.0 : std::copysign(friction, u.y()),
                state.side[1] == 0 ? 0.0 : std::copysign(friction, u.z())};
    }
    const double t = std::sqrt(u.y() * u.y() + u.z() * u.z());
    return t > 0.0 ? Vector3(0.0, friction * u.y() / t, friction * u.z() / t)
                   : Vector3(0.0, 0.0, 0.0);
}

/// The tangent part of an impulse brought within its bound for a given normal part, which stays.
inline void clamp_friction(FrictionShape shape, double friction, Vector3& p) noexcept {
    const double bound = friction * std::max(p.x(), 0.0);
    if (shape == FrictionShape::cone) {
        const double t = std::sqrt(p.y() * p.y() + p.z() * p.z());
        if (t > bound) {
            p.y() *= bound / t;
            p.z() *= bound / t;
        }
    } else {
        p.y() = std::clamp(p.y(), -bound, bound);
        p.z() = std::clamp(p.z(), -bound, bound);
    }
}

}  // namespace fulcrum
