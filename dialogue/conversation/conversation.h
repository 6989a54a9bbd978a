// Asks, hears, answers: one question at a time.
//
//   ask -> hear: a mark -> respond to it and the verdict on its meaning: feedback, and how the question stands then (course.h)
//
// Feedback on form climbs a ladder (marking/feedback_ladder.h) by how often the same error has been made: by default a
// recast ("Yes. A watermelon is *the heaviest*."), then a prompt ("A watermelon is …?"), then a rule in one line. A question
// may have a ladder of its own. Nobody is held back for form alone.
// A wrong meaning never tells the right one. The same marks give the same feedback: praise goes round in turn.
//
// Thread: one.  Cost: one match an answer.
// Source: recast, prompt (elicitation) and uptake after Lyster and Ranta 1997, "Corrective feedback and learner uptake",
//   Studies in Second Language Acquisition 19(1).
#pragma once

#include "dialogue/catalogue.h"
#include "dialogue/checking/checker.h"
#include "dialogue/conversation/course.h"
#include "dialogue/conversation/help.h"
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
};

/// What kind of answer the learner gets.
enum class FeedbackKind : std::uint8_t {
    praise,          ///< meaning and form are right
    recast,          ///< meaning right; the right sentence is said back
    prompt,          ///< meaning right; the learner may say it once more
    rule,            ///< meaning right; the right sentence and its rule
    replay,          ///< meaning right; the right sentence, and what it is about is felt again
    wrong_meaning,   ///< asked again, with what the question itself says then
    not_understood,  ///< no sentence fits; asked again
    heard_badly,     ///< the recogniser isn't sure; asked again
    moved_on         ///< left for now
};

/// What was made of an invitation to say it once more; none, too, where the form of what was said then was not heard.
enum class Uptake : std::uint8_t { none, repaired, not_repaired };

/// For files and databases: "praise", "wrong_meaning"; "repaired", and nothing where there was no invitation.
[[nodiscard]] constexpr std::string_view name_of(FeedbackKind kind) noexcept {
    constexpr std::string_view kNames[] = {"praise",         "recast",      "prompt",
                                           "rule",           "replay",      "wrong_meaning",
                                           "not_understood", "heard_badly", "moved_on"};
    return kNames[static_cast<std::size_t>(kind)];
}
[[nodiscard]] constexpr std::string_view name_of(Uptake uptake) noexcept {
    constexpr std::string_view kNames[] = {"", "repaired", "not_repaired"};
    return kNames[static_cast<std::size_t>(uptake)];
}

/// The program's answer to an answer.
struct Feedback {
    FeedbackKind kind = FeedbackKind::praise;
    std::string text;               ///< shown and read aloud; *asterisks* around what is emphasised
    std::vector<std::string> keys;  ///< the catalogue's keys it is made of
    CourseStep came{};              ///< how the question stands after it
    bool ask_again = false;         ///< the question stays open
    bool may_repeat = false;  ///< one more `hear` is welcome; the question is done even without it
    bool replay = false;  ///< let the hand feel the contrast again: a wrong meaning, or that step
    Uptake uptake = Uptake::none;
    int attempt = 0;  ///< the number of this answer to the question, from 1
    std::vector<FreeError>
        free_errors{};  ///< of form, in words that fit no answer; good English for them is in `text`
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

    /// Answers; `meaning_right` is the simulation's verdict and doesn't matter for a mark that isn't understood.
    [[nodiscard]] Feedback respond(const Mark& mark, bool meaning_right);

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
    Feedback heard_badly();
    Feedback respond_to_form(const Mark& mark);
    Feedback praise(const Mark& mark);
    Feedback respond_to_repeat(const Mark& mark, bool meaning_right);
    Feedback not_understood(const Mark& mark);
    Feedback leaves_open(const Mark& mark);
    Feedback tell(const Help& help);
    Feedback wrong_meaning(const Mark& mark);
    /// What stands behind the answer, read: a reason that no template asks for.
    struct Rest {
        bool good =
            true;  ///< there is none, or it is good English; false, too, where nobody read it
        CheckedText checked{};  ///< its errors at their places in all that was said
        std::string
            joined{};  ///< the answer and its reason, both right, in one sentence; empty where that isn't proven
    };
    [[nodiscard]] Rest read_rest(const Mark& mark) const;
    /// The answer is right, and behind it something isn't, or wasn't read.
    Feedback respond_to_rest(const Mark& mark, const Rest& rest);
    /// Good English for what was said, before the feedback's own words; nothing where no error is seen.
    void show_good_english(const Mark& mark, Feedback& feedback) const;
    /// The same of the first of `errors` in `text` that stands alone, in words: no sentence for it was proven. False where none does.
    bool show_good_words(std::string_view text, const std::vector<FreeError>& errors,
                         Feedback& feedback) const;
    void put_before(Feedback& feedback, const char* key, CatalogueSlots slots) const;
    Feedback move_on();
    void count_anew();
    /// What the verdict came to, and what is said to it.
    Feedback conclude(CourseEvent verdict, Feedback feedback);
    Feedback say(FeedbackKind kind, std::string key, const CatalogueSlots& slots = {});
    [[nodiscard]] std::string ladder_key(const FormError& error) const;

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
    std::size_t praise_ = 0;           ///< next praise in turn
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
