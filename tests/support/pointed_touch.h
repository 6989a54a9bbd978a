// A mouse that touches one solid: device, plan and last gate are those of a run, so that the hand on the screen gives way to what is sent.
#pragma once

#include "haptics/device/mouse/pointer_device.h"
#include "haptics/handover/channels.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/loop/workspace.h"
#include "runtime/scene/compile_plan.h"

#include <memory>

namespace fulcrum::test {

class PointedTouch {
  public:
    /// A plan that the program would refuse ends the program.
    PointedTouch(const runtime::LessonDescription& lesson,
                 std::shared_ptr<const CollisionMesh> mesh, double yield)
        : plan_(runtime::compile_plan(lesson, {}, [&](const auto&) { return mesh; }).value()),
          mouse_(make_wide(yield), target_) {
        plan_.haptic.expects_lesson = false;
        plan_.haptic.expects_world = false;
        loop_ = std::make_unique<HapticLoop>(plan_.haptic, mouse_, channels_);
    }
    PointedTouch(const PointedTouch&) = delete;
    PointedTouch& operator=(const PointedTouch&) = delete;

    /// So long with the pointer there: what is drawn of the force, newtons.
    const Vector3& point_at(const Vector3& place_W, double lasts_s) {
        target_.publish(
            {compute_device_pose(plan_.haptic.workspace, Pose::at(place_W)).position, 0});
        for (double s = 0.0; s < lasts_s; s += 1.0 / plan_.haptic.rate_hz) {
            now_s_ += 1.0 / plan_.haptic.rate_hz;
            loop_->step(now_s_);
        }
        return loop_->state().applied_W.force;
    }
    /// Where the hand is that it is drawn as, before the solid holds it back.
    [[nodiscard]] const Vector3& hand_W() const { return loop_->state().tool_pose_W.position; }
    [[nodiscard]] const HapticPlan& plan() const { return plan_.haptic; }

  private:
    // As in a run, so that a mouse reaches all.
    static PointerSettings make_wide(double yield) {
        PointerSettings settings = make_yielding(yield);
        settings.half_extent_D = Vector3::Ones();
        return settings;
    }

    runtime::Plan plan_;
    LatestValue<PointerTarget> target_;
    PointerDevice mouse_;
    HapticChannels channels_;
    std::unique_ptr<HapticLoop> loop_;
    double now_s_ = 0.0;
};

}  // namespace fulcrum::test
