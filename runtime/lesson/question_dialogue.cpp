#include "runtime/lesson/question_dialogue.h"

#include "dialogue/marking/answer_hints.h"
#include "dialogue/marking/mark_answer.h"
#include "dialogue/marking/readings.h"

#include <algorithm>
#include <cassert>

namespace fulcrum::runtime {
namespace {

constexpr double kRepeatPatience_s = 12.0;  // an invitation to say it once more waits this long

AnsweredEvent answered_event(const MarkedAnswer& answer) {
    AnsweredEvent answered;
    answered.question = answer.question;
    answered.said = answer.mark.said;
    answered.slots = answer.mark.slots;
    answered.understood = answer.mark.understood;
    answered.right = answer.right;
    answered.form_right = answer.mark.understood && answer.mark.form_right();
    answered.form_known = answer.mark.form_known;
    answered.turned_round = answer.mark.turned_round;
    answered.over = !answer.feedback.ask_again;
    answered.attempt = answer.feedback.attempt;
    answered.replay = answer.feedback.replay;
    return answered;
}

}  // namespace

QuestionDialogue::QuestionDialogue(Questions questions, const dialogue::Catalogue& catalogue,
                                   dialogue::ConversationSettings settings)
    : questions_(std::move(questions)), conversation_(catalogue, std::move(settings)) {}

QuestionTurn QuestionDialogue::ask(const std::string& question, double time_s) {
    const auto declared = questions_.find(question);
    assert(declared != questions_.end());
    QuestionTurn turn;
    const bool is_same = question == question_;
    if (!is_same && is_invited()) {
        turn.events.push_back(*right_);
    }
    const std::vector<std::string> prompt =
        is_same ? conversation_.ask_again() : conversation_.ask(declared->second);
    for (const std::string& line : prompt) {
        turn.prompt += (turn.prompt.empty() ? "" : "\n") + line;
    }
    forget();
    question_ = question;
    listen(time_s);
    return turn;
}

QuestionTurn QuestionDialogue::hear(std::string_view words, double confidence, double time_s,
                                    bool form) {
    if (!listens()) {
        return {};
    }
    heard_ = conversation_.hear(words, confidence, form);
    // What a slot would hold is no word of its list: it can't be right, and the lesson is not asked.
    if (!heard_->understood || !heard_->other_number.empty()) {
        return answer(false, time_s);
    }
    // The words are understood; the simulated physics says whether their meaning is right.
    QuestionTurn turn;
    verdicts_.clear();
    for (const dialogue::Slots& reading : dialogue::readings_of(*heard_)) {
        turn.events.push_back(JudgeEvent{question_, reading});
    }
    return turn;
}

QuestionTurn QuestionDialogue::take_question(dialogue::Mark asked, double time_s) {
    if (!listens()) {
        return {};
    }
    (void)conversation_.hear(asked.said, asked.confidence, asked.form_known);
    heard_ = std::move(asked);
    return answer(true, time_s);
}

QuestionTurn QuestionDialogue::judge(const std::string& question, bool right, double time_s) {
    if (!heard_ || question != question_) {
        return {};
    }
    verdicts_.push_back(right);
    if (verdicts_.size() < dialogue::readings_of(*heard_).size()) {
        return {};  // the others come with the same reply
    }
    return answer(dialogue::settle(*heard_, verdicts_), time_s);
}

// The verdict is there: how the question stands follows from it, and what the lesson is told.
QuestionTurn QuestionDialogue::answer(bool right, double time_s) {
    QuestionTurn turn;
    MarkedAnswer& answer =
        turn.answer.emplace(MarkedAnswer{conversation_.respond(std::move(*heard_), right),
                                         question_, std::max(0.0, time_s - asked_at_s_)});
    heard_.reset();
    if (answer.feedback.may_repeat) {
        right_ = answered_event(answer);
    }
    if (answer.feedback.came.action == dialogue::CourseAction::listen) {
        invited_until_s_ = time_s + kRepeatPatience_s;
        listen(time_s);
        return turn;
    }
    turn.events.push_back(right_ ? *right_ : answered_event(answer));
    if (!answer.feedback.ask_again) {
        forget();
    }
    return turn;
}

QuestionTurn QuestionDialogue::step(double time_s) {
    QuestionTurn turn;
    if (listens() && is_invited() && time_s >= invited_until_s_) {
        turn.events.push_back(*right_);
        conversation_.happen(dialogue::CourseEvent::time);
        forget();
    }
    return turn;
}

void QuestionDialogue::end_exchange() {
    heard_.reset();
    conversation_.happen(dialogue::CourseEvent::withdraw);
}

void QuestionDialogue::close() {
    conversation_.happen(dialogue::CourseEvent::close);
    forget();
}

void QuestionDialogue::forget() {
    question_.clear();
    heard_.reset();
    right_.reset();
}

void QuestionDialogue::listen(double time_s) {
    asked_at_s_ = time_s;
    ++turns_;
}

void QuestionDialogue::wait_anew(double time_s) {
    if (listens()) {
        listen(time_s);
    }
}

bool QuestionDialogue::understands(std::string_view words) const {
    return question() != nullptr && dialogue::mark_answer(*question(), words).understood;
}

bool QuestionDialogue::wants_question() const {
    return listens() && question() != nullptr &&
           dialogue::example_sentence(*question()).ends_with('?');
}

const dialogue::Question* QuestionDialogue::question() const {
    const auto question = questions_.find(question_);
    return question == questions_.end() ? nullptr : &question->second;
}

std::shared_ptr<const dialogue::TemplateSet> QuestionDialogue::templates() const {
    return question() == nullptr ? nullptr : question()->templates;
}

}  // namespace fulcrum::runtime
