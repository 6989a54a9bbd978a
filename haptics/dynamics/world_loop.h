// The world's round: takes commands and the hand, steps the world, publishes what came of it.
//
// Thread: `step` on the one world thread (or a virtual clock). Cost: that of World::step, and one
// copy of the snapshot while anything moves or is held; at rest only its time is written, whatever the
// number of bodies.
#pragma once

#include "haptics/base/periodic_task.h"
#include "haptics/dynamics/world.h"
#include "haptics/handover/channels.h"

#include <cstdint>
#include <vector>

namespace fulcrum {

class WorldLoop final : public PeriodicTask {
  public:
    /// Builds the world of `plan`, which `validate` accepted. `solid_bodies` are the scene's
    /// indices of the haptic plan's solids, in its order. The channels must outlive the loop.
    WorldLoop(const WorldPlan& plan, std::vector<std::int32_t> solid_bodies,
              WorldChannels& channels, HapticChannels& haptics);
    ~WorldLoop() override;

    /// One round at `now_s` of the run's clock. The world moves by the time since the last round,
    /// at most kLongestWorldStep_s; when the clock goes backwards it stands still. A time that is
    /// not finite is no round at all. The tool is nowhere, and catches nothing, until the haptic
    /// loop has told of a pose.
    void step(double now_s) noexcept override;
    /// Nothing is carried any more: the haptic loop is told so.
    void silence(double now_s) noexcept override;

    /// The world itself, for the world's own thread.
    [[nodiscard]] const World& world() const noexcept { return world_; }

  private:
    void take_hand() noexcept;
    void take_commands() noexcept;
    void publish(double now_s) noexcept;

    World world_;
    double period_s_;
    std::vector<std::int32_t> solid_bodies_;
    WorldChannels& channels_;
    HapticChannels& haptics_;
    ThriftyWriter<WorldSnapshot> snapshots_;
    ThriftyWriter<WorldFrame> frames_;
    HapticState hand_{};  // nowhere, until one is heard of
    bool heard_hand_ = false;
    bool started_ = false;
    double now_s_ = 0.0;
};

/// After a longer pause the world goes on from where it was instead of leaping.
inline constexpr double kLongestWorldStep_s = 0.05;

}  // namespace fulcrum
