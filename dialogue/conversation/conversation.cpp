#include "dialogue/conversation/conversation.h"

#include "dialogue/conversation/help.h"
#include "dialogue/conversation/recast.h"
#include "dialogue/english/letters.h"
#include "dialogue/marking/answer_hints.h"
#include "dialogue/marking/mark_answer.h"
#include "dialogue/template/tokens.h"

#include <algorithm>
#include <array>
#include <utility>

namespace fulcrum::dialogue {

namespace {

/// "a watermelon, an apple or an egg".
std::string listed(const Catalogue& catalogue, const std::vector<std::string>& words) {
    std::string list;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) {
            list += i + 1 == words.size() ? " " + catalogue.say("list.or")
                                          : catalogue.say("list.comma");
            list += " ";
        }
        list += words[i];
    }
    return list;
}

/// "Which one is heavier?": who names the other end of it tells of the other thing. Behind why and where, and of an "it", that is no such
/// answer.
bool asks_for_thing(const Question& question) {
    std::string asked;
    for (const std::string& sentence : sentences_of(question.prompt)) {
        asked = sentence.ends_with('?') ? words_between_blanks(sentence) : asked;
    }
    const bool wants_thing = std::ranges::any_of(
        std::array{" which ", " what ", " who "},
        [&](const char* word) { return asked.find(word) != std::string::npos; });
    const bool wants_reason = asked.starts_with(" why ") || asked.starts_with(" where ") ||
                              asked.starts_with(" when ") || asked.starts_with(" how ");
    const std::vector<std::string> answer = words_of(example_sentence(question));
    const std::size_t subject = !answer.empty() && answer.front() == "because" ? 1 : 0;
    return wants_thing && !wants_reason && subject < answer.size() && answer[subject] != "it";
}

}  // namespace

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

Feedback Conversation::respond(const Mark& mark, bool meaning_right) {
    if (!is_judging(state_)) {
        return {};
    }
    if (!heard_well(mark.confidence)) {
        return heard_badly();
    }
    ++attempt_;
    if (is_invited(state_)) {
        return respond_to_repeat(mark, meaning_right);
    }
    if (!mark.understood) {
        return not_understood(mark);
    }
    const bool right = meaning_right && mark.other_number.empty();
    if (right && mark.claim == Claim::excluded) {
        return leaves_open(mark);
    }
    return right ? respond_to_form(mark) : wrong_meaning(mark);
}

// It is no attempt, and says nothing of an invitation. A right answer is not held back for it: after some the invitation is over.
Feedback Conversation::heard_badly() {
    constexpr int kMostBadRepeats = 2;
    if (is_invited(state_) && ++bad_repeats_ > kMostBadRepeats) {
        return conclude(CourseEvent::right, say(FeedbackKind::heard_badly, recast_key(accepted_),
                                                {{"sentence", accepted_.emphasised}}));
    }
    return conclude(CourseEvent::unclear, say(FeedbackKind::heard_badly, "feedback.heard_badly"));
}

Feedback Conversation::respond_to_form(const Mark& mark) {
    const FormError* error = mark.main_error();
    const Rest rest = read_rest(mark);
    if (error == nullptr) {
        return conclude(CourseEvent::right, rest.good ? praise(mark) : respond_to_rest(mark, rest));
    }
    const std::string& whole = rest.joined.empty() ? mark.emphasised : rest.joined;
    const CatalogueSlots sentence{{"sentence", whole}, {"gap", mark.gapped}};
    const char* recast = recast_key(mark);
    const FeedbackLadder& ladder = question_->ladder.empty() ? settings_.ladder : question_->ladder;
    Feedback feedback;
    switch (step_at(ladder, ++seen_[ladder_key(*error)])) {
        case FeedbackStep::recast:
            feedback = say(FeedbackKind::recast, recast, sentence);
            break;
        case FeedbackStep::prompt:
            feedback = say(FeedbackKind::prompt, "feedback.prompt", sentence);
            feedback.may_repeat = true;
            accepted_ = mark;
            break;
        case FeedbackStep::rule: {
            const std::string key = rule_key(*error);
            const CatalogueSlots words{{"base", error->base},
                                       {"right", error->right},
                                       {"said", error->said},
                                       {"phrase", "*" + error->phrase + "*"}};
            feedback = say(FeedbackKind::rule,
                           says_yes_or_no(mark) ? "feedback.rule_said" : "feedback.rule",
                           {{"sentence", whole}, {"rule", catalogue_->say(key, words)}});
            feedback.keys.push_back(key);
            break;
        }
        case FeedbackStep::replay:
            feedback = say(FeedbackKind::replay, recast, sentence);
            feedback.replay = true;
            break;
    }
    feedback.free_errors = rest.checked.errors;
    return conclude(feedback.may_repeat ? CourseEvent::invite : CourseEvent::right,
                    std::move(feedback));
}

Feedback Conversation::praise(const Mark& mark) {
    const CatalogueSlots sentence{{"sentence", mark.emphasised}};
    if (mark.short_answer || !mark.form_known) {  // neither shows anything of the form
        return say(FeedbackKind::praise, "feedback.praise_short", sentence);
    }
    seen_.clear();  // a whole right sentence: the ladder begins anew
    if (asks_back(mark.corrected)) {
        return say(FeedbackKind::praise, "feedback.praise_question", sentence);
    }
    const std::vector<std::string> praises = catalogue_->series("feedback.praise");
    const std::string key =
        praises.empty() ? "feedback.praise.1" : praises[praise_++ % praises.size()];
    return say(FeedbackKind::praise, key, sentence);
}

Feedback Conversation::respond_to_repeat(const Mark& mark, bool meaning_right) {
    const bool repaired = mark.understood && meaning_right && mark.form_right();
    // What was said only needs its own error away; a short answer shows nothing about it.
    const bool shown = repaired && !mark.short_answer;
    Feedback feedback =
        shown ? say(FeedbackKind::praise, "feedback.repaired", {{"sentence", mark.corrected}})
              : say(FeedbackKind::recast, recast_key(accepted_),
                    {{"sentence", accepted_.emphasised}});
    if (mark.form_known) {
        feedback.uptake = shown ? Uptake::repaired : Uptake::not_repaired;
    }
    if (shown) {
        seen_.clear();
    }
    return conclude(CourseEvent::right, std::move(feedback));
}

Feedback Conversation::not_understood(const Mark& mark) {
    ++unheard_;
    if (settings_.unheard_tries > 0 && unheard_ >= settings_.unheard_tries) {
        return move_on();
    }
    // Who asks for help needs no second try.
    wanted_help_ = wanted_help_ || wants_help(mark.said);
    const int rung = wanted_help_ ? unheard_ + 1 : unheard_;
    // An opposite is named, and a name asked for; else first only again, then how the sentence goes, then what can be said.
    Feedback feedback;
    if (!mark.opposite_said.empty() && asks_for_thing(*question_)) {
        feedback = say(FeedbackKind::not_understood, "feedback.opposite",
                       {{"said", mark.opposite_said}, {"asked", "*" + mark.opposite_of + "*"}});
    } else if (!mark.pointed_with.empty() && rung < 3) {
        feedback = say(FeedbackKind::not_understood, "feedback.which_one");
    } else if (rung == 1) {
        feedback = say(FeedbackKind::not_understood, "feedback.not_understood.1");
    } else {
        feedback = tell(help_for(*question_, rung));
    }
    if (!wants_help(mark.said)) {
        show_good_english(mark, feedback);
    }
    return conclude(CourseEvent::unclear, std::move(feedback));
}

// It is true, and no answer yet; it is no wrong one either.
Feedback Conversation::leaves_open(const Mark& mark) {
    if (settings_.unheard_tries > 0 && ++unheard_ >= settings_.unheard_tries) {
        return move_on();
    }
    Feedback feedback = say(FeedbackKind::not_understood, "feedback.leaves_open");
    if (mark.form_known && !mark.form_errors.empty()) {
        put_before(feedback, "feedback.free_form", {{"sentence", mark.emphasised}});
    }
    return conclude(CourseEvent::unclear, std::move(feedback));
}

Feedback Conversation::tell(const Help& help) {
    switch (help.kind) {
        case Help::Kind::frame:
            return say(FeedbackKind::not_understood, "feedback.not_understood.2",
                       {{"frame", help.sentence}});
        case Help::Kind::example:
            return say(FeedbackKind::not_understood, "feedback.not_understood.example",
                       {{"sentence", help.sentence}});
        case Help::Kind::choices:
            break;
    }
    return say(FeedbackKind::not_understood, "feedback.not_understood.3",
               {{"choices", listed(*catalogue_, help.choices)}});
}

bool Conversation::wants_help(std::string_view said) const {
    const std::vector<std::string> words = words_of(said);
    const std::vector<std::string> keys = catalogue_->series("help.said");
    return std::any_of(keys.begin(), keys.end(), [&](const std::string& key) {
        return words_of(catalogue_->say(key)) == words;
    });
}

Feedback Conversation::wrong_meaning(const Mark& mark) {
    ++wrong_;
    if (settings_.tries > 0 && wrong_ >= settings_.tries) {
        return move_on();
    }
    // What comes next depends on the lesson: only the question itself may tell more than "try again".
    if (mark.turned_round) {
        return conclude(CourseEvent::wrong,
                        say(FeedbackKind::wrong_meaning, "feedback.turned_round"));
    }
    const std::string key =
        mark.other_number.empty() ? "feedback.wrong_meaning" : "feedback.other_number";
    Feedback feedback =
        say(FeedbackKind::wrong_meaning, question_->again.empty() ? key : key + ".again",
            {{"again", question_->again}, {"said", mark.other_number}});
    feedback.replay = true;
    if (!mark.other_number.empty()) {
        show_good_english(mark, feedback);  // no template marks its form
    }
    return conclude(CourseEvent::wrong, std::move(feedback));
}

Feedback Conversation::move_on() {
    return conclude(CourseEvent::give_up, say(FeedbackKind::moved_on, "feedback.moved_on"));
}

Feedback Conversation::conclude(CourseEvent verdict, Feedback feedback) {
    feedback.came = happen(verdict);
    feedback.ask_again = verdict == CourseEvent::unclear || verdict == CourseEvent::wrong;
    return feedback;
}

Feedback Conversation::say(FeedbackKind kind, std::string key, const CatalogueSlots& slots) {
    Feedback feedback;
    feedback.kind = kind;
    feedback.text = catalogue_->say(key, slots);
    feedback.keys.push_back(std::move(key));
    feedback.attempt = attempt_;
    return feedback;
}

std::string Conversation::ladder_key(const FormError& error) const {
    return std::string(error.errant()) + "/" + rule_key(error);
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
