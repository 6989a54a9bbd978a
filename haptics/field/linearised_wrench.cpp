#include "haptics/field/linearised_wrench.h"

#include "haptics/math/dense.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double kAbsurd = 1.0e6;  // newtons, metres, N/m: no lesson means this

bool is_sane(const LinearisedWrench& model) noexcept {
    const auto sane = [](const auto& m) {
        return m.allFinite() && m.cwiseAbs().maxCoeff() < kAbsurd;
    };
    return sane(model.force_W) && sane(model.torque_W) && sane(model.at_position_W) &&
           sane(model.at_velocity_W) && sane(model.stiffness_N_per_m) &&
           sane(model.damping_Ns_per_m) && sane(model.torque_stiffness_Nm_per_m);
}

// Scales `value` down to the Frobenius norm `limit` where it is longer; the factor, 1 where it is not.
template <class M>
double shorten(M& value, double limit) noexcept {
    const double size = value.norm();
    if (size > limit) {
        value *= limit / size;
        return limit / size;
    }
    return 1.0;
}

// How many times steeper than allowed an answer is, at least 1; infinite where nothing is allowed.
double compute_excess(const LinearisedWrench& asked,
                      const LinearisedWrenchSettings& settings) noexcept {
    const auto excess = [](const Matrix3& gain, double limit) {
        const double size = gain.norm();
        return size > limit ? size / limit : 1.0;
    };
    return std::max(
        {excess(asked.stiffness_N_per_m, settings.max_stiffness_N_per_m),
         excess(asked.damping_Ns_per_m, settings.max_damping_Ns_per_m),
         excess(asked.torque_stiffness_Nm_per_m, settings.max_torque_stiffness_Nm_per_m)});
}

// Takes the positive eigenvalues out of the symmetric part; the skew part does no work and stays.
bool remove_active_part(Matrix3& damping) noexcept {
    const Matrix3 symmetric = 0.5 * (damping + damping.transpose());
    const SymmetricAxes parts = compute_symmetric_axes_direct(symmetric);
    constexpr double kRounding_Ns_per_m = 1.0e-9;
    if (!(parts.values.maxCoeff() > kRounding_Ns_per_m)) {
        return false;
    }
    const Vector3 kept = parts.values.cwiseMin(0.0);
    damping += parts.axes * kept.asDiagonal() * parts.axes.transpose() - symmetric;
    return true;
}

}  // namespace

Wrench compute_linearised_wrench(const LinearisedWrench& model, const Vector3& position_W,
                                 const Vector3& velocity_W) noexcept {
    const Vector3 away_m = position_W - model.at_position_W;
    const Vector3 faster_m_per_s = velocity_W - model.at_velocity_W;
    Wrench wrench_W{model.force_W, model.torque_W};
    wrench_W.force += model.stiffness_N_per_m * away_m;
    wrench_W.force += model.damping_Ns_per_m * faster_m_per_s;
    wrench_W.torque += model.torque_stiffness_Nm_per_m * away_m;
    return wrench_W;
}

LinearisationNote bound_gains(LinearisedWrench& model,
                              const LinearisedWrenchSettings& settings) noexcept {
    if (!is_sane(model)) {
        return LinearisationNote::refused_not_finite;
    }
    LinearisationNote notes = LinearisationNote::none;
    if (remove_active_part(model.damping_Ns_per_m)) {
        notes = notes | LinearisationNote::active_damping_removed;
    }
    if (shorten(model.stiffness_N_per_m, settings.max_stiffness_N_per_m) < 1.0) {
        notes = notes | LinearisationNote::stiffness_clamped;
    }
    if (shorten(model.damping_Ns_per_m, settings.max_damping_Ns_per_m) < 1.0) {
        notes = notes | LinearisationNote::damping_clamped;
    }
    if (shorten(model.torque_stiffness_Nm_per_m, settings.max_torque_stiffness_Nm_per_m) < 1.0) {
        notes = notes | LinearisationNote::torque_stiffness_clamped;
    }
    return notes;
}

// The newest answer at this place, within the limits and faded by its age.
LinearisedWrenchStage::Plain LinearisedWrenchStage::compute_plain(const Vector3& position_W,
                                                                  const Vector3& velocity_W,
                                                                  double now_s) const noexcept {
    Wrench wrench_W = compute_linearised_wrench(model_, position_W, velocity_W);
    const double force_share = shorten(wrench_W.force, settings_.max_force_N);
    const double torque_share = shorten(wrench_W.torque, settings_.max_torque_Nm);
    const double late = (now_s - model_.stamp_s - settings_.timeout_s) / settings_.timeout_s;
    const double fresh = std::clamp(1.0 - late, 0.0, 1.0);
    return {{fresh * wrench_W.force, fresh * wrench_W.torque},
            fresh * force_share,
            fresh * torque_share};
}

LinearisedWrenchStage::Plain LinearisedWrenchStage::compute_blended(const Vector3& position_W,
                                                                    const Vector3& velocity_W,
                                                                    double now_s) const noexcept {
    if (!has_model_) {
        return {};
    }
    const double left = std::clamp(1.0 - (now_s - accepted_at_s_) / blend_s_, 0.0, 1.0);
    Plain blended = compute_plain(position_W, velocity_W, now_s);
    blended.wrench_W.force += left * offset_W_.force;
    blended.wrench_W.torque += left * offset_W_.torque;
    return blended;
}

void LinearisedWrenchStage::accept(const LinearisedWrench& model, double excess,
                                   const Vector3& position_W, const Vector3& velocity_W,
                                   double now_s) noexcept {
    const Wrench before_W = compute_blended(position_W, velocity_W, now_s).wrench_W;
    model_ = model;
    has_model_ = true;
    accepted_at_s_ = now_s;
    const Wrench plain_W = compute_plain(position_W, velocity_W, now_s).wrench_W;
    offset_W_ = {before_W.force - plain_W.force, before_W.torque - plain_W.torque};
    blend_s_ = excess * excess *
               std::max({settings_.blend_s, offset_W_.force.norm() / kAnswerSlew_N_per_s,
                         offset_W_.torque.norm() / kAnswerSlew_Nm_per_s});
}

Wrench LinearisedWrenchStage::step(const LinearisedWrench& newest, const Vector3& position_W,
                                   const Vector3& velocity_W, double now_s) noexcept {
    hold_elastic(position_W);
    // A stamp from the future waits until it is now: taken over, it would not age, and would keep
    // out the answers that come before it.
    if (newest.stamp_s >= 0.0 && newest.stamp_s > seen_stamp_s_ && newest.stamp_s <= now_s) {
        seen_stamp_s_ = newest.stamp_s;
        LinearisedWrench model = newest;
        notes_ = bound_gains(model, settings_);
        if (!has(notes_, LinearisationNote::refused_not_finite)) {
            accept(model, compute_excess(newest, settings_), position_W, velocity_W, now_s);
        }
    }
    last_ = compute_blended(position_W, velocity_W, now_s);
    elastic_force_.now_W = last_.wrench_W.force;
    elastic_force_.now_W -= last_.force_share * (model_.damping_Ns_per_m * velocity_W);
    elastic_torque_.now_W = last_.wrench_W.torque;
    return last_.wrench_W;
}

// Where the hand's own motion brings the former answer's elastic part, nothing else changed.
void LinearisedWrenchStage::hold_elastic(const Vector3& position_W) noexcept {
    const Vector3 moved_m = position_W - last_position_W_;
    last_position_W_ = position_W;
    elastic_force_.held_W = elastic_force_.now_W;
    elastic_torque_.held_W = elastic_torque_.now_W;
    elastic_force_.held_W += last_.force_share * (model_.stiffness_N_per_m * moved_m);
    elastic_torque_.held_W += last_.torque_share * (model_.torque_stiffness_Nm_per_m * moved_m);
}

}  // namespace fulcrum
