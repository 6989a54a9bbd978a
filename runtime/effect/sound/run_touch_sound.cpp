// What is stroked and tapped by the first hand is heard.
#include "runtime/app/running_effect.h"
#include "runtime/audio/touch_sound.h"

namespace fulcrum::runtime {
namespace {

// Each solid that can be heard has its tone.
std::vector<TapTone> tones_of(const std::vector<SolidPlan>& solids) {
    std::vector<TapTone> tones;
    tones.reserve(solids.size());
    for (const SolidPlan& solid : solids) {
        tones.push_back(solid.surface.audible ? tone_of(solid.surface.transient) : TapTone{});
    }
    return tones;
}

class RunningTouchSound final : public RunningEffect {
  public:
    RunningTouchSound(const HapticPlan& plan, HapticChannels& hand)
        : sound_(touches_, tones_of(plan.solids), 1.0 / plan.rate_hz) {
        hand.touches = &touches_;
    }

    void measure(std::vector<PlanStage>& stages) const override {
        for (PlanStage& stage : stages) {
            if (stage.loop == "sound" && stage.name == "touch") {
                stage.memory_bytes = sizeof(TouchRing) + sizeof(TouchSound);
            }
        }
    }
    SoundStream* sound() override { return &sound_; }

  private:
    TouchRing touches_;
    TouchSound sound_;
};

}  // namespace

Expected<std::unique_ptr<RunningEffect>> run_touch_sound(const EffectParts& parts) {
    return parts.plan.touch_sound
               ? std::make_unique<RunningTouchSound>(parts.plan.haptic, *parts.hands.front())
               : nullptr;
}

}  // namespace fulcrum::runtime
