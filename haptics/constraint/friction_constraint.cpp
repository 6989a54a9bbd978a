#include "haptics/constraint/friction_constraint.h"

#include "haptics/constraint/complementarity.h"
#include "haptics/constraint/contact_problem.h"
#include "haptics/math/dense.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double kCompliance = 1.0e-3;  // of a contact's weight, at first
constexpr double kLeastFrictionCompliance = 1.0e-8;
constexpr double kStiffens = 10.0;  // times, after a round
constexpr double kSlow = 0.1;       // that left so much of what it was off
constexpr double kEnough = 0.1;     // of what a round was off: as exact the next one is
constexpr int kMostFrictionRounds = 30;
constexpr int kMostSteps = 400;             // linear systems
constexpr std::size_t kMostLooks = 100000;  // at a contact, 20 ns each
constexpr int kDampedRounds = 10;           // from then on bounds go half of their way
constexpr int kMostFollowing = 12;          // whole steps of a round
constexpr int kMostHeld = 40;               // searched steps of a round
constexpr int kMostFrictionHalvings = 30;
constexpr double kMostDefect =
    1.0e-9;  // of an exact answer: rounding leaves a tenth of that where contacts are stiffest
constexpr double kFlat = 0.3;       // of the slope along a step: left where the search ends
constexpr double kBalanced = 0.02;  // of the largest that is wanted: farther off is no answer

}  // namespace

bool FrictionConstraintSolver::set_inertia(double mass_kg, const Matrix3& inertia_W) noexcept {
    const std::optional<Matrix3> factor = compute_cholesky(inertia_W);
    if (!(mass_kg > 0.0) || !std::isfinite(mass_kg) || !inertia_W.allFinite() || !factor) {
        return false;
    }
    L_.setZero();
    L_.diagonal().head<3>().setConstant(std::sqrt(mass_kg));
    L_.bottomRightCorner<3, 3>() = *factor;
    per_root_mass_ = 1.0 / L_(0, 0);
    const Matrix3 lower = L_.bottomRightCorner<3, 3>();
    per_root_inertia_ = lower.inverse();
    return true;
}

bool FrictionConstraintSolver::add(const Vector3& arm_W, const Vector3& normal_W, double least,
                                   double friction, const Vector3& carried_W) noexcept {
    if (n_ == contacts_.size() || !arm_W.allFinite() || !normal_W.allFinite() ||
        !carried_W.allFinite() || !std::isfinite(least) || !std::isfinite(friction) ||
        !(friction >= 0.0)) {
        return false;
    }
    Contact& contact = contacts_[n_];
    contact.axes_W = make_contact_axes(normal_W);
    for (Index i = 0; i < 3; ++i) {
        const Vector3 axis_W = contact.axes_W.col(i);
        contact.J.col(i) << per_root_mass_ * axis_W, per_root_inertia_ * arm_W.cross(axis_W);
    }
    contact.weight = contact.J.squaredNorm() / 3.0;
    if (!std::isnormal(contact.weight)) {
        return false;
    }
    contact.asked = contact.axes_W.transpose() * carried_W;
    contact.asked.x() = least;
    contact.friction = friction;
    ++n_;
    return true;
}

void FrictionConstraintSolver::prepare(double size) noexcept {
    const double grown = size_ / size;
    const bool remembers = n_remembered_ == n_ && std::isfinite(grown);
    last_ = remembers ? Vector6(last_ * grown) : wanted_;
    for (std::size_t k = 0; k < n_; ++k) {
        Contact& contact = contacts_[k];
        contact.stiffness = 1.0 / (kCompliance * contact.weight);
        contact.least = contact.asked / size;
        contact.l = remembers ? Vector3(contact.l * grown) : Vector3(Vector3::Zero());
        contact.bound = contact.friction * contact.l.x();
    }
    n_remembered_ = n_;
    size_ = size;
}

Vector6 FrictionConstraintSolver::find_defect(const Vector6& y, bool follows) noexcept {
    Vector6 r = y - wanted_;
    n_looks_ += n_;
    for (std::size_t k = 0; k < n_; ++k) {
        Contact& c = contacts_[k];
        c.q = c.l - c.stiffness * (c.J.transpose() * y - c.least);
        c.f = {std::max(c.q.x(), 0.0), c.q.y(), c.q.z()};
        const double bound = follows ? c.friction * c.f.x() : c.bound;
        const double along = std::sqrt(c.q.y() * c.q.y() + c.q.z() * c.q.z());
        if (along > bound) {
            c.f.tail<2>() *= bound / along;
        }
        r -= c.J * c.f;
    }
    return r;
}

// Of the defect where q is.
Matrix6 FrictionConstraintSolver::find_slope(bool follows) const noexcept {
    Matrix6 H = Matrix6::Identity();
    for (std::size_t k = 0; k < n_; ++k) {
        const Contact& c = contacts_[k];
        const bool presses = c.q.x() > 0.0;
        const double bound = follows ? c.friction * c.f.x() : c.bound;
        if (!presses && !(bound > 0.0)) {
            continue;
        }
        Matrix3 P = Matrix3::Zero();
        P(0, 0) = presses ? 1.0 : 0.0;
        const double along = std::sqrt(c.q.y() * c.q.y() + c.q.z() * c.q.z());
        if (along <= bound) {
            P(1, 1) = P(2, 2) = 1.0;
        } else {
            const Vector2 d(c.q.y() / along, c.q.z() / along);
            P.bottomRightCorner<2, 2>() =
                (bound / along) * (Matrix2::Identity() - d * d.transpose());
            if (follows) {
                P.bottomLeftCorner<2, 1>() = c.friction * d;
            }
        }
        const Axes pushed = c.stiffness * c.J * P;
        H += pushed * c.J.transpose();
    }
    return H;
}

// Whole steps with bounds that follow; false, and nothing changed, where they do not end.
bool FrictionConstraintSolver::follow(Vector6& y) noexcept {
    Vector6 at = y;
    Vector6 r = find_defect(at, true);
    for (int i = 0; i < kMostFollowing && has_time(); ++i) {
        if (r.norm() <= 0.1 * kTolerance) {
            y = at;
            return true;
        }
        ++answer_.rounds;
        at -= solve_lu(find_slope(true), r);
        r = find_defect(at, true);
        if (!r.allFinite()) {
            return false;
        }
    }
    return false;
}

// Down the convex function, its bounds held; the defect that is left.
double FrictionConstraintSolver::hold(Vector6& y, double enough) noexcept {
    Vector6 r = find_defect(y, false);
    for (int i = 0; i < kMostHeld && r.norm() > enough && has_time(); ++i) {
        ++answer_.rounds;
        const Vector6 step = -solve_cholesky(find_slope(false), r);
        const double first = step.dot(r);
        double low = 0.0;
        double high = 1.0;
        double share = 1.0;
        Vector6 next = find_defect(y + step, false);
        for (int j = 0; j < kMostFrictionHalvings && has_time() &&
                        std::abs(step.dot(next)) > kFlat * std::abs(first);
             ++j) {
            (step.dot(next) > 0.0 ? high : low) = share;
            if (low == 1.0) {
                break;
            }
            share = 0.5 * (low + high);
            next = find_defect(y + share * step, false);
        }
        y += share * step;
        r = next;
    }
    return r.norm();
}

FrictionConstraintSolver::Miss FrictionConstraintSolver::correct(double share) noexcept {
    Miss worst;
    for (std::size_t k = 0; k < n_; ++k) {
        Contact& c = contacts_[k];
        const double bound = c.friction * c.f.x();
        const double along = std::sqrt(c.q.y() * c.q.y() + c.q.z() * c.q.z());
        const double drag = c.f.tail<2>().norm();
        const double missed = std::abs(std::min(along, bound) - drag);
        const double length = std::sqrt(c.weight);
        worst.way = take_worse(worst.way, (c.f - c.l).norm() / (c.stiffness * length));
        worst.bound = take_worse(worst.bound, missed * length);
        c.l = c.f;
        c.bound += share * (bound - c.bound);
    }
    return worst;
}

bool FrictionConstraintSolver::iterate(Vector6& y) noexcept {
    Miss miss{1.0, 1.0};
    double compliance = kCompliance;
    Vector6 balanced = Vector6::Zero();  // where the forces l of the last whole round hold it
    for (int i = 0; i < kMostFrictionRounds && answer_.rounds < kMostSteps && has_time(); ++i) {
        // What is left of the balance of forces counts too: contacts may keep their bounds and yet not hold what is held.
        const double defect =
            follow(y) ? 0.0 : hold(y, kEnough * std::max(miss.most(), kTolerance));
        if (!has_time()) {
            break;
        }
        balanced = y;
        const Miss before = miss;
        miss = correct(i < kDampedRounds ? 1.0 : 0.5);
        if (miss.most() <= kTolerance && defect <= kMostDefect) {
            return true;
        }
        const bool is_slow = i > 0 && miss.way > kSlow * before.way && miss.way > miss.bound;
        if (is_slow && compliance > kLeastFrictionCompliance) {
            compliance /= kStiffens;
            for (std::size_t k = 0; k < n_; ++k) {
                contacts_[k].stiffness *= kStiffens;
            }
        }
    }
    y = balanced;
    for (std::size_t k = 0; k < n_; ++k) {
        contacts_[k].f = contacts_[k].l;
    }
    return false;
}

Vector6 FrictionConstraintSolver::sum_forces() const noexcept {
    Vector6 sum = Vector6::Zero();
    for (std::size_t k = 0; k < n_; ++k) {
        sum += contacts_[k].J * contacts_[k].f;
    }
    return sum;
}

bool FrictionConstraintSolver::has_time() const noexcept {
    return n_looks_ < kMostLooks;
}

void FrictionConstraintSolver::forget() noexcept {
    last_.setZero();
    for (std::size_t k = 0; k < n_; ++k) {
        contacts_[k].l.setZero();
        contacts_[k].f.setZero();
    }
}

// Cut short far from any balance, what contacts push with is no force at all: the tool stays, held by all that was wanted of it.
void FrictionConstraintSolver::stay() noexcept {
    forget();
    answer_.exact = false;
    answer_.acting = static_cast<int>(n_);
    answer_.force = -L_ * wanted_ * size_;
}

const LeastConstraint& FrictionConstraintSolver::solve(const Vector6& wanted) noexcept {
    answer_ = {};
    n_looks_ = 0;
    const Vector6 y_u = L_.transpose() * wanted;
    double size = y_u.norm();  // no number where any is none
    for (std::size_t k = 0; k < n_; ++k) {
        size = std::max(size, contacts_[k].asked.norm() / std::sqrt(contacts_[k].weight));
    }
    if (!std::isnormal(size)) {
        // Nothing is wanted, or what is wanted is no number.
        answer_.exact = size == 0.0;
        forget();
        return answer_;
    }
    wanted_ = y_u / size;
    prepare(size);
    // From where the last solve ended its forces make sense.
    Vector6 y = last_;
    answer_.exact = iterate(y);
    if (!answer_.exact && !((y - wanted_ - sum_forces()).norm() <= kBalanced)) {
        stay();
        return answer_;
    }
    last_ = y;
    for (std::size_t k = 0; k < n_; ++k) {
        answer_.acting += contacts_[k].f.x() > 0.0 ? 1 : 0;
    }
    if (answer_.acting == 0) {
        answer_.acceleration = wanted;
        return answer_;
    }
    answer_.acceleration = solve_lower_transposed(L_, y) * size;
    // What hand and objects feel is one force: that of the contacts, where it is not the way's.
    answer_.force = L_ * (answer_.exact ? Vector6(y - wanted_) : sum_forces()) * size;
    return answer_;
}

Vector3 FrictionConstraintSolver::force_W(std::size_t k) const noexcept {
    return contacts_[k].axes_W * contacts_[k].f * size_;
}

}  // namespace fulcrum
