// The numbers whose roots are contacts: what a plane, or a pair of edges, says of a point under an in-between motion. All are of one kind,
//
//   f(t) = k_0 + k_1 t + (c_0 + c_1 t) cos(w t) + (s_0 + s_1 t) sin(w t)
// with, for a moving vector v(t) = v_a + cos v_b + sin v_c, w_0 = c_0 - a what is from a held point a to the pivot, and d the pivot's way:
//   a held face (a, normal n), a moving corner p:        f = n . (p(t) - a)
//   a held corner v, a moving face (corner p, normal N): f = N(t) . (v - p(t)) = N(t) . (v - c_0 - t d) - N_0 . r_0
//   a held edge (a, e), a moving edge (p, M):            f = (e x M(t)) . (p(t) - a) = M(t) . ((w_0 + t d) x e) + e . Q(t),  Q = M x r
// r_0 = p(0) - c_0. f is the height over the plane times |n|, or the distance of the two lines times |e x M| <= |e| |M|.
// The coefficients are intervals: what rounding took from a path's vectors is in them.
//
// Thread: any. Cost: 0.1 to 0.3 us to make; a value 30 ns.
// Source: S. Redon, A. Kheddar, S. Coquillart 2002 (in_between_motion.h), the elementary contact equations; their form in cos and sin is
// worked out here.
#pragma once

#include "haptics/continuous/sweep.h"

namespace fulcrum {

struct TurnFunction {
    Interval constant, linear, cosine, cosine_linear, sine, sine_linear;
    double angle_rad = 0.0;
    /// An upper bound of what a metre of distance makes of f.
    double per_m = 0.0;

    [[nodiscard]] Interval find_value(const Interval& t,
                                      const SineCosineInterval& turn) const noexcept {
        return constant + linear * t + (cosine + cosine_linear * t) * turn.cosine +
               (sine + sine_linear * t) * turn.sine;
    }
    /// df/dt.
    [[nodiscard]] Interval find_rate(const Interval& t,
                                     const SineCosineInterval& turn) const noexcept {
        return linear + cosine_linear * turn.cosine + sine_linear * turn.sine +
               angle_rad * ((sine + sine_linear * t) * turn.cosine -
                            (cosine + cosine_linear * t) * turn.sine);
    }
};

/// Of the named features; all of it as above.
[[nodiscard]] TurnFunction make_turn_function(const InBetweenMotion& motion, const Triangle& fixed,
                                              const MovingTriangle& moving, FeaturePair pair,
                                              std::size_t fixed_feature, std::size_t moving_feature,
                                              const SweepBounds& bounds) noexcept;

}  // namespace fulcrum
