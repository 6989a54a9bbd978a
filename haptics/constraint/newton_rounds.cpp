// The rounds of newton_solver.h: when impulses become multipliers, and when the shifts follow the slip.
#include "haptics/constraint/newton_solver.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double kLeastStiffening = 1.0e-9;  // below it rounding of u is felt in p
constexpr double kSlowRound = 0.1;           // a round that leaves more of the residual is slow
constexpr int kMostIdle = 3;      // steps with s following that gain nothing, before it is held
constexpr int kMostAttempts = 3;  // to let s follow
constexpr double kGain = 0.5;
constexpr double kNearlySmallest = 0.1;  // E's slope against the residual when l is corrected

}  // namespace

// Something was pressed and nothing slid: what did not slip will hardly begin to, and E with its shifts held is the law itself.
bool NewtonSolver::sticks(const ContactProblem& problem) const noexcept {
    const auto contacts = problem.contacts();
    return std::any_of(contacts_.begin(), contacts_.end(),
                       [](const Contact& contact) { return contact.state.pressed; }) &&
           std::none_of(contacts.begin(), contacts.end(),
                        [](const ContactConstraint& c) { return c.slides; });
}

void NewtonSolver::start_multipliers(const ContactProblem& problem) noexcept {
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        Contact& contact = contacts_[i];
        contact.now = {contact.p, problem.contacts()[i].slides ? find_lift(contact) : 0.0};
    }
    for (Row& row : rows_) {
        row.l = row.p;
    }
}

void NewtonSolver::update_multipliers() noexcept {
    for (Contact& contact : contacts_) {
        contact.now = {contact.p, find_lift(contact)};
    }
    for (Row& row : rows_) {
        row.l = row.p;
    }
}

void NewtonSolver::begin_attempt() noexcept {
    coulomb_ = true;
    n_idle_ = 0;
    ++n_attempts_;
    attempt_fits_ = HUGE_VAL;
    before_.copy_velocities(motion_, n_bodies_);
    for (Contact& contact : contacts_) {
        contact.before = contact.now;
    }
    for (Row& row : rows_) {
        row.l_before = row.l;
    }
}

void NewtonSolver::end_attempt() noexcept {
    coulomb_ = false;
    built_ = false;
    motion_.copy_velocities(before_, n_bodies_);
    for (Contact& contact : contacts_) {
        contact.now = contact.before;
    }
    for (Row& row : rows_) {
        row.l = row.l_before;
    }
}

bool NewtonSolver::correct(const ContactProblem& problem, const Fit& fit,
                           double tolerance) noexcept {
    if (coulomb_) {
        // It goes on while each few steps gain.
        const double fits = std::max(fit.residual, fit.defect);
        n_idle_ = fits < kGain * attempt_fits_ ? 0 : n_idle_ + 1;
        attempt_fits_ = std::min(attempt_fits_, fits);
        if (n_idle_ > kMostIdle) {
            end_attempt();
            return true;
        }
    }
    if (fit.defect > kNearlySmallest * std::max(fit.residual, tolerance)) {
        return false;
    }
    const bool lifts = !coulomb_ && fit.shift > kNearlySmallest * fit.residual;
    if (lifts && n_attempts_ == kMostAttempts) {
        // Impulses that fit the shift as it is are the answer when E is at its smallest.
        given_up_ = fit.defect <= kNearlySmallest * tolerance;
        return false;
    }
    update_multipliers();
    if (lifts) {
        begin_attempt();
    } else if (fit.residual > kSlowRound * residual_before_ && eps_ > kLeastStiffening) {
        set_stiffness(problem, std::max(kSlowRound * eps_, kLeastStiffening));
    }
    residual_before_ = fit.residual;
    return true;
}

}  // namespace fulcrum
