// Hears through a microphone on a thread of its own, and gives whole utterances.
//
//   microphone --10 ms--> gate (utterance_gate.h) --utterance--> [waiting] --take--> recogniser
//   listen, hold, speak: how things stand, from the thread of the window
// Without a microphone, or when it is unplugged, there is one sentence; it is looked for again every few seconds. One that gives only
// zeros for some seconds is switched off, and told once too.
//
// Thread: one asks and takes and never waits for the other, which looks every 10 ms. Cost: `take` a lock of some microseconds.
#pragma once

#include "runtime/audio/microphone.h"
#include "runtime/hearing/utterance_gate.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// For the picture.
struct EarState {
    bool has_microphone = true;  ///< false as long as there is none
    bool hears = false;          ///< an utterance is under way
    bool deaf = false;           ///< the program speaks, or has just done so
    double level = 0.0;          ///< 0 to 1: kQuietest_dB to full scale, falling slowly
};

class Ear {
  public:
    static constexpr double kQuietest_dB = -60.0;  ///< of full scale

    /// The settings have been validated. Opens the microphone on its own thread; where there is none, again every `retry_s`.
    Ear(const GateSettings& settings, OpenMicrophone open, double retry_s = 2.0);
    Ear(const Ear&) = delete;
    Ear& operator=(const Ear&) = delete;
    ~Ear();

    /// Whether somebody wants to know what the learner says. What is said otherwise is dropped.
    void listen(bool wanted);
    /// Whether the key is down.
    void hold(bool down);
    /// Whether the program itself is heard.
    void speak(bool speaks);
    [[nodiscard]] EarState state() const;
    /// The next utterance, at dialogue::kHeardRate_Hz.
    [[nodiscard]] std::optional<std::vector<std::int16_t>> take();
    /// What somebody should know, once; empty otherwise.
    [[nodiscard]] std::string take_trouble();

  private:
    struct Work;
    std::unique_ptr<Work> work_;
};

}  // namespace fulcrum::runtime
