#include "haptics/surface/energy_loan.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

// The force that would have given what goes beyond the limit, twice. Of a hand that hardly moves upon a surface that does it is no more
// than it was of the surface's way.
Vector3 find_force(double beyond_J, const Vector3& motion_W, const Vector3& against_W) noexcept {
    const double square = motion_W.norm() * std::max(motion_W.norm(), against_W.norm());
    return square > 0.0 ? Vector3((2.0 * beyond_J / square) * motion_W) : Vector3(Vector3::Zero());
}

// Of a hand that stands still nothing is given.
double find_given_J(const Vector3& force_W, const Vector3& motion_W,
                    const Vector3& against_W) noexcept {
    return motion_W.isZero(0.0) ? 0.0 : force_W.dot(against_W);
}

Wrench find_mean(const Wrench& a, const Wrench& b) noexcept {
    return {0.5 * (a.force + b.force), 0.5 * (a.torque + b.torque)};
}

}  // namespace

void LoanAccount::allow(double limit_J, double dt_s) noexcept {
    const double wanted_J =
        limit_J > 0.0 && std::isfinite(limit_J) ? settings_.share * limit_J : 0.0;
    const double kept = std::clamp(1.0 - dt_s / kLoanMemory_s, 0.0, 1.0);
    limit_J_ = std::max(wanted_J, kept * limit_J_);
    owed_J_ *= std::clamp(1.0 - dt_s / settings_.debt_memory_s, 0.0, 1.0);
}

void LoanAccount::forgive(double energy_J) noexcept {
    if (owed_J_ > 0.0 && energy_J > 0.0 && std::isfinite(energy_J)) {
        owed_J_ = std::max(owed_J_ - energy_J, 0.0);
    }
}

void LoanAccount::owe(double given_J) noexcept {
    owed_J_ = std::max(owed_J_ + given_J, -limit_J_);
}

bool LoanAccount::may_give(double given_J) noexcept {
    if (!(given_J <= 0.0 || owed_J_ + given_J <= limit_J_)) {
        return false;
    }
    owe(given_J);
    return true;
}

double LoanAccount::take(double given_J, double paid_J) noexcept {
    if (!std::isfinite(given_J)) {
        return 0.0;
    }
    owe(given_J);
    forgive(paid_J);
    const double beyond_J = std::min(std::max(owed_J_ - limit_J_, 0.0), std::max(given_J, 0.0));
    owed_J_ -= beyond_J;
    return beyond_J;
}

void EnergyLoan::leave(double dt_s) noexcept {
    account_.allow(0.0, dt_s);
    force_W_.setZero();
}

void EnergyLoan::settle() noexcept {
    account_.settle();
    force_W_.setZero();
}

ElasticForce EnergyLoan::step(const Vector3& next_W, const Vector3& motion_W) noexcept {
    const double beyond_J = account_.take(force_W_.dot(motion_W));
    const ElasticForce counted{next_W, force_W_ - find_force(beyond_J, motion_W, motion_W)};
    force_W_ = next_W;
    return counted;
}

ElasticForce EnergyLoan::step_evenly(const Vector3& next_W, const Vector3& motion_W,
                                     const Vector3& against_W, double paid_J) noexcept {
    account_.forgive(kUnfelt_N * against_W.norm());
    const double beyond_J =
        account_.take(find_given_J(0.5 * (force_W_ + next_W), motion_W, against_W), paid_J);
    const ElasticForce counted{next_W, next_W - find_force(beyond_J, motion_W, against_W)};
    force_W_ = next_W;
    return counted;
}

void WrenchLoan::leave(double dt_s) noexcept {
    account_.allow(0.0, dt_s);
    wrench_W_ = {};
}

void WrenchLoan::settle() noexcept {
    account_.settle();
    wrench_W_ = {};
}

Wrench WrenchLoan::lend(const Wrench& wrench_W, const Way& motion_W,
                        const Way& against_W) noexcept {
    const double by_force_J = find_given_J(wrench_W.force, motion_W.shift_W, against_W.shift_W);
    const double by_torque_J = find_given_J(wrench_W.torque, motion_W.turn_W, against_W.turn_W);
    const double beyond_J = account_.take(by_force_J + by_torque_J);
    if (!(beyond_J > 0.0)) {
        return {};
    }
    const double share =
        std::max(by_force_J, 0.0) / (std::max(by_force_J, 0.0) + std::max(by_torque_J, 0.0));
    return {find_force(share * beyond_J, motion_W.shift_W, against_W.shift_W),
            find_force((1.0 - share) * beyond_J, motion_W.turn_W, against_W.turn_W)};
}

WrenchLoan::Counted WrenchLoan::step(const Wrench& next_W, const Way& motion_W) noexcept {
    const Wrench lent = lend(wrench_W_, motion_W, motion_W);
    const Counted counted{{next_W.force, wrench_W_.force - lent.force},
                          {next_W.torque, wrench_W_.torque - lent.torque}};
    wrench_W_ = next_W;
    return counted;
}

WrenchLoan::Counted WrenchLoan::step_evenly(const Wrench& next_W, const Way& motion_W,
                                            const Way& against_W) noexcept {
    account_.forgive(kUnfelt_N *
                     (against_W.shift_W.norm() + kUnfeltAt_m * against_W.turn_W.norm()));
    const Wrench lent = lend(find_mean(wrench_W_, next_W), motion_W, against_W);
    const Counted counted{{next_W.force, next_W.force - lent.force},
                          {next_W.torque, next_W.torque - lent.torque}};
    wrench_W_ = next_W;
    return counted;
}

}  // namespace fulcrum
