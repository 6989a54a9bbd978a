#include "haptics/tool/field_sampling/field_sampler.h"

#include <cmath>

namespace fulcrum {
namespace {

// A number, a turn, and no farther than the clock of motion can count: so far away nothing touches.
bool is_within_reach(const Pose& X_OT, double voxel_m) noexcept {
    constexpr double kFarthest_voxels = 1.0e6;
    constexpr double kUnit = 1.0e-3;  // of a quaternion's square, for what was turned often
    return is_finite(X_OT) && std::abs(X_OT.orientation.squaredNorm() - 1.0) < kUnit &&
           X_OT.position.cwiseAbs().maxCoeff() < kFarthest_voxels * voxel_m;
}

}  // namespace

FieldTouch FieldSampler::look(const Pose& X_WO, const Pose& X_WT, FieldSlopes* slopes) noexcept {
    const bool in_step = stages_.time.is_in_step();
    if (!in_step) {
        last_.begin_step();
    }
    stages_.time.begin();
    const Pose X_OT = X_WO.inverse() * X_WT;
    if (last_.is_known(X_WO, X_WT)) {
        return look_again(FieldLook(pair_, X_OT), slopes);
    }
    if (!is_finite(X_WO) || !is_finite(X_WT) || !is_within_reach(X_OT, field().frame().voxel_m)) {
        reset();
        return {};
    }
    const FieldLook at(pair_, X_OT);
    take(at, slopes != nullptr);
    if (slopes != nullptr) {
        slopes->add_all(at, stages_.sums, stages_.time);
    }
    FieldTouch touch = tell(X_WO);
    last_.hold(X_WO, stages_.error.is_cut_short(), touch);
    last_.remember(X_WO, X_WT, touch, in_step);
    stages_.time.end();
    return touch;
}

FieldTouch FieldSampler::look_again(const FieldLook& at, FieldSlopes* slopes) noexcept {
    if (slopes != nullptr) {
        slopes->add_all(at, stages_.sums, stages_.time);
    }
    FieldTouch touch = last_.touch();
    static_cast<LookWork&>(touch) = stages_.time.work();
    stages_.time.end();
    return touch;
}

void FieldSampler::take(const FieldLook& at, bool slopes_follow) noexcept {
    stages_.sums.begin();
    stages_.error.begin();
    if (settings_.mode == SamplingMode::coherent) {
        stages_.memory.advance(at);
    }
    if (stages_.time.has_budget()) {
        TimedLook in(at, stages_);
        budget_.look(in, slopes_follow);
    } else {
        take_all(at);
    }
    stages_.sums.settle(at);
}

void FieldSampler::take_all(const FieldLook& at) noexcept {
    LookWork& work = stages_.time.work();
    const bool remembers = settings_.mode == SamplingMode::coherent;
    if (remembers) {
        stages_.search.search_known(at, stages_.memory, work);
    } else if (settings_.mode == SamplingMode::tree) {
        stages_.search.search_anew(at, 0.0F, work);
    } else {
        stages_.search.list_leaves(shell().n_leaves());
    }
    stages_.sums.take(at, stages_.search.nodes().all(), remembers ? &stages_.memory : nullptr,
                      work);
    if (remembers) {
        stages_.search.note_groups(stages_.memory);
    }
}

FieldTouch FieldSampler::tell(const Pose& X_WO) const noexcept {
    const LeafSums& sums = stages_.sums;
    FieldTouch touch;
    static_cast<LookWork&>(touch) = stages_.time.work();
    touch.weight = sums.weight();
    const double k = settings_.stiffness_N_per_m * static_cast<double>(touch.weight);
    touch.wrench_W.force = X_WO.orientation * Vector3(k * sums.sums().force);
    touch.wrench_W.torque = X_WO.orientation * Vector3(k * sums.sums().torque);
    touch.n_touching = touch.weight * sums.sums().n_touching;
    touch.deepest_m = -field().step_m() * static_cast<double>(sums.least_steps());
    stages_.error.tell(pair_, sums, touch);
    return touch;
}

FieldTouch FieldSampler::step_linearised(const Pose& X_WO, const Pose& X_WT,
                                         Matrix6& by_pose_W) noexcept {
    FieldSlopes slopes(settings_.along);
    const FieldTouch touch = look(X_WO, X_WT, &slopes);
    if (touch.n_touching > 0) {
        slopes.add_to(by_pose_W, X_WO, touch, settings_.stiffness_N_per_m);
    }
    return touch;
}

double FieldSampler::find_first_touch(const Pose& from_OT, const Pose& to_OT,
                                      double deepest_m) noexcept {
    const double voxel_m = field().frame().voxel_m;
    if (!is_within_reach(from_OT, voxel_m) || !is_within_reach(to_OT, voxel_m)) {
        return 0.0;
    }
    return FieldSweep(pair_, from_OT, to_OT, deepest_m)
        .find_first_touch(stages_.search, stages_.time);
}

void FieldSampler::reset() noexcept {
    stages_.memory.reset();
    budget_.forget();
    last_.forget();
}

void FieldSampler::begin_step(StepTime* time, int n_near) noexcept {
    stages_.time.begin_step(time, n_near);
    budget_.begin_step();
    if (time != nullptr) {
        last_.begin_step();
    }
}

}  // namespace fulcrum
