#include "runtime/app/run_effects.h"

#include <algorithm>
#include <numeric>

namespace fulcrum::runtime {
Expected<void> RunEffects::build(const EffectParts& parts) {
    for (EffectMaker* const make : kEffects) {
        auto made = make(parts);
        if (!made) {
            return tl::unexpected(made.error());
        }
        if (!*made) {
            continue;
        }
        running_.push_back(std::move(*made));
        if (const EffectLoop loop = running_.back()->loop(); loop.task != nullptr) {
            loops_.push_back(loop);
        }
    }
    return {};
}

void RunEffects::measure(std::vector<PlanStage>& stages) const {
    for (const auto& effect : running_) {
        effect->measure(stages);
    }
}

void RunEffects::gather(const LessonDescription& lesson, SessionInput& gathered) {
    for (const auto& effect : running_) {
        effect->take(lesson, gathered.world_events);
        effect->tell(frames_);
    }
    static_cast<EffectFrames&>(gathered) = frames_;
}

Expected<void> RunEffects::order(const EffectOrders& orders) {
    for (const auto& effect : running_) {
        if (auto done = effect->order(orders); !done) {
            return done;
        }
    }
    return {};
}

SoundStream* RunEffects::touch_sound() const {
    const auto heard = std::ranges::find_if(
        running_, [](const auto& effect) { return effect->sound() != nullptr; });
    return heard == running_.end() ? nullptr : (*heard)->sound();
}

std::uint64_t RunEffects::n_events_dropped() const {
    return std::accumulate(
        running_.begin(), running_.end(), std::uint64_t{0},
        [](std::uint64_t n, const auto& effect) { return n + effect->n_events_dropped(); });
}

std::uint64_t RunEffects::n_commands_ignored() const {
    return std::accumulate(
        running_.begin(), running_.end(), std::uint64_t{0},
        [](std::uint64_t n, const auto& effect) { return n + effect->n_commands_ignored(); });
}

}  // namespace fulcrum::runtime
