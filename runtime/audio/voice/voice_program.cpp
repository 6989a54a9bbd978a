#include "runtime/audio/voice/voice_program.h"

#include "dialogue/unicode.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace fulcrum::runtime {
namespace {

constexpr std::array<std::string_view, 3> kVoiceNames{"none", "flite", "espeak-ng"};
constexpr std::size_t kMostSpoken_bytes = 2000;  // some minutes
constexpr std::size_t kLongestWord_bytes = 40;
constexpr double kEspeakWords_per_min = 150.0;

// What is said aloud of a text: no emphasis marks, nothing that a program might take for a command, no word without an end, over which
// flite thinks for minutes.
std::string to_spoken(std::string_view text) {
    std::string spoken;
    std::size_t word = 0;
    text = dialogue::whole_characters(text, kMostSpoken_bytes);
    for (std::size_t at = 0; at < text.size();) {
        const auto [code, bytes, valid] = dialogue::character_at(text, at);
        const std::string_view letter = text.substr(at, bytes);
        at += bytes;
        if (code == '*') {
            continue;
        }
        const bool is_blank = code <= ' ' || code == 0x7F;
        word = is_blank ? 0 : word + bytes;
        if (word > kLongestWord_bytes) {
            spoken += ' ';
            word = bytes;
        }
        spoken += is_blank ? " " : letter;
    }
    return spoken;
}

std::string two_places(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.2f", value);
    return text.data();
}

}  // namespace

std::string_view name_of(VoiceKind kind) {
    return kVoiceNames[static_cast<std::size_t>(kind)];
}

Expected<VoiceKind> find_voice(std::string_view name) {
    const auto* const found = std::find(kVoiceNames.begin(), kVoiceNames.end(), name);
    if (found == kVoiceNames.end()) {
        return fail("the voice " + std::string(name) + " is not known", {},
                    "use none, flite or espeak-ng");
    }
    return static_cast<VoiceKind>(found - kVoiceNames.begin());
}

std::vector<std::string> make_voice_words(const VoiceSettings& settings, std::string_view text) {
    const double speed = std::clamp(settings.speed, kSlowestVoice, kFastestVoice);
    if (settings.kind == VoiceKind::espeak_ng) {
        const auto rate = std::lround(kEspeakWords_per_min * speed);
        return {"espeak-ng", "--stdout",           "-v", "en-gb",
                "-s",        std::to_string(rate), "--", to_spoken(text)};
    }
    return {"flite",
            "-voice",
            "slt",
            "--setf",
            "duration_stretch=" + two_places(1.0 / speed),
            "-o",
            "/dev/stdout",
            "-t",
            to_spoken(text)};
}

}  // namespace fulcrum::runtime
