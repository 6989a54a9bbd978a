// Contact problems in impulses, by Dantzig's pivoting: one row after the other is driven to where it fits.
//
//   w = A f + b,   A = J M^-1 J^T + R,   b = J v_free - target;   of each row   lo <= f <= hi
//   clamped: w = 0, lo < f < hi        at a bound: f = lo and w >= 0, or f = hi and w <= 0
// A row d that does not fit yet is pushed by df_d = +-1. Those that are clamped follow, A_CC df_C = -A_Cd df_d, so that their w stay
// zero, as far as until w_d is zero, an f comes to its bound or the w of a fitting row to zero; that row changes its set, and d
// goes on. A is positive definite, so each drive ends. Factors of A_CC are kept while rows join and leave (incremental_ldlt.h),
// and rows stand in the chain's order, so that the factor is as narrow as the chain.
//
// Friction: a contact's tangents are rows between -mu f_n and mu f_n, a pyramid whatever the settings say. The bounds are those of
// the f_n before; all is driven again with the new ones until they agree; after ten rounds with those half way to the new ones, for
// they may swing. Last step's sets are tried first: where they still fit, nothing is driven, and a round is one solve with the factor
// that is there.
//
// A pivot that follows from others (redundant contacts) is mended and counted, and so is a solve that ends without agreement or
// after too many pivots: its impulses are finite and within the bounds that were last taken.
//
// Thread: that of the solver. Cost: of a pivot, rows times clamped rows; 16 bytes a pair of rows.
// Source: D. Baraff 1994, Fast contact force computation for nonpenetrating rigid bodies, SIGGRAPH, sections 4 and 5 (drives,
// static and dynamic friction); R. Cottle, G. Dantzig 1968, Complementary pivot theory, Linear Algebra Appl. 1. Bounds taken
// anew: J. Haslinger 1983, Approximation of the Signorini problem with friction, obeying the Coulomb law.
#pragma once

#include "haptics/constraint/contact_method.h"
#include "haptics/constraint/contact_motion.h"
#include "haptics/constraint/incremental_ldlt.h"

#include <span>
#include <vector>

namespace fulcrum {

class DantzigSolver final : public ContactMethodSolver {
  public:
    DantzigSolver(const ContactSolverSettings& settings, const ContactCapacity& capacity);
    SolveReport solve(ContactProblem& problem, std::span<const double> friction,
                      double tolerance) noexcept override;

  private:
    struct Row {
        int body_a = kGround, body_b = kGround;
        Vector6 jacobian_a{Vector6::Zero()}, jacobian_b{Vector6::Zero()};
        Vector6 change_a{Vector6::Zero()}, change_b{Vector6::Zero()};  // M^-1 J^T
        double b = 0.0, f = 0.0, w = 0.0, lo = 0.0, hi = 0.0;
        double df = 0.0, dw = 0.0;
        double friction = -1.0;  // of a tangent; its contact's normal is `normal`
        std::size_t normal = 0;
        bool clamped = false;
    };
    /// What ends a drive's stretch.
    struct Event {
        double length = 0.0;
        std::size_t row = 0;
        bool joins = false;  // else it comes to a bound
    };

    void build(const ContactProblem& problem, std::span<const double> friction,
               double tolerance) noexcept;
    void add_row(const ContactProblem& problem, const Row& row, double target,
                 double softness) noexcept;
    void couple(std::size_t i, double softness) noexcept;
    [[nodiscard]] double& entry(std::size_t i, std::size_t j) noexcept { return A_[i * max_ + j]; }
    double take_bounds() noexcept;
    void clamp_row(std::size_t i) noexcept;
    void release_row(std::size_t i) noexcept;
    void start_from_sets() noexcept;
    bool solve_clamped() noexcept;
    void compute_w() noexcept;
    [[nodiscard]] bool fits(const Row& row) const noexcept;
    void push(std::size_t d) noexcept;
    [[nodiscard]] Event find_event(std::size_t d) const noexcept;
    bool drive(std::size_t d) noexcept;
    bool drive_all() noexcept;
    void keep(ContactProblem& problem) const noexcept;

    BodyMotion motion_;
    IncrementalLdlt factor_;
    std::size_t max_;
    std::size_t n_ = 0;
    std::vector<double> A_;
    std::vector<Row> rows_;
    std::vector<std::size_t> clamped_;  // rows in the order of the factor
    std::vector<double> work_;
    double zero_ = 0.0;  // a w that counts as none
    int most_pivots_ = 0;
    SolveReport report_{};
};

}  // namespace fulcrum
