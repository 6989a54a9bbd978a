// What is sent to a hand that touches one solid: plan, couplings and last gate are those that a run would make from a lesson with it.
#pragma once

#include "haptics/handover/channels.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/loop/workspace.h"
#include "haptics/surface/material.h"
#include "runtime/scene/compile_plan.h"
#include "tests/support/scripted_device.h"

#include <functional>
#include <memory>
#include <utility>

namespace fulcrum::test {

/// A lesson with one solid at the origin, of that material; its mesh is the caller's, unless `model` is a shape of the program's own.
inline runtime::LessonDescription make_touch_lesson(const Material& material, bool rounded,
                                                    const std::string& model = "thing") {
    runtime::LessonDescription lesson;
    lesson.id = lesson.title = "touch";
    lesson.materials.push_back({material, {}, {}, 2});
    runtime::BodyDescription body;
    body.name = body.noun = "thing";
    body.model = model;
    body.radius_m = 0.1;
    body.solid = body.visible = true;
    body.shading.on = rounded;
    body.material = 0;
    body.line = 3;
    lesson.bodies.push_back(body);
    return lesson;
}

/// The loop of that lesson's plan with a hand that goes where it is told.
class SentForce {
  public:
    /// A plan that the program would refuse ends the program. `change`, for curves over a setting: of the plan, before it is used.
    SentForce(const runtime::LessonDescription& lesson, std::shared_ptr<const CollisionMesh> mesh,
              const std::function<void(HapticPlan&)>& change = {})
        : plan_(runtime::compile_plan(lesson, {}, [&](const auto&) { return mesh; }).value()) {
        plan_.haptic.expects_lesson = false;
        plan_.haptic.expects_world = false;
        if (change) {
            change(plan_.haptic);
        }
        loop_ = std::make_unique<HapticLoop>(plan_.haptic, device_, channels_);
    }
    SentForce(const SentForce&) = delete;
    SentForce& operator=(const SentForce&) = delete;

    /// One round with the hand there: newtons behind the last gate.
    const Vector3& step(const Vector3& hand_W) { return step(Pose::at(hand_W)).force; }
    /// And with the handle turned: of a device that tells it and gives torques newton metres too.
    const Wrench& step(const Pose& hand_W) {
        device_.pose_D = compute_device_pose(plan_.haptic.workspace, hand_W);
        now_s_ += 1.0 / plan_.haptic.rate_hz;
        loop_->step(now_s_);
        return loop_->state().applied_W;
    }
    /// Calm rounds at a place where nothing is touched, until the gate is open without its soft start.
    void open_gate(const Vector3& free_W) { open_gate(Pose::at(free_W)); }
    void open_gate(const Pose& free_W) {
        const SafetySettings& safety = plan_.haptic.safety;
        const double calm_s = safety.soft_start_s + 2 * safety.engage_cycles / plan_.haptic.rate_hz;
        for (double s = 0.0; s < calm_s; s += 1.0 / plan_.haptic.rate_hz) {
            step(free_W);
        }
    }
    [[nodiscard]] const HapticPlan& plan() const { return plan_.haptic; }
    [[nodiscard]] const HapticState& state() const { return loop_->state(); }

  private:
    runtime::Plan plan_;
    ScriptedDevice device_;
    HapticChannels channels_;
    std::unique_ptr<HapticLoop> loop_;
    double now_s_ = 0.0;
};

}  // namespace fulcrum::test
