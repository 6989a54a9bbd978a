// Cuts what a microphone gives into what a learner says to the lesson.
//
//            speech for kOnset blocks (always), or the key goes down (hold)
//   idle  ────────────────────────────────────────────────────────────────▶  hears: with what came shortly before
//   idle  ◀────────────────────────────────────────────────────────────────  quiet for pause_s (always), or the key has been up for
//            release_s (hold), or most_s are full: an utterance, where least_s of it were spoken (always) or held (hold)
//   any   ─▶ idle: nobody wants to know any more, or the program itself speaks; what was half heard is dropped
// What lies further than before_s before the first speech in it or behind the last is cut off: a recogniser is the less sure the longer
// it hears nothing. Where there is no speech at all, it stays as it is, and the recogniser says so.
// While the program speaks, and as long after that as a room rings, the gate is deaf: it would hear the program.
//
// Thread: one. Cost: that of voice_activity.h a block.
#pragma once

#include "haptics/base/error.h"
#include "runtime/hearing/voice_activity.h"
#include "runtime/scene/listen_mode.h"

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

namespace fulcrum::runtime {

struct GateSettings {
    ListenMode mode = ListenMode::hold;
    double before_s = 0.3;   ///< 0 to 2: of what lies before and behind speech, that goes with it
    double pause_s = 0.8;    ///< 0.1 to 5: learners stop to think between words
    double release_s = 0.3;  ///< 0 to 2: the last sound comes when the key is up already
    double least_s = 0.2;    ///< 0 to 2: what is shorter was a knock, or a key that was brushed
    double most_s = 15.0;    ///< 1 to 60
    double ring_s = 0.3;     ///< 0 to 2: how long a room rings after the program's own voice
    VoiceActivitySettings voice{};
};

[[nodiscard]] Expected<void> validate(const GateSettings& settings);

/// How things stand while a block is heard.
struct GateInput {
    bool wanted = false;  ///< somebody listens for an answer
    bool held = false;    ///< the key
    bool speaks = false;  ///< the program's own voice
};

class UtteranceGate {
  public:
    /// The settings have been validated.
    explicit UtteranceGate(const GateSettings& settings)
        : settings_(settings), activity_(settings.voice) {}

    /// The next block; an utterance when it ends with this one, at dialogue::kHeardRate_Hz.
    std::optional<std::vector<std::int16_t>> step(std::span<const std::int16_t, kBlock> block,
                                                  const GateInput& input);
    /// An utterance is under way.
    [[nodiscard]] bool hears() const { return hears_; }
    /// What is said now is lost.
    [[nodiscard]] bool deaf() const { return deaf_s_ > 0.0; }

    static constexpr int kOnset = 3;  ///< blocks of speech in a row

  private:
    [[nodiscard]] bool begins(const GateInput& input, bool is_speech);
    [[nodiscard]] bool ends(const GateInput& input, bool is_speech);
    void forget();
    void note(bool is_speech);
    [[nodiscard]] std::vector<std::int16_t> cut_out();

    GateSettings settings_;
    VoiceActivity activity_;
    std::deque<std::int16_t> before_;
    std::vector<std::int16_t> heard_;
    std::size_t first_ = 0;  // sample of it with which speech began
    std::size_t last_ = 0;   // and behind which it ended; 0: none yet
    bool hears_ = false;
    bool was_held_ = false;
    int onset_ = 0;
    double deaf_s_ = 0.0;    // so long still
    double quiet_s_ = 0.0;   // since speech, or since the key went up
    double spoken_s_ = 0.0;  // of the utterance under way: speech, or with the key down
};

}  // namespace fulcrum::runtime
