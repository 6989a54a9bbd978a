// Hears by a program beside this one (dialogue/speech/external/hearing_lines.h), which is told what may be said and given the sound.
//
//   listen(templates) -> word graph -> program;   sound -> program;   its text and confidence -> poll
//   an utterance of a microphone (ear.h) -> hear
// Where recordings are given, each question is answered by the next of them. A run without a window waits for the program's answer, so that
// it goes the same each time; a live one never waits. Without the program, or when it fails, there is one sentence, and typing goes on.
//
// Thread: one, that of the lesson loop. Cost: a system call or two a poll; the program's own work is its own.
#pragma once

#include "dialogue/speech/external/hearing_lines.h"
#include "dialogue/speech/recogniser.h"
#include "haptics/base/error.h"
#include "runtime/files/line_program.h"

#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace fulcrum::runtime {

struct HearingSettings {
    std::vector<std::string> words;       ///< the program and its arguments
    std::vector<std::string> recordings;  ///< WAV files, one for each question in turn
    bool waits = false;                   ///< for answers, as runs without a window do
    /// What fits nothing was said to somebody else: it is passed over, and nobody is asked to say it again.
    bool passes_over = false;
};

class ExternalRecogniser final : public dialogue::Recogniser {
  public:
    /// Starts the program; its models may still load.
    [[nodiscard]] static fulcrum::Expected<std::unique_ptr<ExternalRecogniser>> create(
        HearingSettings settings);

    [[nodiscard]] dialogue::Expected<bool> listen(
        std::shared_ptr<const dialogue::TemplateSet> templates) override;
    [[nodiscard]] std::vector<dialogue::Hypothesis> poll() override;
    void stop() override;
    [[nodiscard]] bool listening() const override { return listening_; }
    [[nodiscard]] std::string_view name() const override { return name_; }

    /// An utterance, at dialogue::kHeardRate_Hz, that answers what is listened for; nothing comes of it where nothing is.
    void hear(std::span<const std::int16_t> utterance);
    /// What somebody should know of it, once each: words that it cannot hear, that it has ended; empty otherwise.
    [[nodiscard]] std::string take_trouble();
    /// How much smaller than a grown-up's the learner's throat is, as the program has heard it; 0: it has not told.
    [[nodiscard]] double throat() const { return throat_; }

  private:
    ExternalRecogniser(HearingSettings settings, std::unique_ptr<LineProgram> program);
    void speak_recording();
    void take_lines();
    void take(const dialogue::HearingAnswer& answer);
    void tell(const std::string& sentence);

    HearingSettings settings_;
    std::unique_ptr<LineProgram> program_;
    std::string name_ = "external";
    bool hears_form_ = true;
    double throat_ = 0.0;
    std::size_t next_recording_ = 0;
    int question_ = 0;
    bool listening_ = false;
    bool awaits_ = false;  // an utterance has been given, and not answered
    std::vector<dialogue::Hypothesis> heard_;
    std::deque<std::string> troubles_;
};

}  // namespace fulcrum::runtime
