#include "haptics/tool/field_sampling/field_slopes.h"

#include "haptics/math/turned_slopes.h"
#include "haptics/tool/field_sampling/slope_sum.h"

#include <array>
#include <bit>

namespace fulcrum {
namespace {

// A force at the arm as a wrench.
Vector6 at_arm(const Vector3& arm, const Vector3& force) noexcept {
    Vector6 wrench;
    wrench << force, arm.cross(force);
    return wrench;
}

}  // namespace

// By slopes: in vectors, and one by one what lies too deep for them.
void FieldSlopes::add_leaf(const FieldLook& look, const ShellPoints& points,
                           std::size_t n) noexcept {
    const Pose& X_OT = look.X_OT;
    std::uint32_t deep =
        look.pair.kernels->sum_slopes(look.pair.bounds.view, look.place, points, n, lanes_);
    if (deep == 0) {
        return;
    }
    SlopeSum sum;
    for (; deep != 0; deep &= deep - 1U) {
        const auto i = static_cast<std::size_t>(std::countr_zero(deep));
        const Vector3 arm_O = X_OT.orientation * Vector3(points.x[i], points.y[i], points.z[i]);
        sum.add(look.pair.field->sample_depth(X_OT.position + arm_O), arm_O);
    }
    sum.add_to(slopes_O_);
}

void FieldSlopes::add_leaf_by_normals(const FieldLook& look, const ShellPoints& points,
                                      std::size_t n) noexcept {
    std::array<float, kLeafPoints> values{};
    look.pair.kernels->sample(look.pair.bounds.view, look.place, points, kLeafPoints, values.data(),
                              nullptr);
    const Matrix3 R_OT = look.X_OT.orientation.toRotationMatrix();
    for (std::size_t i = 0; i < n; ++i) {
        if (values[i] < 0.0F) {
            const Vector3 arm_O = R_OT * Vector3(points.x[i], points.y[i], points.z[i]);
            const Vector3 n_O = R_OT * Vector3(points.nx[i], points.ny[i], points.nz[i]);
            const Vector3 way_out =
                look.pair.field->sample_depth(look.X_OT.position + arm_O).way_out;
            slopes_O_ -= at_arm(arm_O, n_O) * at_arm(arm_O, way_out).transpose();
        }
    }
}

void FieldSlopes::add_all(const FieldLook& look, const LeafSums& sums, LookTime& time) noexcept {
    constexpr std::int64_t kMostInLanes = 128;  // leaves whose sums single precision may hold
    const ShellTree& shell = *look.pair.shell;
    const std::size_t thinning = sums.thinning();
    const NodeList& touched = sums.touched();
    std::int64_t& n_sloped = time.work().n_sloped;
    const double before_us = time.has_budget() ? time.elapsed_us() : 0.0;
    const std::size_t stride = time.find_slopes_stride(touched.size());
    for (std::size_t i = 0; i < touched.size(); i += stride) {
        const ShellPoints points = shell.points(thinning, touched[i]);
        const std::size_t n = shell.count_in(thinning, touched[i]);
        if (along_ == ForceAlong::normals) {
            add_leaf_by_normals(look, points, n);
        } else {
            add_leaf(look, points, n);
        }
        if (++n_sloped % kMostInLanes == 0) {
            add_slope_lanes(*look.pair.field, lanes_, slopes_O_);
        }
    }
    add_slope_lanes(*look.pair.field, lanes_, slopes_O_);
    if (time.has_budget() && n_sloped > 0) {
        time.end_slopes(before_us, static_cast<std::size_t>(n_sloped));
        slopes_O_ *= static_cast<double>(touched.size()) / static_cast<double>(n_sloped);
    }
}

void FieldSlopes::add_to(Matrix6& by_pose_W, const Pose& X_WO, const FieldTouch& touch,
                         double stiffness_N_per_m) const noexcept {
    const double k = stiffness_N_per_m * static_cast<double>(touch.weight);
    by_pose_W += k * compute_turned(slopes_O_, X_WO.orientation.toRotationMatrix());
    if (along_ == ForceAlong::normals) {
        add_turning(touch.wrench_W, by_pose_W);
    }
}

}  // namespace fulcrum
