#include "haptics/field/linearised_wrench.h"

#include <algorithm>

#include <Eigen/Eigenvalues>
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

bool shorten(Matrix3& gain, double limit) noexcept {
    const double size = gain.norm();
    if (size > limit) {
        gain *= limit / size;
        return true;
    }
    return false;
}

// Takes the positive eigenvalues out of the symmetric part; the skew part does no work and stays.
bool remove_active_part(Matrix3& damping) noexcept {
    const Matrix3 symmetric = 0.5 * (damping + damping.transpose());
    Eigen::SelfAdjointEigenSolver<Matrix3> eigen;
    eigen.computeDirect(symmetric);
    constexpr double kRounding_Ns_per_m = 1.0e-9;
    if (!(eigen.eigenvalues().maxCoeff() > kRounding_Ns_per_m)) {
        return false;
    }
    const Vector3 kept = eigen.eigenvalues().cwiseMin(0.0);
    damping +=
        eigen.eigenvectors() * kept.asDiagonal() * eigen.eigenvectors().transpose() - symmetric;
    return true;
}

}  // namespace

Wrench compute_linearised_wrench(const LinearisedWrench& model, const Vector3& position_W,
                                 const Vector3& velocity_W) noexcept {
    const Vector3 away_m = position_W - model.at_position_W;
    const Vector3 faster_m_per_s = velocity_W - model.at_velocity_W;
    Wrench wrench_W{model.force_W, model.torque_W};
    wrench_W.force.noalias() += model.stiffness_N_per_m * away_m;
    wrench_W.force.noalias() += model.damping_Ns_per_m * faster_m_per_s;
    wrench_W.torque.noalias() += model.torque_stiffness_Nm_per_m * away_m;
    return wrench_W;
}

LinearisationNote bound_gains(LinearisedWrench& model) noexcept {
    if (!is_sane(model)) {
        return LinearisationNote::refused_not_finite;
    }
    LinearisationNote notes = LinearisationNote::none;
    if (remove_active_part(model.damping_Ns_per_m)) {
        notes = notes | LinearisationNote::active_damping_removed;
    }
    if (shorten(model.stiffness_N_per_m, kMaxLinearStiffness_N_per_m)) {
        notes = notes | LinearisationNote::stiffness_clamped;
    }
    if (shorten(model.damping_Ns_per_m, kMaxLinearDamping_Ns_per_m)) {
        notes = notes | LinearisationNote::damping_clamped;
    }
    if (shorten(model.torque_stiffness_Nm_per_m, kMaxTorqueStiffness_Nm_per_m)) {
        notes = notes | LinearisationNote::torque_stiffness_clamped;
    }
    return notes;
}

void LinearisedWrenchStage::reset() noexcept {
    const double timeout_s = timeout_s_;
    *this = LinearisedWrenchStage(timeout_s);
}

Wrench LinearisedWrenchStage::compute_blended(const Vector3& position_W, const Vector3& velocity_W,
                                              double now_s) const noexcept {
    if (!has_model_) {
        return {};
    }
    // The offset to the former model goes away in a straight line.
    const double left = std::clamp(1.0 - (now_s - accepted_at_s_) / kBlend_s, 0.0, 1.0);
    // An answer past its time fades in a straight line too.
    const double late = (now_s - model_.stamp_s - timeout_s_) / timeout_s_;
    const double fresh = late > 0.0 ? std::max(1.0 - late, 0.0) : 1.0;
    const Wrench plain_W = compute_linearised_wrench(model_, position_W, velocity_W);
    return {fresh * (plain_W.force + left * offset_W_.force),
            fresh * (plain_W.torque + left * offset_W_.torque)};
}

Wrench LinearisedWrenchStage::step(const LinearisedWrench& newest, const Vector3& position_W,
                                   const Vector3& velocity_W, double now_s) noexcept {
    if (newest.stamp_s >= 0.0 && newest.stamp_s > seen_stamp_s_) {
        seen_stamp_s_ = newest.stamp_s;
        LinearisedWrench model = newest;
        notes_ = bound_gains(model);
        if (!has(notes_, LinearisationNote::refused_not_finite)) {
            const Wrench former_W = compute_blended(position_W, velocity_W, now_s);
            const Wrench plain_W = compute_linearised_wrench(model, position_W, velocity_W);
            offset_W_ = {former_W.force - plain_W.force, former_W.torque - plain_W.torque};
            accepted_at_s_ = now_s;
            model_ = model;
            has_model_ = true;
        }
    }
    return compute_blended(position_W, velocity_W, now_s);
}

}  // namespace fulcrum
