// Asks, hears, judges: one question at a time. What is said to it is the partner's (dialogue/partner/own_words.h).
//
//   ask -> hear: a mark -> respond to it and the verdict on its meaning: a turn (turn.h), and how the question stands then (course.h)
//
// Feedback on form climbs a ladder (marking/feedback_ladder.h) by how often the same error has been made: by default a
// recast ("Yes. A watermelon is *the heaviest*."), then a prompt ("A watermelon is …?"), then a rule in one line. A question
// may have a ladder of its own. Nobody is held back for form alone.
// A wrong meaning never tells the right one. The same marks give the same feedback.
//
// Thread: one.  Cost: one match an answer.
// Source: recast, prompt (elicitation) and uptake after Lyster and Ranta 1997, "Corrective feedback and learner uptake",
//   Studies in Second Language Acquisition 19(1).
#pragma once

#include "dialogue/catalogue.h"
#include "dialogue/checking/checker.h"
#include "dialogue/conversation/turn.h"
#include "dialogue/marking/mark.h"
#include "dialogue/marking/question.h"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::dialogue {

/// How a conversation goes; fixed at its start.
struct ConversationSettings {
    FeedbackLadder ladder = default_ladder();  ///< of questions that have none of their own
    int tries =
        4;  ///< answers of wrong meaning after which the question is left, 1 or more; 0: never
    int unheard_tries = 6;  ///< answers not understood after which it is left, 1 or more; 0: never
    double least_confidence = 0.4;  ///< below it "say it again", never "wrong"; 0 to 1
    std::string level = "A1";       ///< of the learner's English
};

/// Checks words that fit no answer.
using FormCheck = std::function<CheckedText(std::string_view)>;

/// One learner's conversation. Keeps a reference to the catalogue: it must live longer.
class Conversation {
  public:
    explicit Conversation(const Catalogue& catalogue, ConversationSettings settings = {});

    /// From now on what fits no answer is checked for its form, and good English for it is shown: a sentence where that is proven, else
    /// what belongs in one place. Whether the answer is right isn't said. An empty function ends that.
    void set_form_check(FormCheck check) { form_check_ = std::move(check); }

    /// Asks; returns the prompt's sentences, a line each. `number` of `of` adds "Question 2 of 5." before them; 0 doesn't.
    std::vector<std::string> ask(const Question& question, int number = 0, int of = 0);
    /// The same question again; one that was felt again goes on where it was.
    std::vector<std::string> ask_again();

    /// Marks an answer; pure but for the state, which stays where nobody is to speak. Before any question an empty mark. Without `form` the
    /// meaning alone is marked.
    [[nodiscard]] Mark hear(std::string_view text, double confidence = 1.0, bool form = true);

    /// Judges it; `meaning_right` is the simulation's verdict and doesn't matter for a mark that isn't understood. Out of turn nothing comes
    /// of it.
    [[nodiscard]] Turn respond(Mark mark, bool meaning_right);

    /// Withdraw, time or close: none of what is asked or said.
    CourseStep happen(CourseEvent event);

    /// Sure enough to be marked.
    [[nodiscard]] bool heard_well(double confidence) const {
        return confidence >= settings_.least_confidence;
    }
    /// The words are one of the catalogue's help.said.1, …: who says them wants help.
    [[nodiscard]] bool wants_help(std::string_view said) const;
    [[nodiscard]] CourseState state() const { return state_; }
    [[nodiscard]] int attempt() const { return attempt_; }

  private:
    /// What fits no answer, marked as the good English for it where that is proven and is one: of right form but for what was put right.
    [[nodiscard]] std::optional<Mark> mark_put_right(const Mark& mark) const;
    /// What comes of it, one verdict each; what is to be told of it is filled in.
    [[nodiscard]] CourseEvent judge(Turn& turn);
    [[nodiscard]] CourseEvent judge_form(Turn& turn);
    [[nodiscard]] CourseEvent judge_wrong(Turn& turn);
    [[nodiscard]] CourseEvent judge_repeat(Turn& turn);
    [[nodiscard]] CourseEvent hear_badly(Turn& turn);
    [[nodiscard]] CourseEvent hear_nothing_known(Turn& turn);
    [[nodiscard]] CourseEvent leave_open(Turn& turn);
    /// A reason behind the answer that no template asks for, read; false where it is no good English, or nobody read it.
    [[nodiscard]] bool read_rest(Turn& turn) const;
    /// Looks for errors in what fits no answer.
    void check_form(Turn& turn) const;
    void count_anew();

    const Catalogue* catalogue_;
    ConversationSettings settings_;
    FormCheck form_check_;
    std::optional<Question> question_;
    CourseState state_ = CourseState::idle;
    int attempt_ = 0;                  ///< answers to this question
    int wrong_ = 0;                    ///< of wrong meaning
    int unheard_ = 0;                  ///< not understood
    int bad_repeats_ = 0;              ///< heard badly after an invitation
    bool wanted_help_ = false;         ///< help.said of the catalogue was said
    Mark accepted_{};                  ///< the answer whose repetition was invited
    std::map<std::string, int> seen_;  ///< sightings by error
};

/// The catalogue's keys that a conversation uses, for `Catalogue::check`.
[[nodiscard]] std::span<const CatalogueNeed> conversation_needs();

/// The key of the one-line rule for an error, "rule.superlative.ending".
[[nodiscard]] std::string rule_key(const FormError& error);

/// A text's sentences, each with its own mark: "Look. Which one is it?" -> 2.
[[nodiscard]] std::vector<std::string> sentences_of(std::string_view text);

}  // namespace fulcrum::dialogue
