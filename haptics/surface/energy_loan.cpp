#include "haptics/surface/energy_loan.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {

void EnergyLoan::allow(double limit_J, double dt_s) noexcept {
    const double wanted_J =
        limit_J > 0.0 && std::isfinite(limit_J) ? settings_.share * limit_J : 0.0;
    const double kept = std::clamp(1.0 - dt_s / kLoanMemory_s, 0.0, 1.0);
    limit_J_ = std::max(wanted_J, kept * limit_J_);
    owed_J_ *= std::clamp(1.0 - dt_s / settings_.debt_memory_s, 0.0, 1.0);
}

void EnergyLoan::leave(double dt_s) noexcept {
    allow(0.0, dt_s);
    force_W_.setZero();
}

void EnergyLoan::settle() noexcept {
    limit_J_ = 0.0;
    owed_J_ = 0.0;
    force_W_.setZero();
}

ElasticForce EnergyLoan::step(const Vector3& next_W, const Vector3& motion_W) noexcept {
    const ElasticForce counted{next_W, force_W_ - lend(force_W_.dot(motion_W), motion_W, motion_W)};
    force_W_ = next_W;
    return counted;
}

ElasticForce EnergyLoan::step_evenly(const Vector3& next_W, const Vector3& motion_W,
                                     const Vector3& against_W) noexcept {
    const double given_J = 0.5 * (force_W_ + next_W).dot(against_W);
    if (owed_J_ > 0.0) {
        owed_J_ = std::max(owed_J_ - kUnfelt_N * against_W.norm(), 0.0);
    }
    const ElasticForce counted{next_W, next_W - lend(given_J, motion_W, against_W)};
    force_W_ = next_W;
    return counted;
}

// Counts what was given on the way against the surface; the force that would have given what goes beyond the limit, twice. Of a hand
// that hardly moves upon a surface that does it is no more than it was of the surface's way.
Vector3 EnergyLoan::lend(double given_J, const Vector3& motion_W,
                         const Vector3& against_W) noexcept {
    const double square = motion_W.norm() * std::max(motion_W.norm(), against_W.norm());
    if (!std::isfinite(given_J) || !(square > 0.0)) {
        return Vector3::Zero();
    }
    owed_J_ = std::max(owed_J_ + given_J, -limit_J_);
    const double beyond_J = std::min(std::max(owed_J_ - limit_J_, 0.0), std::max(given_J, 0.0));
    owed_J_ -= beyond_J;
    return (2.0 * beyond_J / square) * motion_W;
}

}  // namespace fulcrum
