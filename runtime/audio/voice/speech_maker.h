// Makes sound of text on a thread of its own, one text after another.
//
//   ask(text) -> [waiting] -> a program speaks (run_program) -> WAV -> 48 kHz -> [ready] -> take()
// Texts of the last minute are kept, so that what is said again is there at once. A program that is missing or fails says so
// once; after that there is silence, and the captions stay.
//
// Thread: one asks and takes; it never waits for the other. Cost: `ask` and `take` a lock of some microseconds.
#pragma once

#include "runtime/audio/voice/voice_program.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::runtime {

/// A text as sound.
struct MadeSpeech {
    std::string text;
    std::vector<float> samples;  ///< mono, kSampleRate_Hz; empty where it could not be made
};

class SpeechMaker {
  public:
    explicit SpeechMaker(const VoiceSettings& settings);
    SpeechMaker(const SpeechMaker&) = delete;
    SpeechMaker& operator=(const SpeechMaker&) = delete;
    /// Ends the program that runs.
    ~SpeechMaker();

    void ask(std::string_view text);
    /// The next that is made, in the order of the asking.
    [[nodiscard]] std::optional<MadeSpeech> take();
    /// Nothing that was asked for is made any more.
    void forget();
    /// Texts that were asked for and not taken yet.
    [[nodiscard]] int n_waiting() const;
    /// Why there is no voice, once; empty otherwise.
    [[nodiscard]] std::string take_trouble();

  private:
    struct Shop;
    std::unique_ptr<Shop> shop_;
};

}  // namespace fulcrum::runtime
