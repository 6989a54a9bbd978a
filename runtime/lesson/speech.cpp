#include "runtime/lesson/speech.h"

#include "runtime/lesson/learner_throat.h"

#include <algorithm>
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
    speech.asks_ = plan.dialogue;
    speech.has_recordings_ = !plan.hearing.recordings.empty();
    if (plan.recogniser) {
        std::vector<std::string> words = plan.hearing.words;
        if (plan.hearing.takes_throat && plan.hearing.throat > 0.0) {
            words.insert(words.end(), {"--throat", throat_text(plan.hearing.throat)});
        }
        auto hearing = ExternalRecogniser::create(
            {.words = std::move(words),
             .recordings = plan.hearing.recordings,
             .waits = plan.waits_for_hearing,
             .passes_over = plan.microphone && plan.hearing.listen == ListenMode::always,
             .gives_up = plan.hearing.gives_up});
        if (hearing) {
            speech.hearing_ = std::move(*hearing);
        } else {
            speech.troubles_.push_back("Nobody hears: " + to_sentence(hearing.error()));
        }
    }
    return speech;
}

void Speech::type(std::string words) {
    if (typed_->listening()) {
        typed_->type(std::move(words));
    }
}

void Speech::hear(std::span<const std::int16_t> utterance) {
    if (hearing_) {
        hearing_->hear(utterance);
    }
}

Expected<void> Speech::listen(std::shared_ptr<const dialogue::TemplateSet> templates) {
    return listen(std::move(templates), true);
}

Expected<void> Speech::listen_for_asking(std::shared_ptr<const dialogue::TemplateSet> templates) {
    return listen(std::move(templates), !has_recordings_);
}

Expected<void> Speech::listen(std::shared_ptr<const dialogue::TemplateSet> templates, bool hears) {
    stop_listening();
    if (!asks_) {
        return {};
    }
    auto listening = typed_->listen(templates);
    if (listening && hearing_ && hears) {
        listening = hearing_->listen(std::move(templates));
    }
    if (!listening) {
        return fail("nobody can listen for the answers: " + listening.error().message, "lesson.lua",
                    "mend the question's answers");
    }
    return {};
}

void Speech::stop_listening() {
    typed_->stop();
    if (hearing_) {
        hearing_->stop();
    }
}

std::optional<dialogue::Hypothesis> Speech::poll() {
    std::vector<dialogue::Hypothesis> heard = typed_->poll();
    if (heard.empty() && hearing_) {
        heard = hearing_->poll();
    }
    if (heard.empty()) {
        return {};
    }
    stop_listening();  // whichever it was, the other one's turn is over too
    return std::move(heard.front());
}

std::string_view Speech::recogniser_name() const {
    if (!asks_) {
        return "null";
    }
    return hearing_ ? hearing_->name() : typed_->name();
}

std::vector<std::string> Speech::take_troubles() {
    while (hearing_) {
        std::string trouble = hearing_->take_trouble();
        if (trouble.empty()) {
            break;
        }
        troubles_.push_back(std::move(trouble));
    }
    return std::exchange(troubles_, {});
}

void Speech::instruct(std::string_view text) {
    if (text != instruction() && !(reply_->speaking() && text == last_reply())) {
        speak(text);
    }
    say_anew(*instruction_, text);
    // Where nothing is to be done the reply may stand on.
    reply_is_past_ = reply_is_past_ || !text.empty();
    end_past_reply();
}

void Speech::reply(std::string_view text) {
    if (!(instruction_->speaking() && text == instruction())) {
        speak(text);
    }
    say_anew(*reply_, text);
    reply_is_past_ = false;
}

void Speech::speak(std::string_view text) {
    if (!text.empty() && std::ranges::find(spoken_, text) == spoken_.end()) {
        spoken_.emplace_back(text);
    }
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
