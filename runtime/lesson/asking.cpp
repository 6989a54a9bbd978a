// What a learner says: an answer, or a question of their own.
#include "runtime/lesson/session.h"
#include "runtime/progress/text_rules.h"

#include <utility>

namespace fulcrum::runtime {
namespace {

constexpr std::size_t kLongestAnswer_bytes = 400;

}  // namespace

// Whatever a keyboard, a file or a recogniser gives: clean UTF-8 of a sentence's length.
void LessonSession::hear(const dialogue::Hypothesis& heard) {
    std::string words = kept_text(heard.text);
    if (words.size() > kLongestAnswer_bytes) {
        words = kept_text(std::string_view(words).substr(0, kLongestAnswer_bytes));
    }
    const bool may_be_asking =
        knowledge_ && (dialogue_.wants_question() || !dialogue_.understands(words));
    if (knowledge_ && !may_be_asking && !dialogue_.listens()) {
        tell(words, knowledge_->not_now());  // it was set aside, to be felt again
    } else if (may_be_asking && ask_for(words, heard)) {
        return;
    } else if (asks_instead(words, heard.confidence)) {
        tell(words, catalogue_->say("knowledge.unknown_now"));
    } else {
        QuestionTurn turn = dialogue_.hear(words, heard.confidence, time_s_, heard.form);
        // Who was invited to ask, and asks what nobody knows, is told so.
        const bool unknown = turn.answer && knowledge_ && dialogue_.wants_question() &&
                             turn.answer->feedback.kind == dialogue::FeedbackKind::not_understood &&
                             begins_as_question(words);
        if (unknown) {
            turn.answer->feedback.text = knowledge_->unknown();
        }
        take(std::move(turn));
    }
}

// The learner asks what nobody knows while a question is open: no answer, and no try of one either.
bool LessonSession::asks_instead(const std::string& words, double confidence) const {
    return dialogue_.listens() && !dialogue_.wants_question() && dialogue_.heard_well(confidence) &&
           asks_something(words) && !dialogue_.wants_help(words) && !dialogue_.understands(words);
}

// The learner asks: true when these words are none of an answer. A question that is open comes first, unless it invites to ask.
bool LessonSession::ask_for(const std::string& words, const dialogue::Hypothesis& heard) {
    const bool heard_well = dialogue_.heard_well(heard.confidence);
    // "It is made of glass" asks for nothing while a question is open, however much it is like "is it made of glass".
    const bool may_ask = heard_well && (!dialogue_.is_open() || begins_as_question(words));
    auto asked = may_ask ? knowledge_->find(words, heard.form) : std::nullopt;
    if (asked && dialogue_.wants_question()) {
        take_question(std::move(*asked), heard.confidence);
        return true;
    }
    if (dialogue_.is_open()) {
        if (asked) {
            tell(words, knowledge_->first_mine());
        }
        return asked.has_value();
    }
    if (!asked) {
        tell(words, heard_well ? knowledge_->unknown() : knowledge_->heard_badly());
        return true;
    }
    queued_.push_back(AskedEvent{asked->knowledge, asked->mark.slots});
    asked_for_ = std::move(asked);
    return true;
}

// "Now you ask me!": what is asked is a right answer, and is answered.
void LessonSession::take_question(AskedFor asked, double confidence) {
    asked.mark.confidence = confidence;
    QuestionTurn turn = dialogue_.take_question(asked.mark, time_s_);
    asked.praise = turn.answer ? turn.answer->feedback.text : std::string();
    queued_.push_back(AskedEvent{asked.knowledge, asked.mark.slots});
    asked_for_ = std::move(asked);
    take(std::move(turn));
}

// To somebody who asked. A question that is open goes on waiting for its answer.
void LessonSession::tell(const std::string& said, const std::string& answer) {
    dialogue_.wait_anew(time_s_);
    speech_.reply(answer);
    transcript_.tell(time_s_, said, answer);
    show();
}

// What there is to say of a thing, when it is touched or caught for the first time and nobody is waited for; under a cloth it would
// give it away.
void LessonSession::tell_about(std::int32_t body) {
    const auto i = static_cast<std::size_t>(body);
    if (i >= told_about_.size() || told_about_[i] || hud_.covered[i] || dialogue_.is_open() ||
        description_.bodies[i].about.empty()) {
        return;
    }
    told_about_[i] = true;
    speech_.reply(description_.bodies[i].about);
    transcript_.explain(time_s_, description_.bodies[i].about);
    show();
}

}  // namespace fulcrum::runtime
