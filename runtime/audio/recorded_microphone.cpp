#include "runtime/audio/recorded_microphone.h"

#include "dialogue/speech/word_graph.h"
#include "haptics/base/clock.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fulcrum::runtime {

RecordedMicrophone::RecordedMicrophone(std::vector<std::int16_t> samples,
                                       RecordedMicrophoneSettings settings)
    : samples_(std::move(samples)), settings_(std::move(settings)) {
    if (!settings_.now_s) {
        settings_.now_s = monotonic_now_s;
    }
    opened_s_ = settings_.now_s();
}

Expected<std::size_t> RecordedMicrophone::read(std::span<std::int16_t> samples) {
    const double time_s = (settings_.now_s() - opened_s_) * settings_.speed;
    if (settings_.unplugged_at_s >= 0.0 && time_s >= settings_.unplugged_at_s) {
        return fail("the microphone was unplugged", {}, "plug it in again, or type");
    }
    const auto due =
        static_cast<std::size_t>(std::llround(std::max(time_s, 0.0) * dialogue::kHeardRate_Hz));
    const std::size_t n = std::min(due - std::min(due, heard_), samples.size());
    for (std::size_t i = 0; i < n; ++i, ++heard_) {
        samples[i] = heard_ < samples_.size() ? samples_[heard_] : std::int16_t{0};
    }
    return n;
}

}  // namespace fulcrum::runtime
