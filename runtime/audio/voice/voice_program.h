// Programs that speak: how each is called, so that it writes a WAV file to its output.
//
//   flite       small and quick, no data beside it; its voice slt
//   espeak-ng   clearer consonants, more machine; a program of its own by its licence, and never linked
// A speed of 1 is a teacher's, 130 to 150 words a minute; 0.5 is half as fast.
//
// Thread: pure. Cost: some strings.
#pragma once

#include "haptics/base/error.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::runtime {

enum class VoiceKind : std::uint8_t { none, flite, espeak_ng };

inline constexpr double kSlowestVoice = 0.5;
inline constexpr double kFastestVoice = 2.0;

struct VoiceSettings {
    VoiceKind kind = VoiceKind::flite;
    double speed =
        0.9;  ///< kSlowestVoice to kFastestVoice; for learners a little slower than for others
    friend bool operator==(const VoiceSettings&, const VoiceSettings&) = default;
};

/// As the command line names it: "none", "flite", "espeak-ng".
[[nodiscard]] std::string_view name_of(VoiceKind kind);
/// An unknown name is an error that lists the known ones.
[[nodiscard]] Expected<VoiceKind> find_voice(std::string_view name);

/// The program and its arguments for one text, of which control characters and asterisks are left out; never for `none`.
[[nodiscard]] std::vector<std::string> make_voice_words(const VoiceSettings& settings,
                                                        std::string_view text);

}  // namespace fulcrum::runtime
