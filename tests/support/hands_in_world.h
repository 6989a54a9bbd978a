// Simulated hands, each with a haptic loop of its own, and rigid bodies that all of them touch, under one virtual clock.
#pragma once

#include "haptics/device/simulated/simulated_arm.h"
#include "haptics/dynamics/rigid_loop.h"
#include "haptics/loop/hands_loop.h"
#include "haptics/loop/haptic_loop.h"

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace fulcrum::test {

/// A floor and boxes on it: body i + 1 of the world is solid i of each hand, and body i of the scene.
struct BoxScene {
    struct Box {
        Vector3 half_m{0.03, 0.03, 0.03};
        double mass_kg = 0.2;
        Vector3 at_W{0.0, 0.03, 0.0};
    };
    std::vector<Box> boxes{Box{}};
    double friction = 0.6;  ///< of all: of cursors with boxes too
    std::uint32_t grip_buttons = 0;
    double world_rate_hz = 1000.0;  ///< at which it is stepped, whatever its plan says
    double world_late_s =
        0.0;  ///< what a step takes: so much later it is told, and the next begins
    double slow_period_s = 0.0;
    int n_threads = 1;
    CouplingSettings coupling{};
    double cursor_m = 0.006;
    HumanImpedance human = kPosture;
    double most_force_N = 9.0;
    std::shared_ptr<const ToolPlan> tool{};  ///< instead of a cursor

    [[nodiscard]] RigidLoopPlan make_world() const {
        RigidLoopPlan plan;
        plan.world.settings.slow_period_s = slow_period_s;
        plan.world.settings.n_threads = n_threads;
        plan.world.bodies = {
            {.role = BodyRole::ground, .static_friction = friction, .dynamic_friction = friction}};
        plan.scene_bodies = {kNoBody};
        for (const Box& box : boxes) {
            plan.scene_bodies.push_back(static_cast<std::int32_t>(plan.solids.size()));
            plan.solids.push_back(static_cast<std::int32_t>(plan.world.bodies.size()));
            plan.world.bodies.push_back({.shape = BoxShape{box.half_m},
                                         .mass_kg = box.mass_kg,
                                         .pose_W = Pose::at(box.at_W),
                                         .static_friction = friction,
                                         .dynamic_friction = friction});
        }
        return plan;
    }
    [[nodiscard]] HapticPlan make_hand() const {
        HapticPlan plan;
        plan.expects_lesson = false;
        plan.safety.max_force_N = most_force_N;
        plan.safety.soft_start_s = 0.0;
        plan.coupling = coupling;
        plan.tool = tool;
        plan.proxy = {.kind = ProxyKind::friction_cone, .cursor = SphereShape{cursor_m}};
        for (const Box& box : boxes) {
            plan.rigid.push_back({plan.solids.size(), box.mass_kg,
                                  box.mass_kg * box.half_m.squaredNorm() / 3.0, grip_buttons});
            plan.solids.push_back({.body = static_cast<std::int32_t>(plan.solids.size()),
                                   .shape = BoxShape{box.half_m},
                                   .initial_pose_W = Pose::at(box.at_W),
                                   .friction = {friction, friction, 0.0}});
        }
        return plan;
    }
};

class HandsInWorld {
  public:
    HandsInWorld(const BoxScene& scene, const std::vector<Vector3>& starts_W)
        : world_period_s_(1.0 / scene.world_rate_hz), world_late_s_(scene.world_late_s) {
        std::vector<RigidChannels*> channels;
        for (const Vector3& start_W : starts_W) {
            hands_.push_back(std::make_unique<Hand>(scene, start_W));
            worlds_.push_back(std::make_unique<RigidChannels>());
            channels.push_back(worlds_.back().get());
        }
        std::vector<HandInRound> in_round;
        for (const auto& hand : hands_) {
            in_round.push_back({&hand->loop, &hand->channels});
        }
        round_ = std::make_unique<HandsLoop>(in_round);
        world_ = std::move(RigidLoop::create(scene.make_world(), &lesson, channels)).value();
    }

    /// Where a hand wants to be.
    void aim(std::size_t hand, const Vector3& at_W, std::uint32_t buttons = 0) {
        hands_[hand]->target.publish({Pose::at(at_W), Vector3::Zero(), buttons});
    }
    /// A round of a millisecond; the world's where its time has come, told when its computing is done.
    void step() {
        now_s_ += 1.0e-3;
        tell_hands();
        round_->step(now_s_);
        if (!is_stopped_ && now_s_ >= next_world_s_ - 1.0e-9) {
            next_world_s_ += world_period_s_;
            step_world();
        }
    }
    void stop_world() { is_stopped_ = true; }
    void set_world_rate(double rate_hz, double late_s = 0.0) {
        world_period_s_ = 1.0 / rate_hz;
        world_late_s_ = late_s;
    }
    void run(double seconds) {
        for (const double until_s = now_s_ + seconds; now_s_ < until_s - 0.5e-3;) {
            step();
        }
    }

    [[nodiscard]] const HapticState& state(std::size_t hand) const {
        return hands_[hand]->loop.state();
    }
    [[nodiscard]] SimulatedArm& arm(std::size_t hand) { return hands_[hand]->arm; }
    [[nodiscard]] const RigidWorld& world() const { return world_->world(); }
    /// Of box i.
    [[nodiscard]] Pose box_W(std::int32_t i) const { return world().shape_pose_W(i + 1); }
    [[nodiscard]] Twist box_velocity_W(std::int32_t i) const {
        return world().state(i + 1).velocity_W;
    }
    [[nodiscard]] double now_s() const { return now_s_; }

    WorldChannels lesson;

  private:
    struct Hand {
        Hand(const BoxScene& scene, const Vector3& start_W)
            : arm({.human = scene.human, .start_D = start_W}, target),
              loop(scene.make_hand(), arm, with_rigid(channels, rigid)) {
            target.publish({Pose::at(start_W), Vector3::Zero(), 0});
        }
        static HapticChannels& with_rigid(HapticChannels& channels, RigidChannels& rigid) {
            channels.rigid = &rigid;
            return channels;
        }
        LatestValue<HandTarget> target;
        SimulatedArm arm;
        HapticChannels channels;
        RigidChannels rigid;
        HapticLoop loop;
    };
    // What hands have pushed goes into the step that begins.
    void step_world() {
        for (std::size_t i = 0; i < hands_.size(); ++i) {
            if (hands_[i]->rigid.pushes.take()) {
                worlds_[i]->pushes.publish(hands_[i]->rigid.pushes.value());
            }
        }
        world_->step(now_s_);
        told_s_ = now_s_ + world_late_s_;
    }
    // What comes of it is told when that is done.
    void tell_hands() {
        if (now_s_ < told_s_ - 1.0e-9) {
            return;
        }
        for (std::size_t i = 0; i < hands_.size(); ++i) {
            if (worlds_[i]->frame.take()) {
                hands_[i]->rigid.frame.publish(worlds_[i]->frame.value());
            }
        }
    }

    std::vector<std::unique_ptr<Hand>> hands_;
    std::unique_ptr<HandsLoop> round_;
    std::vector<std::unique_ptr<RigidChannels>> worlds_;
    std::unique_ptr<RigidLoop> world_;
    double world_period_s_;
    double world_late_s_;
    double told_s_ = 0.0;
    double now_s_ = 0.0;
    double next_world_s_ = 0.0;
    bool is_stopped_ = false;
};

}  // namespace fulcrum::test
