// Writes samples as a WAV file, to listen to what a test heard.
#pragma once

#include "haptics/base/error.h"

#include <filesystem>
#include <span>

namespace fulcrum::runtime {

/// 16-bit PCM; `samples` are interleaved, -1 to 1, beyond that they are clipped. `channels` 1 or 2.
[[nodiscard]] Expected<void> write_wav(const std::filesystem::path& path,
                                       std::span<const float> samples, int channels,
                                       int sample_rate_Hz);

}  // namespace fulcrum::runtime
