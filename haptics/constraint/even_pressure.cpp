#include "haptics/constraint/even_pressure.h"

#include "haptics/math/dense.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double kHeldShare = 1.0e-9;     // of all springs
constexpr double kEvenSettled = 1.0e-10;  // of the wrench: what is left over
constexpr int kMostEvenRounds = 32;
constexpr int kMostEvenHalvings = 30;
constexpr double kFalls = 1.0e-4;  // of what the slope promises (Armijo)

}  // namespace

EvenPressure::EvenPressure(std::size_t max_contacts, double reach_m)
    : reach_m_(reach_m), rows_(max_contacts), weights_(max_contacts), forces_(max_contacts) {}

bool EvenPressure::add(const Vector3& arm_W, const Vector3& normal_W, double weight) noexcept {
    Vector6 row;
    row << normal_W, arm_W.cross(normal_W) / reach_m_;
    if (n_ == rows_.size() || !row.allFinite() || !(weight >= 0.0) || !std::isfinite(weight)) {
        return false;
    }
    rows_[n_] = row;
    weights_[n_] = weight;
    forces_[n_++] = 0.0;
    return true;
}

EvenPressure::Look EvenPressure::look(const Vector6& sunk, const Vector6& wanted) const noexcept {
    Look seen;
    seen.slope = held_ * sunk - wanted;
    seen.value = 0.5 * held_ * sunk.squaredNorm() - wanted.dot(sunk);
    seen.springs.diagonal().setConstant(held_);
    for (std::size_t k = 0; k < n_; ++k) {
        const double deep = rows_[k].dot(sunk);
        if (deep > 0.0) {
            seen.slope += weights_[k] * deep * rows_[k];
            seen.springs += (weights_[k] * rows_[k]) * rows_[k].transpose();
            seen.value += 0.5 * weights_[k] * deep * deep;
        }
    }
    return seen;
}

double EvenPressure::find_value(const Vector6& sunk, const Vector6& wanted) const noexcept {
    double value = 0.5 * held_ * sunk.squaredNorm() - wanted.dot(sunk);
    for (std::size_t k = 0; k < n_; ++k) {
        const double deep = std::max(rows_[k].dot(sunk), 0.0);
        value += 0.5 * weights_[k] * deep * deep;
    }
    return value;
}

bool EvenPressure::solve(const Vector6& wrench) noexcept {
    std::fill_n(forces_.begin(), n_, 0.0);
    left_over_ = 0.0;
    Vector6 wanted = wrench;
    wanted.tail<3>() /= reach_m_;
    const double size = wanted.norm();
    // As if all pressed, to begin with.
    Matrix6 springs = Matrix6::Zero();
    for (std::size_t k = 0; k < n_; ++k) {
        springs += (weights_[k] * rows_[k]) * rows_[k].transpose();
    }
    held_ = kHeldShare * springs.trace();
    if (!(size > 0.0) || !std::isfinite(size) || !(held_ > 0.0)) {
        return false;
    }
    wanted /= size;
    springs.diagonal() += Vector6::Constant(held_);
    Vector6 sunk = solve_cholesky(springs, wanted);
    Look seen = look(sunk, wanted);
    for (int i = 0; i < kMostEvenRounds && seen.slope.norm() > kEvenSettled; ++i) {
        const Vector6 step = solve_cholesky(seen.springs, seen.slope);
        const double promised = step.dot(seen.slope);
        double share = 1.0;
        for (int h = 0; h < kMostEvenHalvings && find_value(sunk - share * step, wanted) >
                                                     seen.value - kFalls * share * promised;
             ++h) {
            share *= 0.5;
        }
        sunk -= share * step;
        seen = look(sunk, wanted);
    }
    if (!sunk.allFinite()) {
        return false;
    }
    for (std::size_t k = 0; k < n_; ++k) {
        forces_[k] = size * weights_[k] * std::max(rows_[k].dot(sunk), 0.0);
    }
    left_over_ = (seen.slope - held_ * sunk).norm();
    return true;
}

}  // namespace fulcrum
