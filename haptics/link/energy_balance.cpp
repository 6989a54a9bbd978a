#include "haptics/link/energy_balance.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double kSmallestSquare = 1.0e-24;  // of a motion or a force: nothing happened

constexpr double kBorne_J =
    5.0e-4;  // a debt that the brake pays alone; with twice that nothing more is given

constexpr double kLongestMean_s = 0.05;  // of the force along a motion that shows late

}  // namespace

Vector3 EnergyBalance::find_mean_force(const Vector3& force, const Vector3& motion,
                                       double dt_s) noexcept {
    if (motion.isZero(0.0)) {
        // No longer than the longest: what is older counts less.
        const double room_s = std::max(kLongestMean_s - dt_s, 0.0);
        const double kept = waited_s_ > room_s ? room_s / waited_s_ : 1.0;
        impulse_ = impulse_ * kept + force * dt_s;
        waited_s_ = waited_s_ * kept + dt_s;
        return force;
    }
    const Vector3 mean =
        waited_s_ > 0.0 ? Vector3((impulse_ + force * dt_s) / (waited_s_ + dt_s)) : force;
    impulse_.setZero();
    waited_s_ = 0.0;
    return mean;
}

void EnergyBalance::step(const Vector3& force, const Vector3& motion, double heard_J,
                         double dt_s) noexcept {
    if (!force.allFinite() || !motion.allFinite() || !std::isfinite(heard_J) || !(dt_s > 0.0)) {
        return;
    }
    const double sign = side_ == LinkSide::scene ? 1.0 : -1.0;
    const double gave_J =
        std::min(sign * force.dot(motion), sign * find_mean_force(force, motion, dt_s).dot(motion));
    const double news_J = std::max(heard_J - heard_J_, 0.0);
    heard_J_ = std::max(heard_J, heard_J_);
    // Credit is forgotten, a debt never; and what is put in here pays it first, which the other side is not told: a brake that takes back
    // what the link gave is no new energy.
    const double kept = balance_J_ > 0.0 ? std::max(1.0 - dt_s / settings_.memory_s, 0.0) : 1.0;
    const double paid_J = std::min(std::max(gave_J, 0.0), std::max(-balance_J_, 0.0));
    gave_J_ += std::max(gave_J, 0.0) - paid_J;
    balance_J_ = std::min(balance_J_ * kept + news_J + paid_J - std::max(-gave_J, 0.0),
                          settings_.headroom_J);
    peak_J_ = std::max(peak_J_, -balance_J_);
}

void EnergyBalance::reset() noexcept {
    gave_J_ = 0.0;
    heard_J_ = 0.0;
    balance_J_ = 0.0;
    impulse_.setZero();
    waited_s_ = 0.0;
}

double EnergyBalance::compute_damping(const Vector3& motion, double dt_s,
                                      double most) const noexcept {
    const double square = motion.squaredNorm();
    return balance_J_ < 0.0 && square > kSmallestSquare
               ? std::min(-balance_J_ * dt_s / square, most)
               : 0.0;
}

Vector3 EnergyBalance::hold_back(const Vector3& force, const Vector3& motion) const noexcept {
    const double square = motion.squaredNorm();
    const double to_hand_J = force.dot(motion);
    if (!(balance_J_ < -kBorne_J) || !(square > kSmallestSquare) || !(to_hand_J > 0.0)) {
        return force;
    }
    const double share = std::min((-balance_J_ - kBorne_J) / kBorne_J, 1.0);
    return force - motion * (share * to_hand_J / square);
}

Vector3 EnergyBalance::shift(const Vector3& force, double furthest) noexcept {
    const double square = force.squaredNorm();
    if (!(balance_J_ < 0.0) || !(square > kSmallestSquare)) {
        return Vector3::Zero();
    }
    const double factor = std::min(-balance_J_ / square, furthest / std::sqrt(square));
    balance_J_ += factor * square;
    return force * factor;
}

Vector3 EnergyBalance::shift_back(const Vector3& force, const Vector3& wish, double dt_s) noexcept {
    const double taken_J = -force.dot(wish);  // by the scene, when its hand moves so
    if (!(taken_J > 0.0)) {
        return wish;
    }
    const double lent_J = settings_.lent_W * dt_s;
    const double paid_J = std::min(std::max(balance_J_, 0.0) + lent_J, taken_J);
    balance_J_ -= std::max(paid_J - lent_J, 0.0);
    return wish * (paid_J / taken_J);
}

}  // namespace fulcrum
