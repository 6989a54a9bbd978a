// What each command of a lesson does, and how a question is asked.
#include "dialogue/unicode.h"
#include "runtime/lesson/session.h"
#include "runtime/lesson/undeclared.h"
#include "runtime/progress/text_rules.h"

#include <algorithm>
#include <utility>

namespace fulcrum::runtime {
namespace {

bool is_index(std::int32_t index, std::size_t size) {
    return index >= 0 && static_cast<std::size_t>(index) < size;
}

}  // namespace

Expected<void> LessonSession::carry_out(const MoveCommand& command, SessionOutput& output) {
    const bool needs_body = command.move.kind != WorldCommand::Kind::release;
    if (needs_body && !is_index(command.move.body, description_.bodies.size())) {
        return undeclared();
    }
    if (command.move.kind == WorldCommand::Kind::drop) {
        sounds_.push_back("pop");
    } else if (command.move.kind == WorldCommand::Kind::hold) {
        sounds_.push_back(catch_sound(command.move.body));
    }
    output.world.push_back(command.move);
    return {};
}

Expected<void> LessonSession::carry_out(const CoverCommand& command, SessionOutput&) {
    if (!is_index(command.body, hud_.covered.size())) {
        return undeclared();
    }
    hud_.covered[static_cast<std::size_t>(command.body)] = command.covered;
    return {};
}

Expected<void> LessonSession::carry_out(const MarkCommand& command, SessionOutput&) {
    if (!is_index(command.body, hud_.marked_N.size())) {
        return undeclared();
    }
    hud_.marked_N[static_cast<std::size_t>(command.body)] = command.felt_N;
    return {};
}

Expected<void> LessonSession::carry_out(const LightCommand& command, SessionOutput&) {
    if (!is_index(command.body, hud_.lights.size())) {
        return undeclared();
    }
    hud_.lights[static_cast<std::size_t>(command.body)] = command.light;
    return {};
}

Expected<void> LessonSession::carry_out(const TurnCommand& command, SessionOutput&) {
    return hinges_.carry_out(command);
}

Expected<void> LessonSession::carry_out(const KiteCommand& command, SessionOutput&) {
    return kite_.carry_out(command);
}

Expected<void> LessonSession::carry_out(const WindCommand& command, SessionOutput&) {
    return kite_.carry_out(command);
}

Expected<void> LessonSession::carry_out(const FieldChangeCommand& command, SessionOutput&) {
    if (!is_index(command.force, description_.forces.size())) {
        return undeclared();
    }
    force_.fields[static_cast<std::size_t>(command.force)] = command.field;
    return {};
}

Expected<void> LessonSession::carry_out(const LessonForceCommand& command, SessionOutput&) {
    if (!description_.hand.lesson_force) {
        return undeclared();
    }
    force_.linearised = command.force;
    force_.linearised.stamp_s = clock_s_;
    return {};
}

Expected<void> LessonSession::carry_out(const CaptionCommand& command, SessionOutput&) {
    speech_.instruct(command.text);
    transcript_.show(time_s_, command.text);
    show();
    return {};
}

Expected<void> LessonSession::carry_out(const AskCommand& command, SessionOutput&) {
    if (!dialogue_.declares(command.question)) {
        return undeclared();
    }
    QuestionTurn turn = dialogue_.ask(command.question, time_s_);
    speech_.instruct(turn.prompt);
    transcript_.ask(time_s_, turn.prompt);
    take(std::move(turn));
    return {};
}

Expected<void> LessonSession::carry_out(const VerdictCommand& command, SessionOutput&) {
    if (!dialogue_.declares(command.question)) {
        return fail("the lesson judged an answer to \"" + command.question +
                        "\", a question that it never declared",
                    "lesson.lua", "judge the questions that L:question made");
    }
    take(dialogue_.judge(command.question, command.right, time_s_));
    return {};
}

Expected<void> LessonSession::carry_out(const TellCommand& command, SessionOutput&) {
    if (asked_for_ && asked_for_->knowledge == command.knowledge) {
        const std::string& said = asked_for_->mark.said;
        tell(said, question() != nullptr && !dialogue_.wants_question() &&
                           gives_away(*question(), said, command.text)
                       ? knowledge_->first_mine()
                       : knowledge_->told(*asked_for_, command.text));
        asked_for_.reset();
    }
    return {};
}

Expected<void> LessonSession::carry_out(const ScoreCommand& command, SessionOutput&) {
    hud_.score = result_.score = command.score;
    return {};
}

Expected<void> LessonSession::carry_out(const LevelCommand& command, SessionOutput&) {
    if (hud_.level > 0 && command.level > hud_.level) {
        sounds_.push_back("level_up");
    }
    transcript_.begin_level(time_s_, command.level, command.title);
    hud_.level = result_.level = command.level;
    hud_.level_title = command.title;
    return {};
}

Expected<void> LessonSession::carry_out(const SoundCommand& command, SessionOutput&) {
    sounds_.push_back(command.name);
    return {};
}

Expected<void> LessonSession::carry_out(const ShowHandCommand& command, SessionOutput&) {
    hud_.shown_hand_W = command.at_W;
    return {};
}

Expected<void> LessonSession::carry_out(const FinishCommand& command, SessionOutput&) {
    hud_.stars = result_.stars = std::clamp(command.stars, 0, 3);
    sounds_.push_back("finish");
    finish();
    return {};
}

Expected<void> LessonSession::carry_out(const EnterCommand& command, SessionOutput&) {
    if (result_.finished) {
        return {};  // the first of one frame
    }
    result_.entered = command.lesson;
    sounds_.push_back("click");
    finish();
    return {};
}

void LessonSession::finish() {
    hud_.shown_hand_W.reset();
    result_.finished = true;
    dialogue_.close();
    show();
    end(EndReason::finished);
}

Expected<void> LessonSession::carry_out(const PrintCommand& command, SessionOutput& output) {
    output.printed.push_back(command.text);
    return {};
}

namespace {

constexpr std::size_t kLongestAnswer_bytes = 400;

}  // namespace

// Whatever a keyboard, a file or a recogniser gives: clean UTF-8 in NFC, of a sentence's length.
void LessonSession::hear(const dialogue::Hypothesis& heard) {
    std::string words = dialogue::composed(kept_text(heard.text));
    words.resize(dialogue::whole_characters(words, kLongestAnswer_bytes).size());
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
            turn.answer->told = knowledge_->unknown();
        }
        take(std::move(turn));
    }
}

// The learner asks what nobody knows while a question is open: no answer, and no try of one either.
bool LessonSession::asks_instead(const std::string& words, double confidence) const {
    return dialogue_.listens() && !dialogue_.wants_question() && dialogue_.heard_well(confidence) &&
           asks_something(words) && !dialogue_.wants_help(words) && !dialogue_.understands(words);
}

// The learner asks: true when these words are none of an answer. A question that is open stays open, unless it invites to ask.
bool LessonSession::ask_for(const std::string& words, const dialogue::Hypothesis& heard) {
    const bool heard_well = dialogue_.heard_well(heard.confidence);
    // "It is made of glass" asks for nothing while a question is open, however much it is like "is it made of glass".
    const bool may_ask = heard_well && (!dialogue_.is_open() || begins_as_question(words));
    auto asked = may_ask ? knowledge_->find(words, heard.form) : std::nullopt;
    if (asked && dialogue_.wants_question()) {
        take_question(std::move(*asked), heard.confidence);
        return true;
    }
    if (!asked && dialogue_.is_open()) {
        return false;
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
    asked.praise = turn.answer ? talk_.own(*turn.answer).text : std::string();
    queued_.push_back(AskedEvent{asked.knowledge, asked.mark.slots});
    asked_for_ = std::move(asked);
    take(std::move(turn));
}

// To somebody who asked. A question that is open goes on waiting for its answer.
void LessonSession::tell(const std::string& said, const std::string& answer) {
    dialogue_.wait_anew(time_s_);
    transcript_.hear_asking(time_s_, said);
    keep_said(said);
    dialogue::Turn turn;
    turn.level = description_.level;
    turn.mark.said = said;
    turn.told = answer;
    talk_.take(turn);
    say_back();
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
    keep_said(std::string());
    hud_.mood = ViewMood::calm;
    speech_.reply(description_.bodies[i].about);
    transcript_.explain(time_s_, description_.bodies[i].about);
    show();
}

}  // namespace fulcrum::runtime
