#include "dialogue/conversation/conversation.h"

#include "dialogue/marking/mark_answer.h"
#include "dialogue/template/tokens.h"

#include <algorithm>
#include <utility>

namespace fulcrum::dialogue {

Conversation::Conversation(const Catalogue& catalogue, ConversationSettings settings)
    : catalogue_(&catalogue), settings_(std::move(settings)) {}

std::vector<std::string> Conversation::ask(const Question& question, int number, int of) {
    happen(CourseEvent::ask);
    question_ = question;
    count_anew();
    std::vector<std::string> lines = sentences_of(question.prompt);
    if (number > 0) {
        const CatalogueSlots slots{{"n", std::to_string(number)},
                                   {"of", std::to_string(std::max(of, number))}};
        lines.insert(lines.begin(), catalogue_->say("question.number", slots));
    }
    return lines;
}

std::vector<std::string> Conversation::ask_again() {
    if (happen(CourseEvent::resume).action != CourseAction::resume) {
        count_anew();
    }
    return question_ ? sentences_of(question_->prompt) : std::vector<std::string>{};
}

void Conversation::count_anew() {
    attempt_ = wrong_ = unheard_ = bad_repeats_ = 0;
    wanted_help_ = false;
}

CourseStep Conversation::happen(CourseEvent event) {
    const CourseStep came = step(state_, event);
    state_ = came.next;
    return came;
}

Mark Conversation::hear(std::string_view text, double confidence, bool form) {
    if (!question_) {
        return {};
    }
    happen(CourseEvent::hear);
    Mark mark = mark_answer(*question_, text, confidence);
    if (!form) {
        return without_form(std::move(mark));
    }
    std::optional<Mark> put_right = mark_put_right(mark);
    return put_right ? std::move(*put_right) : std::move(mark);
}

Turn Conversation::respond(Mark mark, bool meaning_right) {
    Turn turn;
    turn.mark = std::move(mark);
    turn.right = meaning_right;
    turn.level = settings_.level;
    if (!is_judging(state_)) {
        return turn;
    }
    turn.asked = &*question_;
    const CourseEvent verdict = judge(turn);
    turn.feedback.attempt = attempt_;
    turn.feedback.came = happen(verdict);
    if (turn.right && turn.mark.claim == Claim::excluded) {
        turn.mark.understood = turn.right = false;  // as good as not said: neither right nor wrong
    }
    turn.feedback.ask_again = verdict == CourseEvent::unclear || verdict == CourseEvent::wrong;
    return turn;
}

CourseEvent Conversation::judge(Turn& turn) {
    const Mark& mark = turn.mark;
    if (!heard_well(mark.confidence)) {
        return hear_badly(turn);
    }
    ++attempt_;
    if (is_invited(state_)) {
        return judge_repeat(turn);
    }
    if (!mark.understood) {
        return hear_nothing_known(turn);
    }
    if (!turn.right || !mark.other_number.empty()) {
        return judge_wrong(turn);
    }
    return mark.claim == Claim::excluded ? leave_open(turn) : judge_form(turn);
}

// It is no attempt, and says nothing of an invitation. A right answer is not held back for it: after some the invitation is over.
CourseEvent Conversation::hear_badly(Turn& turn) {
    constexpr int kMostBadRepeats = 2;
    turn.feedback.kind = FeedbackKind::heard_badly;
    if (!is_invited(state_) || ++bad_repeats_ <= kMostBadRepeats) {
        return CourseEvent::unclear;
    }
    turn.accepted = accepted_;
    return CourseEvent::right;
}

CourseEvent Conversation::judge_form(Turn& turn) {
    Feedback& feedback = turn.feedback;
    const FormError* error = turn.mark.main_error();
    const bool is_rest_good = read_rest(turn);
    feedback.free_errors = turn.checked.errors;
    if (error == nullptr) {
        // Of what nobody understood nothing is praised; an error that is sure is told.
        turn.has_more = !is_rest_good;
        const bool is_told = !turn.joined.empty() || find_alone(turn.checked.errors) != nullptr;
        feedback.kind = turn.has_more && is_told ? FeedbackKind::recast : FeedbackKind::praise;
        // A whole right sentence: the ladder begins anew. A short answer and an unknown form show nothing of it.
        if (is_rest_good && !turn.mark.short_answer && turn.mark.form_known) {
            seen_.clear();
        }
        return CourseEvent::right;
    }
    const FeedbackLadder& ladder = question_->ladder.empty() ? settings_.ladder : question_->ladder;
    const std::string seen = std::string(error->errant()) + "/" + rule_key(*error);
    switch (step_at(ladder, ++seen_[seen])) {
        case FeedbackStep::recast:
            feedback.kind = FeedbackKind::recast;
            break;
        case FeedbackStep::prompt:
            feedback.kind = FeedbackKind::prompt;
            feedback.may_repeat = true;
            accepted_ = turn.mark;
            return CourseEvent::invite;
        case FeedbackStep::rule:
            feedback.kind = FeedbackKind::rule;
            break;
        case FeedbackStep::replay:
            feedback.kind = FeedbackKind::replay;
            feedback.replay = true;
            break;
    }
    return CourseEvent::right;
}

CourseEvent Conversation::judge_repeat(Turn& turn) {
    const Mark& mark = turn.mark;
    // What was said only needs its own error away; a short answer shows nothing about it.
    const bool is_repaired =
        mark.understood && turn.right && mark.form_right() && !mark.short_answer;
    turn.feedback.kind = is_repaired ? FeedbackKind::praise : FeedbackKind::recast;
    turn.accepted = accepted_;
    if (mark.form_known) {
        turn.feedback.uptake = is_repaired ? Uptake::repaired : Uptake::not_repaired;
    }
    if (is_repaired) {
        seen_.clear();
    }
    return CourseEvent::right;
}

CourseEvent Conversation::hear_nothing_known(Turn& turn) {
    if (++unheard_ >= settings_.unheard_tries && settings_.unheard_tries > 0) {
        turn.feedback.kind = FeedbackKind::moved_on;
        return CourseEvent::give_up;
    }
    turn.feedback.kind = FeedbackKind::not_understood;
    // Who asks for help needs no second try.
    const bool asks_help = wants_help(turn.mark.said);
    wanted_help_ = wanted_help_ || asks_help;
    const int rung = wanted_help_ ? unheard_ + 1 : unheard_;
    turn.rung = rung;
    if (!asks_help) {
        check_form(turn);
    }
    return CourseEvent::unclear;
}

// It is true, and no answer yet; it is no wrong one either.
CourseEvent Conversation::leave_open(Turn& turn) {
    if (settings_.unheard_tries > 0 && ++unheard_ >= settings_.unheard_tries) {
        turn.feedback.kind = FeedbackKind::moved_on;
        return CourseEvent::give_up;
    }
    turn.feedback.kind = FeedbackKind::not_understood;
    turn.leaves_open = true;
    return CourseEvent::unclear;
}

bool Conversation::wants_help(std::string_view said) const {
    const std::vector<std::string> words = words_of(said);
    const std::vector<std::string> keys = catalogue_->series("help.said");
    return std::any_of(keys.begin(), keys.end(), [&](const std::string& key) {
        return words_of(catalogue_->say(key)) == words;
    });
}

CourseEvent Conversation::judge_wrong(Turn& turn) {
    if (++wrong_ >= settings_.tries && settings_.tries > 0) {
        turn.feedback.kind = FeedbackKind::moved_on;
        return CourseEvent::give_up;
    }
    turn.feedback.kind = FeedbackKind::wrong_meaning;
    turn.feedback.replay = !turn.mark.turned_round;
    if (turn.feedback.replay && !turn.mark.other_number.empty()) {
        check_form(turn);  // no template marks its form
    }
    return CourseEvent::wrong;
}

std::vector<std::string> sentences_of(std::string_view text) {
    std::vector<std::string> lines;
    std::string line;
    const auto flush = [&] {
        const std::size_t first = line.find_first_not_of(' ');
        if (first != std::string::npos) {
            lines.push_back(line.substr(first));
        }
        line.clear();
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\n') {
            flush();
            continue;
        }
        line.push_back(text[i]);
        const bool ends = text[i] == '.' || text[i] == '?' || text[i] == '!';
        if (ends && (i + 1 == text.size() || text[i + 1] == ' ')) {
            flush();
        }
    }
    flush();
    return lines;
}

}  // namespace fulcrum::dialogue
