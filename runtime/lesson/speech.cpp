#include "runtime/lesson/speech.h"

#include "dialogue/speech/null/null_recogniser.h"

#include <utility>
#include <vector>

namespace fulcrum::runtime {
namespace {

// At once, whatever was being said.
void say_anew(dialogue::Voice& voice, std::string_view text) {
    voice.stop();
    voice.say(text);
}

}  // namespace

Speech Speech::build(const Plan& plan) {
    Speech speech;
    if (!plan.dialogue) {
        speech.recogniser_ = std::make_unique<dialogue::NullRecogniser>();
        return speech;
    }
    switch (plan.speech) {
        case SpeechInput::text: {
            auto text = std::make_unique<dialogue::TextRecogniser>();
            speech.typed_ = text.get();
            speech.recogniser_ = std::move(text);
            break;
        }
    }
    return speech;
}

void Speech::type(std::string words) {
    if (typed_ != nullptr && typed_->listening()) {
        typed_->type(std::move(words));
    }
}

Expected<void> Speech::listen(std::shared_ptr<const dialogue::TemplateSet> templates) {
    recogniser_->stop();
    const auto listening = recogniser_->listen(std::move(templates));
    if (!listening) {
        return fail("nobody can listen for the answers: " + listening.error().message, "lesson.lua",
                    "mend the question's answers");
    }
    return {};
}

std::optional<dialogue::Hypothesis> Speech::poll() {
    std::vector<dialogue::Hypothesis> heard = recogniser_->poll();
    return heard.empty() ? std::nullopt : std::optional(std::move(heard.front()));
}

void Speech::instruct(std::string_view text) {
    if (!text.empty() && text != instruction()) {
        spoken_.emplace_back(text);
    }
    say_anew(*instruction_, text);
    reply_is_past_ = true;
    end_past_reply();
}

void Speech::reply(std::string_view text) {
    if (!text.empty()) {
        spoken_.emplace_back(text);
    }
    say_anew(*reply_, text);
    reply_is_past_ = false;
}

void Speech::step(double dt_s) {
    instruction_->step(dt_s);
    reply_->step(dt_s);
    end_past_reply();
}

void Speech::end_past_reply() {
    if (reply_is_past_ && !reply_->speaking()) {
        reply_->stop();
    }
}

}  // namespace fulcrum::runtime
