// How contacts share what presses a rigid body on them: the most even way there is, as if each lay on a spring and all springs were alike.
//
//   p = argmin 1/2 sum of p_k^2 / s_k   subject to   sum of p_k J_k = W,   p_k >= 0          J_k = (n_k, r_k x n_k)
//   p_k = s_k max(0, J_k . x),   x = argmin 1/2 sum of s_k max(0, J_k . x)^2 - W . x         its dual
// x is how far the body sinks into the springs, shift and turn; the s_k their weights. Forces of redundant contacts are anybody's guess,
// and a solver's may change from one to the other by a rounding; these are one answer, which changes evenly with W and with where contacts are.
// Six unknowns, however many contacts: Newton's method on a function that is quadratic between planes, each step halved until it falls; it ends where no
// contact begins or ceases to press. Turns are counted in lengths of `reach_m`, and x is held to zero by a billionth of the springs, so that there is
// an answer for a W that rounding takes out of what contacts can give.
//
// Thread: that of its owner. Cost: 40 multiplications a contact and round, 3 to 6 rounds; no allocation after it was built.
// Source: the elastic foundation of E. Winkler 1867, Die Lehre von der Elasticitaet und Festigkeit; the dual of a quadratic program: O. L. Mangasarian 2004, A
// Newton method for linear programming, J. Optim. Theory Appl. 121(1), section 3.
#pragma once

#include "haptics/math/wrench_jacobian.h"

#include <cstddef>
#include <vector>

namespace fulcrum {

class EvenPressure {
  public:
    /// `reach_m`: about how far contacts lie from where turns are about, above 0.
    EvenPressure(std::size_t max_contacts, double reach_m);

    void clear() noexcept { n_ = 0; }
    /// A contact at `arm_W` from where the wrench is about, its normal of length 1; a weight of 0 or more. False where there is no room, or a number is
    /// none.
    bool add(const Vector3& arm_W, const Vector3& normal_W, double weight) noexcept;
    [[nodiscard]] std::size_t size() const noexcept { return n_; }

    /// Shares N and N m among the contacts. False, and nobody presses, where there is no force, or a number is none.
    bool solve(const Vector6& wrench) noexcept;
    /// Newtons along the normal of the contact that was added as `k`-th, in the last solve; 0 or more.
    [[nodiscard]] double force_N(std::size_t k) const noexcept { return forces_[k]; }
    /// Newtons and newton metres over the reach that the shares' sum is off, over what was to be shared; in the last solve.
    [[nodiscard]] double left_over() const noexcept { return left_over_; }
    [[nodiscard]] std::size_t memory_bytes() const noexcept {
        return rows_.capacity() * sizeof(Vector6) +
               (weights_.capacity() + forces_.capacity()) * sizeof(double);
    }

  private:
    // The slope of what is minimised, its second derivatives, and its value, for a wrench of length 1.
    struct Look {
        Vector6 slope{Vector6::Zero()};
        Matrix6 springs{Matrix6::Zero()};
        double value = 0.0;
    };
    [[nodiscard]] Look look(const Vector6& sunk, const Vector6& wanted) const noexcept;
    [[nodiscard]] double find_value(const Vector6& sunk, const Vector6& wanted) const noexcept;

    double reach_m_;
    std::size_t n_ = 0;
    std::vector<Vector6> rows_;  // turns over the reach
    std::vector<double> weights_;
    std::vector<double> forces_;
    double held_ = 0.0;  // the spring that holds x to zero
    double left_over_ = 0.0;
};

}  // namespace fulcrum
