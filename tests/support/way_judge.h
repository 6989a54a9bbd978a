// A judge of what continuous collision found: places by another formula in more digits, distances by another algorithm, and all of the way walked
// in steps.
#pragma once

#include "tests/support/continuous_trial.h"

namespace fulcrum {

using LongVector = Matrix<long double, 3, 1>;

/// Walks the way of a pair.
class WayJudge {
  public:
    explicit WayJudge(const TrianglePair& pair);

    /// How far apart they are at t; below 0 how deep an edge of one goes through the other.
    [[nodiscard]] long double find_distance_m(long double t) const;
    /// The first time in [from, to] at which they are no more than `near_m` apart; 2 where there is none. No step is longer than
    /// their distance allows, but none shorter than a `finest` part of the way or of a metre; where such steps pass a valley, its bottom is looked for.
    [[nodiscard]] long double find_first(long double near_m, long double from, long double to,
                                         long double finest = 1.0e-3L) const;

  private:
    [[nodiscard]] std::array<LongVector, 3> find_place(long double t) const;
    [[nodiscard]] long double find_edge(long double near_m, long double far,
                                        long double near) const;
    [[nodiscard]] long double find_valley(long double from, long double to) const;

    std::array<LongVector, 3> fixed_;
    std::array<LongVector, 3> arms_;  // from the pivot, turned as at the start
    LongVector pivot_start_;
    LongVector travel_;
    LongVector axis_;
    long double angle_ = 0.0L;
    long double fastest_ = 0.0L;  // metres for the whole way, of any place
};

/// What a judge says of an answer.
struct Verdict {
    bool is_missed = false;    ///< they came within `touch`, or crossed, before the time told
    bool is_early = false;     ///< told to touch, but farther apart than touch + tolerance
    bool is_false = false;     ///< told to touch, and never within `touch`
    bool is_touching = false;  ///< they do come within `touch`
};
/// With the distance allowed for rounding, metres.
[[nodiscard]] Verdict judge(const TrianglePair& pair, const TriangleSweep& told,
                            const SweepSettings& settings, double rounding_m);

}  // namespace fulcrum
