#include "runtime/audio/wav.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <optional>
#include <string>
#include <utility>

namespace fulcrum::runtime {
namespace {

void put(std::string& to, std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) {
        to += static_cast<char>(value >> (8 * i) & 0xFFU);
    }
}

constexpr std::size_t kHead = 8;                     // of a chunk: its name, its length
constexpr std::uint32_t kOpenLength = 0x7FF0'0000U;  // and more: not known when it was written
constexpr std::uint32_t kPcm = 1;
constexpr std::uint32_t kFloat = 3;
constexpr std::uint32_t kExtensible = 0xFFFE;
constexpr std::size_t kSubFormat = 24;  // where the extensible format says which it is

// Little-endian; the caller has seen that it is there.
std::uint32_t take(std::string_view bytes, std::size_t at, int n) {
    std::uint32_t value = 0;
    for (int i = 0; i < n; ++i) {
        value |= static_cast<std::uint32_t>(
                     static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)]))
                 << (8 * i);
    }
    return value;
}

struct Format {
    std::uint32_t kind = 0;
    std::size_t n_channels = 0;
    int rate_Hz = 0;
    int n_bytes = 0;  // of one channel's sample
};

tl::unexpected<Error> no_wav(const std::string& why) {
    return fail("it is no WAV file that can be heard: " + why, {},
                "save it as WAV with 16 bits, mono, 16 kHz");
}

Expected<Format> read_format(std::string_view chunk) {
    constexpr std::size_t kLeast = 16;
    constexpr std::uint32_t kMostChannels = 8;
    constexpr std::uint32_t kLeastRate_Hz = 4000;
    constexpr std::uint32_t kMostRate_Hz = 192'000;
    if (chunk.size() < kLeast) {
        return no_wav("its format is cut short");
    }
    Format format;
    format.kind = take(chunk, 0, 2);
    if (format.kind == kExtensible && chunk.size() >= kSubFormat + 2) {
        format.kind = take(chunk, kSubFormat, 2);
    }
    const std::uint32_t n_channels = take(chunk, 2, 2);
    const std::uint32_t rate_Hz = take(chunk, 4, 4);
    const std::uint32_t n_bits = take(chunk, 14, 2);
    const bool is_pcm = format.kind == kPcm && n_bits % 8 == 0 && n_bits >= 8 && n_bits <= 32;
    if (!is_pcm && !(format.kind == kFloat && n_bits == 32)) {
        return no_wav("its samples are of another kind (" + std::to_string(format.kind) + ", " +
                      std::to_string(n_bits) + " bits)");
    }
    if (n_channels < 1 || n_channels > kMostChannels || rate_Hz < kLeastRate_Hz ||
        rate_Hz > kMostRate_Hz) {
        return no_wav("it has " + std::to_string(n_channels) + " channels at " +
                      std::to_string(rate_Hz) + " Hz");
    }
    format.n_channels = n_channels;
    format.rate_Hz = static_cast<int>(rate_Hz);
    format.n_bytes = static_cast<int>(n_bits / 8);
    return format;
}

float read_sample(const Format& format, std::string_view data, std::size_t at) {
    const std::uint32_t bits = take(data, at, format.n_bytes);
    if (format.kind == kFloat) {
        return std::clamp(std::bit_cast<float>(bits), -1.0F, 1.0F);
    }
    if (format.n_bytes == 1) {
        constexpr float kMiddle = 128.0F;  // bytes have no sign
        return (static_cast<float>(bits) - kMiddle) / kMiddle;
    }
    // To the top of 32 bits, where its sign is.
    const auto value = static_cast<std::int32_t>(bits << (32 - 8 * format.n_bytes));
    return static_cast<float>(value) * 0x1p-31F;
}

// The first that is not finite, with its place.
std::optional<tl::unexpected<Error>> find_no_number(const Format& format, std::string_view data) {
    if (format.kind != kFloat) {
        return std::nullopt;
    }
    const std::size_t n_frames = data.size() / (format.n_channels * sizeof(float));
    for (std::size_t i = 0; i < n_frames * format.n_channels; ++i) {
        const auto value = std::bit_cast<float>(take(data, i * sizeof(float), sizeof(float)));
        if (!std::isfinite(value)) {
            const std::size_t frame = i / format.n_channels;
            std::array<char, 40> time{};
            std::snprintf(time.data(), time.size(), "%.3f s",
                          static_cast<double>(frame) / format.rate_Hz);
            return no_wav("its sample " + std::to_string(frame + 1) + ", at " + time.data() +
                          ", is " + (std::isnan(value) ? "no number" : "infinite"));
        }
    }
    return std::nullopt;
}

Expected<WavSound> read_samples(const Format& format, std::string_view data) {
    if (auto refused = find_no_number(format, data)) {
        return *refused;
    }
    const std::size_t frame = format.n_channels * static_cast<std::size_t>(format.n_bytes);
    WavSound sound{std::vector<float>(data.size() / frame), format.rate_Hz};
    for (std::size_t i = 0; i < sound.samples.size(); ++i) {
        float sum = 0.0F;
        for (std::size_t c = 0; c < format.n_channels; ++c) {
            sum +=
                read_sample(format, data, i * frame + c * static_cast<std::size_t>(format.n_bytes));
        }
        sound.samples[i] = sum / static_cast<float>(format.n_channels);
    }
    return sound;
}

}  // namespace

std::vector<std::int16_t> to_pcm16(std::span<const float> samples) {
    std::vector<std::int16_t> pcm(samples.size());
    std::ranges::transform(samples, pcm.begin(), [](float x) {
        const float bounded = std::isfinite(x) ? std::clamp(x, -1.0F, 1.0F) : 0.0F;
        return static_cast<std::int16_t>(std::lround(bounded * 32767.0F));
    });
    return pcm;
}

Expected<WavSound> read_wav(std::string_view bytes) {
    constexpr std::size_t kFirstChunk = 12;
    if (bytes.size() < kFirstChunk || bytes.substr(0, 4) != "RIFF" ||
        bytes.substr(8, 4) != "WAVE") {
        return no_wav("it does not begin as one");
    }
    Format format;
    std::size_t at = kFirstChunk;
    while (bytes.size() - at >= kHead) {
        const std::string_view name = bytes.substr(at, 4);
        const std::uint32_t length = take(bytes, at + 4, 4);
        at += kHead;
        const std::size_t left = bytes.size() - at;
        const bool is_data = name == "data";
        if (length > left && !(is_data && length >= kOpenLength)) {
            return no_wav("it ends too early");
        }
        const std::string_view chunk = bytes.substr(at, std::min<std::size_t>(length, left));
        if (is_data) {
            return format.n_bytes > 0 ? read_samples(format, chunk)
                                      : no_wav("it has samples before a format");
        }
        if (name == "fmt ") {
            const auto read = read_format(chunk);
            if (!read) {
                return tl::unexpected(read.error());
            }
            format = *read;
        }
        // Chunks begin at even places.
        at += std::min<std::size_t>(chunk.size() + chunk.size() % 2, left);
    }
    return no_wav("it has no samples");
}

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
    for (const std::int16_t sample : to_pcm16(samples)) {
        put(file, static_cast<std::uint16_t>(sample), 2);
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
