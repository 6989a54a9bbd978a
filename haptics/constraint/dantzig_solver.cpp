#include "haptics/constraint/dantzig_solver.h"

#include "haptics/constraint/complementarity.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

// Redundant rows share alike by a softness that costs this much of the tolerance, and is this share of a row's weight at most.
constexpr double kSoftness = 0.1;
constexpr double kMostSoftness = 1.0e-6;
constexpr double kZero = 1.0e-3;   // of the tolerance; less than that softness makes
constexpr int kMostReleases = 20;  // rounds in which last step's sets are mended
constexpr int kMostRounds = 200;   // of friction's bounds
constexpr int kWholeRounds = 10;   // of them bounds follow at once in, then half way
constexpr int kPivotsARow = 10;    // in a round

std::size_t count_rows(const ContactCapacity& capacity) {
    return 3 * static_cast<std::size_t>(std::max(capacity.contacts, 0)) +
           static_cast<std::size_t>(std::max(capacity.rows, 0));
}

}  // namespace

DantzigSolver::DantzigSolver(const ContactSolverSettings&, const ContactCapacity& capacity)
    : motion_(capacity.bodies),
      factor_(count_rows(capacity)),
      max_(count_rows(capacity)),
      A_(max_ * max_),
      rows_(max_),
      clamped_(max_),
      work_(max_) {}

// A's row and column, which are zero but for rows that share a body.
void DantzigSolver::couple(std::size_t i, double softness) noexcept {
    const Row& row = rows_[i];
    for (std::size_t j = 0; j <= i; ++j) {
        const Row& other = rows_[j];
        double coupling = 0.0;
        if (row.body_a != kGround && row.body_a == other.body_a) {
            coupling += row.jacobian_a.dot(other.change_a);
        }
        if (row.body_a != kGround && row.body_a == other.body_b) {
            coupling += row.jacobian_a.dot(other.change_b);
        }
        if (row.body_b != kGround && row.body_b == other.body_a) {
            coupling += row.jacobian_b.dot(other.change_a);
        }
        if (row.body_b != kGround && row.body_b == other.body_b) {
            coupling += row.jacobian_b.dot(other.change_b);
        }
        entry(i, j) = entry(j, i) = coupling;
    }
    entry(i, i) += softness;
}

void DantzigSolver::add_row(const ContactProblem& problem, const Row& given, double target,
                            double softness) noexcept {
    const std::span<const ConstrainedBody> bodies = problem.bodies();
    Row& row = rows_[n_] = given;
    row.b = -target;
    if (row.body_a != kGround) {
        const ConstrainedBody& body = bodies[static_cast<std::size_t>(row.body_a)];
        row.change_a = compute_velocity_change(body, row.jacobian_a);
        row.b += row.jacobian_a.dot(body.free_velocity_W);
    }
    if (row.body_b != kGround) {
        const ConstrainedBody& body = bodies[static_cast<std::size_t>(row.body_b)];
        row.change_b = compute_velocity_change(body, row.jacobian_b);
        row.b += row.jacobian_b.dot(body.free_velocity_W);
    }
    couple(n_, softness);
    ++n_;
}

void DantzigSolver::build(const ContactProblem& problem, std::span<const double> friction,
                          double tolerance) noexcept {
    n_ = 0;
    for (std::size_t i = 0; i < friction.size(); ++i) {
        const ContactConstraint& c = problem.contacts()[i];
        const std::size_t normal = n_;
        for (int k = 0; k < 3; ++k) {
            Row row;
            row.body_a = c.body_a;
            row.body_b = c.body_b;
            const Vector3 axis = c.axes_W.col(k);
            row.jacobian_a << -axis, -c.arm_a.cross(axis);
            row.jacobian_b << axis, c.arm_b.cross(axis);
            row.f = c.impulse_Ns[k];
            row.hi = HUGE_VAL;
            row.friction = k == 0 ? -1.0 : friction[i];
            row.normal = normal;
            add_row(problem, row, c.target_m_per_s[k], c.softness_per_kg);
        }
    }
    for (const RowConstraint& r : problem.rows()) {
        Row row;
        row.body_a = r.body_a;
        row.body_b = r.body_b;
        row.jacobian_a = r.jacobian_a;
        row.jacobian_b = r.jacobian_b;
        row.f = r.impulse;
        row.lo = r.least;
        row.hi = r.most;
        add_row(problem, row, r.target, r.softness);
    }
    // Below a stack lies the weight of all.
    double fastest = 0.0;
    for (std::size_t i = 0; i < n_; ++i) {
        fastest = std::max(fastest, std::abs(rows_[i].b));
    }
    fastest *= static_cast<double>(problem.bodies().size());
    const double share =
        fastest > 0.0 ? std::min(kSoftness * tolerance / fastest, kMostSoftness) : 0.0;
    for (std::size_t i = 0; i < n_; ++i) {
        entry(i, i) *= 1.0 + share;
    }
}

double DantzigSolver::take_bounds() noexcept {
    double change = 0.0;
    for (std::size_t i = 0; i < n_; ++i) {
        Row& row = rows_[i];
        if (row.friction >= 0.0) {
            const double asked = row.friction * std::max(rows_[row.normal].f, 0.0);
            const double bound =
                report_.n_iterations < kWholeRounds ? asked : 0.5 * (row.hi + asked);
            // What is held between the bounds, old and new, does not feel them.
            if (!row.clamped || std::abs(row.f) > bound) {
                change = std::max(change, std::abs(bound - row.hi) * entry(i, i));
            }
            // A row at its bound stays there.
            if (!row.clamped && std::abs(row.f) >= row.hi) {
                row.f = std::copysign(bound, row.f);
            }
            row.hi = bound;
            row.lo = -bound;
        }
        if (!row.clamped) {
            row.f = std::clamp(row.f, row.lo, row.hi);
        }
    }
    return change;
}

void DantzigSolver::clamp_row(std::size_t i) noexcept {
    const std::size_t n = factor_.size();
    for (std::size_t j = 0; j < n; ++j) {
        work_[j] = entry(i, clamped_[j]);
    }
    report_.n_regularised += factor_.append({work_.data(), n}, entry(i, i)) ? 0 : 1;
    clamped_[n] = i;
    rows_[i].clamped = true;
}

void DantzigSolver::release_row(std::size_t i) noexcept {
    const auto end = clamped_.begin() + static_cast<std::ptrdiff_t>(factor_.size());
    const auto at = std::find(clamped_.begin(), end, i);
    factor_.remove(static_cast<std::size_t>(at - clamped_.begin()));
    std::copy(at + 1, end, at);
    rows_[i].clamped = false;
}

// f of the clamped rows from w = 0 with the others as they are; what leaves its bounds is released there. True when none did.
bool DantzigSolver::solve_clamped() noexcept {
    const std::size_t n = factor_.size();
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t i = clamped_[k];
        double right = -rows_[i].b;
        for (std::size_t j = 0; j < n_; ++j) {
            right -= rows_[j].clamped ? 0.0 : entry(i, j) * rows_[j].f;
        }
        work_[k] = right;
    }
    factor_.solve({work_.data(), n});
    bool all_within = true;
    for (std::size_t k = 0; k < n; ++k) {
        rows_[clamped_[k]].f = work_[k];
    }
    for (std::size_t i = 0; i < n_; ++i) {
        Row& row = rows_[i];
        if (row.clamped && !(row.f >= row.lo && row.f <= row.hi)) {
            row.f = std::clamp(row.f, row.lo, row.hi);
            release_row(i);
            ++report_.n_pivots;
            all_within = false;
        }
    }
    return all_within;
}

void DantzigSolver::start_from_sets() noexcept {
    factor_.clear();
    for (std::size_t i = 0; i < n_; ++i) {
        Row& row = rows_[i];
        row.clamped = false;
    }
    for (std::size_t i = 0; i < n_; ++i) {
        const Row& row = rows_[i];
        if (row.f > row.lo && row.f < row.hi && entry(i, i) > 0.0) {
            clamp_row(i);
        }
    }
}

void DantzigSolver::compute_w() noexcept {
    for (std::size_t i = 0; i < n_; ++i) {
        double w = rows_[i].b;
        for (std::size_t j = 0; j < n_; ++j) {
            w += entry(i, j) * rows_[j].f;
        }
        rows_[i].w = rows_[i].clamped ? 0.0 : w;
    }
}

bool DantzigSolver::fits(const Row& row) const noexcept {
    return row.clamped || row.lo == row.hi || std::abs(row.w) <= zero_ ||
           (row.f <= row.lo && row.w > 0.0) || (row.f >= row.hi && row.w < 0.0);
}

// df and dw of all rows for a push of row d.
void DantzigSolver::push(std::size_t d) noexcept {
    const std::size_t n = factor_.size();
    const double direction = rows_[d].w < 0.0 ? 1.0 : -1.0;
    for (std::size_t k = 0; k < n; ++k) {
        work_[k] = -direction * entry(clamped_[k], d);
    }
    factor_.solve({work_.data(), n});
    for (std::size_t i = 0; i < n_; ++i) {
        Row& row = rows_[i];
        row.df = 0.0;
        row.dw = direction * entry(i, d);
        if (!row.clamped) {
            for (std::size_t k = 0; k < n; ++k) {
                row.dw += entry(i, clamped_[k]) * work_[k];
            }
        }
    }
    for (std::size_t k = 0; k < n; ++k) {
        rows_[clamped_[k]].df = work_[k];
        rows_[clamped_[k]].dw = 0.0;
    }
    rows_[d].df = direction;
}

DantzigSolver::Event DantzigSolver::find_event(std::size_t d) const noexcept {
    const Row& driven = rows_[d];
    // Toward w_d = 0; a w that its own push does not move is left.
    Event event{driven.dw * driven.df > 0.0 ? std::abs(driven.w / driven.dw) : HUGE_VAL, d, true};
    for (std::size_t i = 0; i < n_; ++i) {
        const Row& row = rows_[i];
        if (row.df != 0.0) {
            const double room = row.df > 0.0 ? row.hi - row.f : row.lo - row.f;
            const double length = std::max(room / row.df, 0.0);
            if (length < event.length) {
                event = {length, i, false};
            }
        } else if (!row.clamped && row.lo < row.hi && fits(row) &&
                   ((row.f <= row.lo && row.dw < 0.0) || (row.f >= row.hi && row.dw > 0.0))) {
            const double length = std::max(-row.w / row.dw, 0.0);
            if (length < event.length) {
                event = {length, i, true};
            }
        }
    }
    return event;
}

bool DantzigSolver::drive(std::size_t d) noexcept {
    const Row& driven = rows_[d];
    while (!fits(driven)) {
        push(d);
        const Event event = find_event(d);
        if (++report_.n_pivots > most_pivots_ || !(event.length < HUGE_VAL)) {
            return false;
        }
        for (std::size_t i = 0; i < n_; ++i) {
            rows_[i].f += event.length * rows_[i].df;
            rows_[i].w += event.length * rows_[i].dw;
        }
        Row& row = rows_[event.row];
        if (event.joins) {
            row.w = 0.0;
            clamp_row(event.row);
        } else {
            row.f = row.df > 0.0 ? row.hi : row.lo;
            if (event.row == d) {
                return true;  // at its bound it fits
            }
            release_row(event.row);
        }
    }
    // Between its bounds it is held from now on.
    if (!driven.clamped && driven.f > driven.lo && driven.f < driven.hi) {
        clamp_row(d);
    }
    return true;
}

bool DantzigSolver::drive_all() noexcept {
    most_pivots_ = report_.n_pivots + kPivotsARow * static_cast<int>(n_);
    for (int round = 0; round < kMostReleases && !solve_clamped(); ++round) {
    }
    compute_w();
    for (std::size_t i = 0; i < n_; ++i) {
        if (!drive(i)) {
            return false;
        }
    }
    // What was driven is solved at once: sums of many pushes are not exact.
    return solve_clamped() || report_.n_pivots < most_pivots_;
}

void DantzigSolver::keep(ContactProblem& problem) const noexcept {
    std::size_t i = 0;
    for (ContactConstraint& c : problem.contacts()) {
        c.impulse_Ns = {rows_[i].f, rows_[i + 1].f, rows_[i + 2].f};
        c.impulse_Ns.x() = std::max(c.impulse_Ns.x(), 0.0);
        if (!c.impulse_Ns.allFinite()) {
            c.impulse_Ns.setZero();
        }
        i += 3;
    }
    for (RowConstraint& row : problem.rows()) {
        const double f = rows_[i++].f;
        row.impulse = std::clamp(std::isfinite(f) ? f : 0.0, row.least, row.most);
    }
}

SolveReport DantzigSolver::solve(ContactProblem& problem, std::span<const double> friction,
                                 double tolerance) noexcept {
    report_ = {};
    zero_ = kZero * tolerance;
    build(problem, friction, tolerance);
    take_bounds();
    start_from_sets();
    bool done = true;
    double change = HUGE_VAL;
    while (done && change > zero_ && report_.n_iterations < kMostRounds) {
        done = drive_all();
        change = take_bounds();
        ++report_.n_iterations;
    }
    // Bounds that never came to agree; and of this problem's rows none may be without a number.
    done = done && change <= zero_;
    for (std::size_t i = 0; i < n_; ++i) {
        done = done && std::isfinite(rows_[i].f);
    }
    report_.n_regularised += done ? 0 : 1;
    keep(problem);
    apply_impulses(problem, motion_);
    report_.residual_m_per_s = compute_residual(problem, FrictionShape::pyramid, friction);
    report_.converged = report_.residual_m_per_s <= tolerance;
    return report_;
}

}  // namespace fulcrum
