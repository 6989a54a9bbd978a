// Bodies on hinges, which the first hand's own loop turns, as the lesson sets and loads them.
#include "runtime/app/running_effect.h"

namespace fulcrum::runtime {
namespace {

class RunningHinges final : public RunningEffect {
  public:
    explicit RunningHinges(AxleChannels& channels) : channels_(channels) {}

    void take(const LessonDescription& /*lesson*/, std::vector<WorldEvent>& /*events*/) override {
        channels_.frame.take();
    }
    void tell(EffectFrames& frames) const override {
        const AxleFrame& newest = channels_.frame.value();
        frames.axles = newest.n_axles > 0 ? &newest : nullptr;
    }
    Expected<void> order(const EffectOrders& orders) override {
        channels_.orders.publish(orders.axles);
        return {};
    }

  private:
    AxleChannels& channels_;
};

}  // namespace

Expected<std::unique_ptr<RunningEffect>> run_hinges(const EffectParts& parts) {
    return parts.plan.haptic.axles.empty()
               ? nullptr
               : std::make_unique<RunningHinges>(*parts.hands.front()->axles);
}

}  // namespace fulcrum::runtime
