// Answers as text: typed by the learner, or read from a script that gives one line to each question in turn.
//
// Thread: one.  Cost: a queue.
#pragma once

#include "dialogue/speech/recogniser.h"

#include <deque>
#include <string>
#include <vector>

namespace fulcrum::dialogue {

inline constexpr std::size_t kMostTypedAnswers =
    64;  ///< unread ones; further ones are dropped and counted

/// Typed or scripted answers.
class TextRecogniser final : public Recogniser {
  public:
    TextRecogniser() = default;
    /// A script: each `listen` is answered by the next line.
    explicit TextRecogniser(std::vector<std::string> script)
        : script_(script.begin(), script.end()) {}

    /// The learner typed `text`; it answers the listening of now, or the next. Empty and blank texts are no answers.
    void type(std::string text);

    [[nodiscard]] Expected<bool> listen(std::shared_ptr<const TemplateSet> templates) override;
    [[nodiscard]] std::vector<Hypothesis> poll() override;
    void stop() override;
    [[nodiscard]] bool listening() const override { return listening_; }
    [[nodiscard]] std::string_view name() const override { return "text"; }

    /// Lines of the script that nobody has asked for yet.
    [[nodiscard]] std::size_t script_left() const { return script_.size(); }
    /// Typed answers that found the queue full.
    [[nodiscard]] std::size_t dropped() const { return dropped_; }

  private:
    std::deque<std::string> script_;
    std::deque<std::string> typed_;
    bool listening_ = false;
    std::size_t dropped_ = 0;
};

/// The lines of a script's text; empty lines and those that begin with # are left out.
[[nodiscard]] std::vector<std::string> script_lines(std::string_view text);

}  // namespace fulcrum::dialogue
