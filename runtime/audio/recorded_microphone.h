// A recording that plays the part of a microphone: as fast as time passes, and silent behind its end.
//
//   samples heard at t = (t - t_opened) speed rate
//
// Thread: one. Cost: a copy.
#pragma once

#include "runtime/audio/microphone.h"

#include <functional>
#include <vector>

namespace fulcrum::runtime {

struct RecordedMicrophoneSettings {
    double speed = 1.0;                  ///< of its time against the clock's, above 0
    double unplugged_at_s = -1.0;        ///< of its own time; negative: never
    std::function<double()> now_s = {};  ///< the clock; empty: the monotonic one
};

class RecordedMicrophone final : public Microphone {
  public:
    explicit RecordedMicrophone(std::vector<std::int16_t> samples,
                                RecordedMicrophoneSettings settings = {});

    [[nodiscard]] Expected<std::size_t> read(std::span<std::int16_t> samples) override;

  private:
    std::vector<std::int16_t> samples_;
    RecordedMicrophoneSettings settings_;
    double opened_s_ = 0.0;
    std::size_t heard_ = 0;
};

}  // namespace fulcrum::runtime
