// The world in which bodies fall and are caught, by the first hand.
#include "haptics/dynamics/world_loop.h"
#include "runtime/app/running_world.h"

namespace fulcrum::runtime {
namespace {

std::vector<std::int32_t> bodies_of(const std::vector<SolidPlan>& solids) {
    std::vector<std::int32_t> bodies;
    bodies.reserve(solids.size());
    for (const SolidPlan& solid : solids) {
        bodies.push_back(solid.body);
    }
    return bodies;
}

class RunningFalling final : public RunningWorld {
  public:
    RunningFalling(const Plan& plan, HapticChannels& hand)
        : rate_hz_(plan.world->rate_hz),
          loop_(*plan.world, bodies_of(plan.haptic.solids), channels(), hand) {}

    void tell(EffectFrames& frames) const override {
        const WorldSnapshot& newest = channels().snapshot.value();
        frames.world = newest.n_bodies > 0 ? &newest : nullptr;
    }
    EffectLoop loop() override { return {"world", rate_hz_, &loop_}; }
    [[nodiscard]] std::uint64_t n_events_dropped() const override {
        return channels().events.dropped();
    }
    [[nodiscard]] std::uint64_t n_commands_ignored() const override {
        return loop_.world().ignored_commands();
    }

  private:
    double rate_hz_;
    WorldLoop loop_;
};

}  // namespace

Expected<std::unique_ptr<RunningEffect>> run_falling(const EffectParts& parts) {
    if (!parts.plan.world) {
        return nullptr;
    }
    auto made = std::make_unique<RunningFalling>(parts.plan, *parts.hands.front());
    return made->send(parts.first).map([&] {
        return std::unique_ptr<RunningEffect>(std::move(made));
    });
}

}  // namespace fulcrum::runtime
