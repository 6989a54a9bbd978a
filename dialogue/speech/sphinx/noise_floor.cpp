#include "dialogue/speech/sphinx/noise_floor.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace fulcrum::dialogue {
namespace {

constexpr std::size_t kFrame = 512;    // 32 ms
constexpr std::size_t kQuietest = 20;  // one in so many frames holds the room alone

double power_of(std::span<const std::int16_t> frame) {
    double sum = 0.0;
    for (const std::int16_t sample : frame) {
        sum += static_cast<double>(sample) * static_cast<double>(sample);
    }
    return sum / static_cast<double>(frame.size());
}

}  // namespace

double room_below_voice_dB(std::span<const std::int16_t> sound) {
    std::vector<double> powers;
    double all = 0.0;
    for (std::size_t at = 0; at + kFrame <= sound.size(); at += kFrame) {
        powers.push_back(power_of(sound.subspan(at, kFrame)));
        all += powers.back();
    }
    if (powers.empty()) {
        return kSilentRoom_dB;
    }
    all /= static_cast<double>(powers.size());
    std::ranges::sort(powers);
    const std::size_t n = std::max<std::size_t>(powers.size() / kQuietest, 1);
    double room = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        room += powers[i] / static_cast<double>(n);
    }
    if (room <= 0.0) {
        return kSilentRoom_dB;
    }
    const double voice = std::max(all - room, 0.0);
    return voice > room ? std::min(10.0 * std::log10(voice / room), kSilentRoom_dB) : 0.0;
}

}  // namespace fulcrum::dialogue
