// What listens to the learner and what speaks to them in one play: exactly what the plan has.
//
//   typed, scripted --type--> recogniser --poll--> heard        listens only while the learner may speak
//   spoken ------------------> the plan's recogniser, if it has one; typing goes on beside it
//   instruct, reply --> captions --> what the picture shows      an instruction ends a reply once it could be read
//                   --> take_spoken --> whoever says it aloud    what stands there already is not said again
//
// Another way to hear or to speak is another implementation of dialogue/speech's interfaces, chosen in `build`.
//
// Thread: lesson loop.  Cost: a queue.
#pragma once

#include "dialogue/speech/captions/caption_voice.h"
#include "dialogue/speech/text/text_recogniser.h"
#include "haptics/base/error.h"
#include "runtime/hearing/external_recogniser.h"
#include "runtime/scene/plan.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fulcrum::runtime {

class Speech {
  public:
    /// Typing, and the recogniser of the plan's choice beside it; for a lesson without questions nobody ever listens.
    [[nodiscard]] static Speech build(const Plan& plan);

    /// Words that were typed, or that a script says. Nothing comes of them unless somebody listens.
    void type(std::string words);
    /// An utterance of a microphone, for the plan's recogniser. Likewise.
    void hear(std::span<const std::int16_t> utterance);
    /// Listens for one answer; what was half said before is forgotten. The error says why it cannot.
    [[nodiscard]] Expected<void> listen(std::shared_ptr<const dialogue::TemplateSet> templates);
    /// Likewise for what the learner may ask. Recordings are answers, and are not spent on it.
    [[nodiscard]] Expected<void> listen_for_asking(
        std::shared_ptr<const dialogue::TemplateSet> templates);
    void stop_listening();
    [[nodiscard]] bool listening() const { return typed_->listening(); }
    /// The answer, once, as far as the recogniser is sure of it.
    [[nodiscard]] std::optional<dialogue::Hypothesis> poll();
    /// "text" or "null", or as the program that hears calls itself.
    [[nodiscard]] std::string_view recogniser_name() const;
    /// How much smaller than a grown-up's the learner's throat was heard to be; 0: not heard.
    [[nodiscard]] double throat() const { return hearing_ ? hearing_->throat() : 0.0; }
    /// What somebody should know of who hears, a sentence each, once.
    [[nodiscard]] std::vector<std::string> take_troubles();

    /// What to do now, or a question; empty: nothing. A reply stands on below it until it has stood its reading time, below nothing until
    /// the next. What stands there and is being read already is not said once more.
    void instruct(std::string_view text);
    /// To the learner's answer; *asterisks* are emphasis.
    void reply(std::string_view text);
    void step(double dt_s);
    /// What is to be said aloud since the last time, in order.
    [[nodiscard]] std::vector<std::string> take_spoken() { return std::exchange(spoken_, {}); }
    /// As they stand in the picture, with their asterisks.
    [[nodiscard]] const std::string& instruction() const { return instruction_->caption().said; }
    [[nodiscard]] const std::string& last_reply() const { return reply_->caption().said; }

  private:
    Speech() = default;
    void speak(std::string_view text);
    void end_past_reply();
    [[nodiscard]] Expected<void> listen(std::shared_ptr<const dialogue::TemplateSet> templates,
                                        bool hears);

    bool has_recordings_ = false;  // they are heard instead of a microphone
    bool asks_ = false;            // the lesson has questions
    std::unique_ptr<dialogue::TextRecogniser> typed_ = std::make_unique<dialogue::TextRecogniser>();
    std::unique_ptr<ExternalRecogniser> hearing_;  // null where answers are typed alone
    std::vector<std::string> troubles_;
    std::unique_ptr<dialogue::CaptionVoice> instruction_ =
        std::make_unique<dialogue::CaptionVoice>();
    std::unique_ptr<dialogue::CaptionVoice> reply_ = std::make_unique<dialogue::CaptionVoice>();
    std::vector<std::string> spoken_;
    bool reply_is_past_ = false;  // an instruction came after it
};

}  // namespace fulcrum::runtime
