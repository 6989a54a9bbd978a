#include "haptics/coupling/passivity.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double kDampingShare = 0.125;  // of m / T: see the head of passivity.h
// What rounding makes of a passive scene is left alone; it would move the bare handle at 0.2 mm/s.
constexpr double kIgnored_J = 1.0e-9;

// Far above all that is felt, and far enough below infinity that no product of two overflows.
constexpr double kAbsurd = 1.0e9;

// A brake that is held for three rounds in all has u = 3/8: a bare handle comes to rest and hardly further.
constexpr double kHeldRounds = 2.0;
constexpr double kHalfRound = 0.5;  // rounds do not come to the instant

// The brake takes from a surface's push and makes no pull of it.
Vector3 without_pull(const Vector3& brake, const PortRound& round) noexcept {
    const double pull = std::min(round.push + brake.dot(round.normal), 0.0);
    return brake - pull * round.normal;
}

bool is_sane(const Vector3& v) noexcept {
    return v.allFinite() && v.cwiseAbs().maxCoeff() < kAbsurd;
}

bool is_usable(const PortRound& round) noexcept {
    return is_sane(round.motion) && is_sane(round.asked) && is_sane(round.elastic.now_W) &&
           is_sane(round.elastic.held_W) && std::abs(round.kink_J) < kAbsurd &&
           is_sane(round.normal) && std::abs(round.push) < kAbsurd && round.dt_s > 0.0 &&
           std::isfinite(round.dt_s);
}

}  // namespace

double compute_kink_J(const ContactSpring& before, const ContactSpring& now,
                      const Vector3& motion) noexcept {
    const bool begins = before.energy_J == 0.0 && now.energy_J > 0.0;
    const bool ends = before.energy_J > 0.0 && now.energy_J == 0.0;
    if (begins) {
        return std::max(-now.energy_J - 0.5 * now.force.dot(motion), 0.0);
    }
    return ends ? std::min(before.energy_J - 0.5 * before.force.dot(motion), 0.0) : 0.0;
}

PassivityController::PassivityController(const PassivitySettings& settings,
                                         const PortLimits& limits) noexcept
    : headroom_J_(settings.headroom_J),
      memory_s_(settings.memory_s),
      largest_damping_(kDampingShare * limits.inertia / limits.period_s),
      device_damping_(limits.device_damping),
      hold_s_((kHeldRounds + kHalfRound) * limits.period_s) {}

void PassivityController::reset() noexcept {
    follows_ = false;
    energy_.excess_J = 0.0;
    waited_s_ = 0.0;
    leak_J_ = 0.0;
    elastic_.setZero();
    brake_.setZero();
    asked_.setZero();
    applied_.setZero();
    share_ = 0.0;
}

Vector3 PassivityController::step(const PortRound& round) noexcept {
    if (!is_usable(round)) {
        reset();
        return Vector3::Zero();
    }
    const double since_s = waited_s_ + round.dt_s;
    waited_s_ = round.is_new ? 0.0 : since_s;
    if (follows_) {
        observe(round, since_s);
    }
    follows_ = true;
    elastic_ = round.elastic.now_W;
    brake_ = round.is_new ? compute_brake(round, since_s) : hold_brake(round);
    asked_ = round.asked + brake_;
    return brake_;
}

void PassivityController::observe(const PortRound& round, double since_s) noexcept {
    // What the hand was given, and what the ideal scene would have given it.
    const Vector3& d = round.motion;
    const double given_J = applied_.dot(d);
    const Vector3 change = round.elastic.held_W - elastic_;
    leak_J_ = -0.5 * share_ * change.dot(d);
    const double ideal_J = share_ * (elastic_.dot(d) + round.kink_J) - leak_J_;
    const double friction_J = device_damping_ * d.squaredNorm() / since_s;
    // The budget: it forgets, and dampers earn no more than the headroom.
    const double kept = std::max(1.0 - round.dt_s / memory_s_, 0.0);
    energy_.excess_J =
        std::max(kept * energy_.excess_J + (given_J - ideal_J - friction_J), -headroom_J_);
    energy_.peak_J = std::max(energy_.peak_J, energy_.excess_J);
    energy_.braked_J -= share_ * brake_.dot(d);
}

Vector3 PassivityController::compute_brake(const PortRound& round, double since_s) const noexcept {
    const Vector3& d = round.motion;
    const double square = d.squaredNorm();
    const double damped_J = (round.asked - round.elastic.now_W).dot(d);
    const double coming_J = energy_.excess_J + damped_J + std::max(leak_J_, 0.0);
    if (!(coming_J > kIgnored_J) || !(square > 0.0)) {
        return Vector3::Zero();
    }
    const double damping = std::min(coming_J * since_s / square, largest_damping_);
    return without_pull(d * (-damping / since_s), round);
}

Vector3 PassivityController::hold_brake(const PortRound& round) const noexcept {
    return waited_s_ <= hold_s_ ? without_pull(brake_, round) : Vector3(Vector3::Zero());
}

void PassivityController::sent(const Vector3& applied) noexcept {
    applied_ = is_sane(applied) ? applied : Vector3(Vector3::Zero());
    const double square = asked_.squaredNorm();
    share_ = square > 0.0 ? std::clamp(applied_.dot(asked_) / square, 0.0, 1.0) : 1.0;
}

}  // namespace fulcrum
