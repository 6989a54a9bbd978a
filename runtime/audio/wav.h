// WAV files: what a test heard is written, what a voice or a microphone gave is read.
//
// Read are 8, 16, 24 and 32 bits of PCM and 32 bits of IEEE float, 1 to 8 channels, 4 to 192 kHz, behind any chunks. A length that a
// program left open because it wrote into a pipe (2 GB and more) means: to the end.
//
// Source: IBM and Microsoft 1991, Multimedia Programming Interface and Data Specifications 1.0, chapter 3, "Waveform Audio File Format".
#pragma once

#include "haptics/base/error.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace fulcrum::runtime {

/// 16-bit samples of -1 to 1; beyond that they are clipped, and what is no number is silence.
[[nodiscard]] std::vector<std::int16_t> to_pcm16(std::span<const float> samples);

/// 16-bit PCM; `samples` are interleaved, -1 to 1, beyond that they are clipped. `channels` 1 or 2.
[[nodiscard]] Expected<void> write_wav(const std::filesystem::path& path,
                                       std::span<const float> samples, int channels,
                                       int sample_rate_Hz);

/// One channel.
struct WavSound {
    std::vector<float> samples;  ///< -1 to 1, of several channels the mean
    int rate_Hz = 0;
};

/// The sound in a file's bytes; an error says what is wrong with them, without the file's place. Floats beyond -1 to 1 are clipped; one
/// that is no number or infinite refuses the file, with the place of its sample.
[[nodiscard]] Expected<WavSound> read_wav(std::string_view bytes);

}  // namespace fulcrum::runtime
