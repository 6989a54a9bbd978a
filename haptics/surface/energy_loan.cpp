#include "haptics/surface/energy_loan.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {

void EnergyLoan::allow(double limit_J, double dt_s) noexcept {
    const double wanted_J = limit_J > 0.0 && std::isfinite(limit_J) ? limit_J : 0.0;
    const double kept = std::clamp(1.0 - dt_s / kLoanMemory_s, 0.0, 1.0);
    limit_J_ = std::max(wanted_J, kept * limit_J_);
}

void EnergyLoan::settle() noexcept {
    limit_J_ = 0.0;
    owed_J_ = 0.0;
    force_W_.setZero();
}

ElasticForce EnergyLoan::step(const Vector3& next_W, const Vector3& motion_W) noexcept {
    ElasticForce counted{next_W, force_W_};
    const double given_J = force_W_.dot(motion_W);
    const double square = motion_W.squaredNorm();
    if (std::isfinite(given_J) && square > 0.0) {
        owed_J_ = std::max(owed_J_ + given_J, -limit_J_);
        const double beyond_J = std::max(owed_J_ - limit_J_, 0.0);
        owed_J_ -= beyond_J;
        counted.held_W -= (2.0 * beyond_J / square) * motion_W;
    }
    force_W_ = next_W;
    return counted;
}

}  // namespace fulcrum
