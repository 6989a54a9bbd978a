// What runs in a lesson beside its hands: the world or its rigid bodies, axles, a kite, the sound of touch. Built from the plan and nothing more,
// told what the lesson orders, and asked what is new.
//
// Thread: the lesson's; `world_loop` and `kite_loop` belong to theirs.
#pragma once

#include "haptics/dynamics/rigid_loop.h"
#include "haptics/dynamics/world_loop.h"
#include "haptics/flight/kite_loop.h"
#include "runtime/app/run_hand.h"
#include "runtime/app/world_post.h"
#include "runtime/audio/touch_sound.h"
#include "runtime/lesson/scenery.h"
#include "runtime/lesson/session.h"
#include "runtime/scene/plan.h"

#include <memory>
#include <string>
#include <vector>

namespace fulcrum::runtime {

class RunEffects {
  public:
    /// What is between hands and effects, and all but the world; before the hands' loops. Tells the plan how much memory it takes.
    [[nodiscard]] Expected<void> join(Plan& plan, RunHands& hands);
    /// The world in which bodies fall and are caught, by the first hand; the bodies that are there at first.
    void build_world(const Plan& plan, HapticChannels& hand, const LessonDescription& lesson);

    /// What is new goes into the session's input.
    void gather(const LessonDescription& lesson, SessionInput& gathered);
    /// What the lesson wants of them. An error where it wants more of the world than that can be told.
    [[nodiscard]] Expected<void> order(const Plan& plan, const SessionOutput& output);
    void show(Scenery& scenery) const;

    /// Null where the plan has none.
    [[nodiscard]] PeriodicTask* world_loop();
    [[nodiscard]] KiteLoop* kite_loop() { return kite_loop_.get(); }
    [[nodiscard]] SoundStream* touch_sound() { return touch_sound_.get(); }
    /// Null before the world's first round, and where the plan has none; so are the two below.
    [[nodiscard]] const WorldSnapshot* newest_world() const;
    /// As the lesson's last frame had it; nothing without a world of rigid bodies.
    [[nodiscard]] WorldEffort world_effort() const;
    /// What was not told for want of time or place.
    [[nodiscard]] std::uint64_t n_events_dropped() const;
    [[nodiscard]] std::uint64_t n_commands_ignored() const;

  private:
    [[nodiscard]] const AxleFrame* newest_axles() const;
    [[nodiscard]] const KiteFrame* newest_kite() const;
    void build_touch_sound(Plan& plan, HapticChannels& hand);
    [[nodiscard]] Expected<void> build_rigid_loop(const Plan& plan, RunHands& hands);
    void take_rigid_bodies(const LessonDescription& lesson);

    std::unique_ptr<WorldChannels> world_;
    std::unique_ptr<AxleChannels> axles_;
    std::unique_ptr<KiteChannels> kite_;
    std::unique_ptr<WorldLoop> world_loop_;
    std::unique_ptr<RigidLoop> rigid_loop_;
    std::unique_ptr<KiteLoop> kite_loop_;
    std::unique_ptr<TouchRing> touches_;
    std::unique_ptr<TouchSound> touch_sound_;
    WorldSnapshot seen_{};  // with rigid bodies: them, and those that stay
    WorldPost to_world_;
};

}  // namespace fulcrum::runtime
