#include "haptics/constraint/least_constraint.h"

#include "haptics/math/dense.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fulcrum {
namespace {

// Normals are differences over small gaps: they err by as much as 1e-9, and so do rows of length 1.
constexpr double kRowError = 4.0e-9;
// A row whose bound is missed by no more than its error follows from those that act where it is so near to their space: to meet its bound would
// make of the error this many times as much.
constexpr double kNearlyFollows = 1.0e-2;
constexpr double kTouches = 5.0e-14;  // of what is wanted: below it a bound is kept
constexpr double kCycles =
    1.0e-6;  // of what is wanted: rows that err and take each other's place without end are missed by less
constexpr int kRoundsPerContact =
    4;  // far above what any problem took; a guard against a cycle by rounding
constexpr int kRoundsAtLeast = 200;
constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

// What of `row` is not in the first n columns of Q; `along` gets what is. Twice, so that nothing is left of them.
Vector6 remove_from(const Matrix6& Q, int n, const Vector6& row, Vector6& along) noexcept {
    Vector6 rest = row;
    along.setZero();
    for (int pass = 0; pass < 2; ++pass) {
        for (int i = 0; i < n; ++i) {
            const double part = Q.col(i).dot(rest);
            rest -= part * Q.col(i);
            along[i] += part;
        }
    }
    return rest;
}

// Of a triangle of three rows, by hand.
Matrix3 invert_lower(const Matrix3& L) noexcept {
    Matrix3 inverse = Matrix3::Zero();
    for (int i = 0; i < 3; ++i) {
        inverse(i, i) = 1.0 / L(i, i);
        for (int j = i - 1; j >= 0; --j) {
            double sum = 0.0;
            for (int k = j; k < i; ++k) {
                sum -= L(i, k) * inverse(k, j);
            }
            inverse(i, j) = sum / L(i, i);
        }
    }
    return inverse;
}

// R x = b, or R^T x = b, of the first n rows and columns.
Vector6 solve_upper(const Matrix6& R, int n, const Vector6& b) noexcept {
    Vector6 x = Vector6::Zero();
    for (int i = n - 1; i >= 0; --i) {
        double sum = b[i];
        for (int j = i + 1; j < n; ++j) {
            sum -= R(i, j) * x[j];
        }
        x[i] = sum / R(i, i);
    }
    return x;
}

Vector6 solve_lower(const Matrix6& R, int n, const Vector6& b) noexcept {
    Vector6 x = Vector6::Zero();
    for (int i = 0; i < n; ++i) {
        double sum = b[i];
        for (int j = 0; j < i; ++j) {
            sum -= R(j, i) * x[j];
        }
        x[i] = sum / R(i, i);
    }
    return x;
}

// Until the first of n forces is none.
struct PartialStep {
    double until = std::numeric_limits<double>::infinity();
    int first = -1;
};

PartialStep find_partial_step(int n, const Vector6& force, const Vector6& ratio) noexcept {
    PartialStep step;
    for (int j = 0; j < n; ++j) {
        if (ratio[j] > 0.0 && force[j] / ratio[j] < step.until) {
            step = {force[j] / ratio[j], j};
        }
    }
    return step;
}

}  // namespace

bool LeastConstraintSolver::set_inertia(double mass_kg, const Matrix3& inertia_W) noexcept {
    const std::optional<Matrix3> factor = compute_cholesky(inertia_W);
    if (!(mass_kg > 0.0) || !std::isfinite(mass_kg) || !inertia_W.allFinite() || !factor) {
        return false;
    }
    L_.setZero();
    L_.diagonal().head<3>().setConstant(std::sqrt(mass_kg));
    L_.bottomRightCorner<3, 3>() = *factor;
    per_root_mass_ = 1.0 / L_(0, 0);
    per_root_inertia_ = invert_lower(L_.bottomRightCorner<3, 3>());
    return true;
}

bool LeastConstraintSolver::add(const Vector3& arm_W, const Vector3& normal_W,
                                double least) noexcept {
    if (n_ == rows_.size() || !arm_W.allFinite() || !normal_W.allFinite() ||
        !(least < std::numeric_limits<double>::infinity())) {
        return false;
    }
    Vector6 row;
    row << per_root_mass_ * normal_W, per_root_inertia_ * arm_W.cross(normal_W);
    const double length = row.norm();
    if (!(length > 0.0) || !std::isfinite(length)) {
        return false;
    }
    rows_[n_] = row / length;
    least_[n_] = least / length;
    length_[n_] = length;
    ++n_;
    return true;
}

// False where no more than `least_rest` of the row is not theirs that act.
bool LeastConstraintSolver::append(std::size_t k, double least_rest) noexcept {
    Vector6 along;
    const Vector6 rest = remove_from(acting_.Q, acting_.n, row(k), along);
    const double length = rest.norm();
    if (acting_.n == kMost || length <= least_rest) {
        return false;
    }
    acting_.Q.col(acting_.n) = rest / length;
    acting_.R.col(acting_.n) = along;
    acting_.R(acting_.n, acting_.n) = length;
    acting_.which[static_cast<std::size_t>(acting_.n)] = k;
    ++acting_.n;
    return true;
}

// Those behind move up, on a basis made anew: at most six, and nothing of its rounding is kept.
void LeastConstraintSolver::drop(int place) noexcept {
    const Acting old = acting_;
    acting_.n = 0;
    for (int i = 0; i < old.n; ++i) {
        if (i != place) {
            const int now = acting_.n;
            append(old.which[static_cast<std::size_t>(i)], 0.0);
            acting_.force[now] = old.force[i];
        }
    }
}

// The point nearest to `wanted` where all that act are met exactly: wanted + Q R^-T (b - N^T wanted), and their forces. What rounding left of
// that is met in a second pass: in a hollow where the tool is stuck the forces are a hundred times what is wanted, and so is what they leave.
Vector6 LeastConstraintSolver::nearest(const Vector6& wanted, Vector6& force) const noexcept {
    Vector6 at = wanted;
    Vector6 in_all = Vector6::Zero();
    for (int pass = 0; pass < 2; ++pass) {
        Vector6 missing = Vector6::Zero();
        for (int i = 0; i < acting_.n; ++i) {
            const std::size_t k = acting_.which[static_cast<std::size_t>(i)];
            missing[i] = least_[k] - row(k).dot(at);
        }
        const Vector6 along = solve_lower(acting_.R, acting_.n, missing);
        in_all += along;
        for (int i = 0; i < acting_.n; ++i) {
            at += along[i] * acting_.Q.col(i);
        }
    }
    force = solve_upper(acting_.R, acting_.n, in_all);
    return at;
}

// Those that acted last act again if all of them push and none nearly follows; else nothing acts yet.
void LeastConstraintSolver::start(const Vector6& wanted) noexcept {
    const Acting before = acting_;
    acting_.n = 0;
    for (int i = 0; i < before.n; ++i) {
        const std::size_t k = before.which[static_cast<std::size_t>(i)];
        if (k >= n_ || !append(k, kNearlyFollows)) {
            acting_.n = 0;
            return;
        }
    }
    (void)nearest(wanted, acting_.force);
    for (int i = 0; i < acting_.n; ++i) {
        if (!(acting_.force[i] >= 0.0)) {
            acting_.n = 0;
            return;
        }
    }
}

// The contact whose bound is missed by most.
std::size_t LeastConstraintSolver::find_worst(const Vector6& at, double tolerance) const noexcept {
    std::size_t worst = kNone;
    double most = -tolerance;
    for (std::size_t k = 0; k < n_; ++k) {
        const double slack = row(k).dot(at) - least_[k];
        if (slack < most) {
            most = slack;
            worst = k;
        }
    }
    return worst;
}

// Goldfarb and Idnani's step 2: contact k begins to act; on the way to its bound those whose force would be a pull cease to. False: no point keeps
// its bound and those of the others. `error`: how far it may be from what the rows say, for each of them errs; what is
// no farther from the space of those that act follows from them.
bool LeastConstraintSolver::take(std::size_t k, double size, Vector6& at, double& error) noexcept {
    double force = 0.0;  // of k
    for (int i = 0; i <= kMost; ++i) {
        Vector6 along;
        const Vector6 rest = remove_from(acting_.Q, acting_.n, row(k), along);
        const Vector6 ratio = solve_upper(acting_.R, acting_.n, along);
        const double square = rest.squaredNorm();
        // What the rows' errors make of the rest.
        double ratios = 0.0;
        for (int j = 0; j < acting_.n; ++j) {
            ratios += std::abs(ratio[j]);
        }
        error = kRowError * (1.0 + ratios);
        const double slack = row(k).dot(at) - least_[k];
        const double within = -slack > error * size ? error : std::max(error, kNearlyFollows);
        const bool follows = acting_.n == kMost || square <= within * within;
        const PartialStep partial = find_partial_step(acting_.n, acting_.force, ratio);
        const double whole =
            follows ? std::numeric_limits<double>::infinity() : std::max(-slack, 0.0) / square;
        const double step = std::min(partial.until, whole);
        if (!std::isfinite(step)) {
            return false;
        }
        if (!follows) {
            at += step * rest;
        }
        for (int j = 0; j < acting_.n; ++j) {
            acting_.force[j] -= step * ratio[j];
        }
        force += step;
        ++answer_.rounds;
        if (step == whole) {
            const int place = acting_.n;
            append(k, 0.0);
            acting_.force[place] = force;
            return true;
        }
        drop(partial.first);
    }
    return false;
}

const LeastConstraint& LeastConstraintSolver::give_up() noexcept {
    acting_.n = 0;
    answer_.acceleration.setZero();
    answer_.force.setZero();
    answer_.acting = 0;
    answer_.exact = false;
    return answer_;
}

const LeastConstraint& LeastConstraintSolver::solve(const Vector6& wanted) noexcept {
    answer_ = {};
    const Vector6 y = L_.transpose() * wanted;
    if (!y.allFinite()) {
        return give_up();
    }
    start(y);
    double size = y.norm();
    for (std::size_t k = 0; k < n_; ++k) {
        size = std::max(size, std::isfinite(least_[k]) ? std::abs(least_[k]) : 0.0);
    }
    double tolerance = kTouches * size;
    Vector6 at = nearest(y, acting_.force);
    const int most = kRoundsAtLeast + kRoundsPerContact * static_cast<int>(n_);
    for (std::size_t worst = find_worst(at, tolerance); worst != kNone;
         worst = find_worst(at, tolerance)) {
        const double missed = least_[worst] - row(worst).dot(at);
        if (answer_.rounds > most) {
            return give_up();
        }
        if (2 * answer_.rounds > most && missed <= kCycles * size) {
            tolerance = 2.0 * missed;
            continue;
        }
        const Acting before = acting_;
        double error = 0.0;
        if (!take(worst, size, at, error)) {
            if (missed > error * size) {
                return give_up();
            }
            acting_ = before;          // some may have ceased to act in vain
            tolerance = 2.0 * missed;  // it follows from those that act, but for the rows' error
        }
        // By the contacts that act alone, so that no rounding of the way is kept.
        at = nearest(y, acting_.force);
        acting_.force = acting_.force.cwiseMax(0.0);
    }
    answer_.acting = acting_.n;
    if (acting_.n == 0) {
        answer_.acceleration = wanted;
        return answer_;
    }
    answer_.acceleration = solve_lower_transposed(L_, at);
    answer_.force = L_ * (at - y);
    return answer_;
}

double LeastConstraintSolver::force_N(std::size_t k) const noexcept {
    for (int i = 0; i < acting_.n; ++i) {
        if (acting_.which[static_cast<std::size_t>(i)] == k) {
            return acting_.force[i] / length_[k];
        }
    }
    return 0.0;
}

}  // namespace fulcrum
