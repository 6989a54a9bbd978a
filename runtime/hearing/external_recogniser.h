// Hears by a program beside this one (dialogue/speech/external/hearing_lines.h), which is told what may be said and given the sound.
//
//   listen(templates) -> word graph -> program;   sound -> program;   its text and confidence -> poll
//   an utterance of a microphone (ear.h) -> hear
// Where recordings are given, each question is answered by the next of them. A run without a window waits for the program's answer, so that
// it goes the same each time; a live one never waits. Without the program, or when it fails, there is one sentence, and typing goes on.
// It fails, and is ended, when it says much more than it is asked (more than 100 lines, and two for each that it got), or nothing of an
// utterance for 20 s.
//
// Thread: one, that of the lesson loop. Cost: some system calls and at most 64 lines a poll; the program's own work is its own.
#pragma once

#include "dialogue/speech/external/hearing_lines.h"
#include "dialogue/speech/recogniser.h"
#include "haptics/base/error.h"
#include "runtime/files/line_program.h"

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fulcrum::runtime {

struct HearingSettings {
    std::vector<std::string> words{};       ///< the program and its arguments
    std::vector<std::string> recordings{};  ///< WAV files, one for each question in turn
    bool waits = false;                     ///< for answers, as runs without a window do
    /// What fits nothing was said to somebody else: it is passed over, and nobody is asked to say it again.
    bool passes_over = false;
    double patience_s = 20.0;  ///< for what is heard in an utterance; then the program is ended
    std::function<bool()> gives_up = {};  ///< true: nobody waits any more; may be empty
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
    static constexpr int kFreeLines = 100;

    ExternalRecogniser(HearingSettings settings, std::unique_ptr<LineProgram> program);
    void speak_recording();
    void order(const dialogue::HearingOrder& line);
    void take_lines();
    [[nodiscard]] std::optional<std::string> next_line();
    void look_for_its_end();
    void end_for_silence();
    void take(const dialogue::HearingAnswer& answer);
    void take_words(const dialogue::HeardLine& heard);
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
    double waits_until_s_ = 0.0;
    int lines_left_ = kFreeLines;  // that it may say without being asked for more
    bool ready_ = false;
    bool said_nonsense_ = false;
    std::vector<dialogue::Hypothesis> heard_;
    std::deque<std::string> troubles_;
    std::string told_last_;
};

}  // namespace fulcrum::runtime
