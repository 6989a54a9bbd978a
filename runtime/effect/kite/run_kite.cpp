// A kite's flight beside the haptic loop, as the lesson launches, reels and builds it.
#include "haptics/flight/kite_loop.h"
#include "runtime/app/running_effect.h"
#include "runtime/effect/kite/plan_kite.h"

namespace fulcrum::runtime {
namespace {

class RunningKite final : public RunningEffect {
  public:
    RunningKite(const KitePlan& plan, KiteChannels& channels)
        : plan_(plan),
          channels_(channels),
          loop_(plan.flight, plan.rate_hz * plan.n_parts, channels) {}

    void take(const LessonDescription& /*lesson*/, std::vector<WorldEvent>& /*events*/) override {
        channels_.frame.take();
    }
    void tell(EffectFrames& frames) const override {
        const KiteFrame& newest = channels_.frame.value();
        frames.kite = newest.n_nodes > 0 ? &newest : nullptr;
    }
    Expected<void> order(const EffectOrders& orders) override {
        // Another kite is made here, on the lesson's thread, and flown there.
        if (orders.kite_design) {
            channels_.built.put(
                std::make_unique<KiteFlight>(with_design(plan_.flight, *orders.kite_design)));
        }
        channels_.orders.publish(orders.kite);
        return {};
    }
    EffectLoop loop() override { return {"kite", plan_.rate_hz, &loop_}; }

  private:
    const KitePlan& plan_;
    KiteChannels& channels_;
    KiteLoop loop_;
};

}  // namespace

Expected<std::unique_ptr<RunningEffect>> run_kite(const EffectParts& parts) {
    return parts.plan.kite
               ? std::make_unique<RunningKite>(*parts.plan.kite, *parts.hands.front()->kite)
               : nullptr;
}

}  // namespace fulcrum::runtime
