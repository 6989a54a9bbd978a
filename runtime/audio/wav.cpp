#include "runtime/audio/wav.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <string>

namespace fulcrum::runtime {
namespace {

void put(std::string& to, std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) {
        to += static_cast<char>(value >> (8 * i) & 0xFFU);
    }
}

}  // namespace

Expected<void> write_wav(const std::filesystem::path& path, std::span<const float> samples,
                         int channels, int sample_rate_Hz) {
    if ((channels != 1 && channels != 2) || sample_rate_Hz < 1 || samples.size() > (1U << 29)) {
        return fail("these samples do not fit a WAV file", path.string(),
                    "use 1 or 2 channels and less than an hour");
    }
    const auto data_bytes = static_cast<std::uint32_t>(2 * samples.size());
    const auto n_channels = static_cast<std::uint32_t>(channels);
    const auto rate = static_cast<std::uint32_t>(sample_rate_Hz);
    std::string file = "RIFF";
    put(file, 36 + data_bytes, 4);
    file += "WAVEfmt ";
    put(file, 16, 4);
    put(file, 1, 2);  // PCM
    put(file, n_channels, 2);
    put(file, rate, 4);
    put(file, rate * n_channels * 2, 4);
    put(file, n_channels * 2, 2);
    put(file, 16, 2);
    file += "data";
    put(file, data_bytes, 4);
    for (const float sample : samples) {
        const float bounded = std::isfinite(sample) ? std::clamp(sample, -1.0F, 1.0F) : 0.0F;
        put(file, static_cast<std::uint16_t>(std::lround(bounded * 32767.0F)), 2);
    }
    std::ofstream out(path, std::ios::binary);
    out.write(file.data(), static_cast<std::streamsize>(file.size()));
    out.close();
    if (!out) {
        return fail("the sound could not be written", path.string(), "choose another folder");
    }
    return {};
}

}  // namespace fulcrum::runtime
