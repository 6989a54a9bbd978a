#include "haptics/device/arm/stick_slip.h"

#include "haptics/device/arm/cholesky.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr int kMostFits = 8;
constexpr int kMostSweeps = 2000;
// Of the largest push: what rounding leaves of a sum of seven products.
constexpr double kSumRounding = 1.0e-13;

bool slides(JointHold hold) noexcept {
    return hold == JointHold::forward || hold == JointHold::backward;
}

// The velocity that a held joint has.
double velocity_of(const StickSlipProblem& problem, JointHold hold, int i) noexcept {
    if (hold == JointHold::at_low) {
        return problem.low(i);
    }
    return hold == JointHold::at_high ? problem.high(i) : 0.0;
}

// w of the sets: the sliding joints from their equations, the others as they are held.
void solve_sets(const StickSlipProblem& problem, const JointHolds& holds, JointVector& w) noexcept {
    const int n = static_cast<int>(problem.push.size());
    std::array<int, kMostJoints> sliding{};
    int n_sliding = 0;
    for (int i = 0; i < n; ++i) {
        const JointHold hold = holds[static_cast<std::size_t>(i)];
        if (slides(hold)) {
            sliding[static_cast<std::size_t>(n_sliding++)] = i;
        } else {
            w(i) = velocity_of(problem, hold, i);
        }
    }
    JointMatrix a(n_sliding, n_sliding);
    JointVector b(n_sliding);
    for (int r = 0; r < n_sliding; ++r) {
        const int i = sliding[static_cast<std::size_t>(r)];
        const bool forward = holds[static_cast<std::size_t>(i)] == JointHold::forward;
        b(r) = problem.push(i) - (forward ? problem.dry(i) : -problem.dry(i));
        for (int k = 0; k < n_sliding; ++k) {
            a(r, k) = problem.inertia(i, sliding[static_cast<std::size_t>(k)]);
        }
        for (int k = 0; k < n; ++k) {
            if (!slides(holds[static_cast<std::size_t>(k)])) {
                b(r) -= problem.inertia(i, k) * w(k);
            }
        }
    }
    factor_cholesky(a);
    solve_cholesky(a, b);
    for (int r = 0; r < n_sliding; ++r) {
        w(sliding[static_cast<std::size_t>(r)]) = b(r);
    }
}

// What a sliding joint should rather do at `w`.
JointHold mend_sliding(const StickSlipProblem& problem, JointHold hold, int i, double w) noexcept {
    if (hold == JointHold::forward ? w < 0.0 : w > 0.0) {
        return JointHold::stuck;
    }
    if (w > problem.high(i)) {
        return JointHold::at_high;
    }
    return w < problem.low(i) ? JointHold::at_low : hold;
}

// Whether a joint leaves its upper stop under the impulse r: a stop only pushes, and a joint that stands at it may be held
// by friction too. The lower stop is the same with all signs turned.
bool leaves_stop(double r, double dry, double rounding, bool stands) noexcept {
    return r > (stands ? dry : -dry) + rounding;
}

JointHold mend_stuck(const StickSlipProblem& problem, int i, double r, double rounding) noexcept {
    const double dry = problem.dry(i) + rounding;
    if (r < -dry) {
        return problem.high(i) == 0.0 ? JointHold::at_high : JointHold::forward;
    }
    if (r > dry) {
        return problem.low(i) == 0.0 ? JointHold::at_low : JointHold::backward;
    }
    return JointHold::stuck;
}

// What a held joint should rather do that is given the impulse r.
JointHold mend_held(const StickSlipProblem& problem, JointHold hold, int i, double r,
                    double rounding) noexcept {
    if (hold == JointHold::stuck) {
        return mend_stuck(problem, i, r, rounding);
    }
    const bool high = hold == JointHold::at_high;
    const bool stands = (high ? problem.high(i) : problem.low(i)) == 0.0;
    if (!leaves_stop(high ? r : -r, problem.dry(i), rounding, stands)) {
        return hold;
    }
    // Standing it leaves the stop; moving it was slower than the stop would let it be.
    return high == stands ? JointHold::backward : JointHold::forward;
}

// True when no joint should do something else; else its set is changed.
bool mend(const StickSlipProblem& problem, const JointVector& w, double rounding,
          JointHolds& holds) noexcept {
    bool holds_good = true;
    const JointVector r = multiply(problem.inertia, w) - problem.push;
    for (int i = 0; i < w.size(); ++i) {
        JointHold& hold = holds[static_cast<std::size_t>(i)];
        const JointHold better = slides(hold) ? mend_sliding(problem, hold, i, w(i))
                                              : mend_held(problem, hold, i, r(i), rounding);
        holds_good = holds_good && better == hold;
        hold = better;
    }
    return holds_good;
}

// The best w_i with all others as they are.
double minimise_one(const StickSlipProblem& problem, const JointVector& w, int i) noexcept {
    const double a = problem.inertia(i, i);
    double b = problem.push(i) + a * w(i);
    for (Index j = 0; j < w.size(); ++j) {
        b -= problem.inertia(i, j) * w(j);
    }
    const double beyond = std::max(std::abs(b) - problem.dry(i), 0.0) / a;
    return std::clamp(b < 0.0 ? -beyond : beyond, problem.low(i), problem.high(i));
}

// The sets that `w` shows.
void read_holds(const StickSlipProblem& problem, const JointVector& w, JointHolds& holds) noexcept {
    for (int i = 0; i < w.size(); ++i) {
        JointHold hold = w(i) > 0.0 ? JointHold::forward : JointHold::backward;
        if (w(i) == 0.0) {
            hold = JointHold::stuck;
        } else if (w(i) == problem.high(i)) {
            hold = JointHold::at_high;
        } else if (w(i) == problem.low(i)) {
            hold = JointHold::at_low;
        }
        holds[static_cast<std::size_t>(i)] = hold;
    }
}

int descend(const StickSlipProblem& problem, double rounding, JointVector& w) noexcept {
    for (int i = 0; i < w.size(); ++i) {
        w(i) = std::clamp(w(i), problem.low(i), problem.high(i));
    }
    for (int sweep = 1; sweep <= kMostSweeps; ++sweep) {
        double change = 0.0;
        for (int i = 0; i < w.size(); ++i) {
            const double better = minimise_one(problem, w, i);
            change = std::max(change, std::abs(better - w(i)) * problem.inertia(i, i));
            w(i) = better;
        }
        if (change <= rounding) {
            return sweep;
        }
    }
    return kMostSweeps;
}

}  // namespace

StickSlipCount solve_stick_slip(const StickSlipProblem& problem, JointHolds& holds,
                                JointVector& w) noexcept {
    StickSlipCount count;
    w.resize(problem.push.size());
    const double rounding =
        kSumRounding * (problem.push.cwiseAbs().maxCoeff() + problem.dry.maxCoeff());
    for (count.tries = 1; count.tries <= kMostFits; ++count.tries) {
        solve_sets(problem, holds, w);
        if (mend(problem, w, rounding, holds)) {
            return count;
        }
    }
    count.sweeps = descend(problem, rounding, w);
    read_holds(problem, w, holds);
    return count;
}

double compute_stick_slip_residual(const StickSlipProblem& problem, const JointVector& w) noexcept {
    double worst = 0.0;
    for (int i = 0; i < w.size(); ++i) {
        worst =
            std::max(worst, std::abs(minimise_one(problem, w, i) - w(i)) * problem.inertia(i, i));
    }
    return worst;
}

}  // namespace fulcrum
