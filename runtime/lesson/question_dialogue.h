// The question that a lesson has asked: who may speak next, what the learner is told, what the lesson is told.
//
//   state           who is waited for            by              next state                      the lesson is told
//   closed          nobody
//   open            the learner                  hear            judging; words that fit nothing: open again,
//                                                                or closed after many            (when closed) answered
//   judging         the lesson's verdict         judge   right   closed                          answered, over
//                                                        right   invited, when the form may be said once more
//                                                        wrong   set_aside, or closed after many tries        answered
//                                                        unsure  open: the recogniser heard badly
//   set_aside       the lesson: feel it again    ask             open; the same question goes on counting
//   invited         the learner, 12 s at most    hear            judging_again
//                                                step            closed once the time is over    answered, over
//   judging_again   the lesson's verdict         judge           closed                          answered, over
//                                                        unsure  invited anew, twice at most
//
//   any             ask            open; words that wait for a verdict are forgotten. An invitation's answer was right:
//                                  the lesson is told so before another question begins.
//   any             close          closed; what has not been told by then never is.
//   judging(_again) end_exchange   open (invited): the verdict did not come with the reply.
//   closed, set_aside: where the lesson knows things (knowledge.h), the learner may ask; in all other states that is put off and
//   counts for nothing, known or not, unless the question is answered by asking: then what is asked is a right answer.
//   A verdict in any other state is late, and dropped. So only the two states that wait for a verdict shut the learner's
//   mouth, and neither outlives the exchange of one frame with the lesson.
//
// Thread: lesson loop.  Cost: one match an answer.
#pragma once

#include "dialogue/catalogue.h"
#include "dialogue/conversation/conversation.h"
#include "runtime/scene/lesson_messages.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fulcrum::runtime {

enum class QuestionState : std::uint8_t {
    closed,
    open,
    judging,
    set_aside,
    invited,
    judging_again
};

/// An answer with all that is known of it.
struct MarkedAnswer {
    std::string question;
    dialogue::Mark mark;
    dialogue::Feedback feedback;
    bool right = false;     ///< the meaning, by the lesson's verdict
    double answer_s = 0.0;  ///< from the question to the answer, not negative
};

/// What came of one call.
struct QuestionTurn {
    std::vector<LessonEvent> events;     ///< for the lesson, in order
    std::optional<MarkedAnswer> answer;  ///< the learner has been answered
    std::string prompt;                  ///< what is asked now, a line a sentence
};

class QuestionDialogue {
  public:
    using Questions = std::map<std::string, dialogue::Question>;

    /// The catalogue outlives the dialogue.
    QuestionDialogue(Questions questions, const dialogue::Catalogue& catalogue,
                     dialogue::ConversationSettings settings = {});

    /// What fits no answer is checked from now on.
    void set_form_check(dialogue::FormCheck check) {
        conversation_.set_form_check(std::move(check));
    }
    [[nodiscard]] bool declares(const std::string& question) const {
        return questions_.count(question) > 0;
    }
    /// Asks a declared question; its prompt and perhaps the answer to the one before.
    [[nodiscard]] QuestionTurn ask(const std::string& question, double time_s);
    /// The learner's words, clean UTF-8, and how sure the recogniser is (0 to 1). Nothing comes of them unless somebody listens.
    /// Without `form` they show the meaning alone.
    [[nodiscard]] QuestionTurn hear(std::string_view words, double confidence, double time_s,
                                    bool form = true);
    /// A question that the lesson knows, where one is wanted: a right answer. Nothing comes of it unless somebody listens.
    [[nodiscard]] QuestionTurn take_question(dialogue::Mark asked, double time_s);
    /// The lesson's verdict about the meaning.
    [[nodiscard]] QuestionTurn judge(const std::string& question, bool right, double time_s);
    /// Time has passed; nobody is held back for form: an invitation to say it once more ends by itself.
    [[nodiscard]] QuestionTurn step(double time_s);
    /// The lesson has said all that it says to this frame.
    void end_exchange();
    /// Nothing is asked any more.
    void close();

    [[nodiscard]] QuestionState state() const { return state_; }
    /// The learner may speak: open or invited.
    [[nodiscard]] bool listens() const {
        return state_ == QuestionState::open || state_ == QuestionState::invited;
    }
    /// The learner is being asked, or has just answered.
    [[nodiscard]] bool is_open() const {
        return state_ != QuestionState::closed && state_ != QuestionState::set_aside;
    }
    /// The answer was right already.
    [[nodiscard]] bool is_invited() const {
        return state_ == QuestionState::invited || state_ == QuestionState::judging_again;
    }
    /// When the learner was last asked to speak.
    [[nodiscard]] double asked_at_s() const { return asked_at_s_; }
    /// How often the learner has been asked to speak.
    [[nodiscard]] int turns() const { return turns_; }
    /// Sure enough to be marked.
    [[nodiscard]] bool heard_well(double confidence) const {
        return conversation_.heard_well(confidence);
    }
    /// Would these words be an answer to the question of now, right or wrong?
    [[nodiscard]] bool understands(std::string_view words) const;
    /// These words ask for help with the question of now, and nothing else.
    [[nodiscard]] bool wants_help(std::string_view words) const {
        return conversation_.wants_help(words);
    }
    /// What was said was no answer: the learner is waited for anew, where somebody listens. It counts for nothing.
    void wait_anew(double time_s);
    /// The learner may speak, and is to ask: "Now you ask me!" Its answers are questions themselves.
    [[nodiscard]] bool wants_question() const;
    /// The question of now; null when there is none.
    [[nodiscard]] const dialogue::Question* question() const;
    /// The sentences that answer it; null when there is none.
    [[nodiscard]] std::shared_ptr<const dialogue::TemplateSet> templates() const;

  private:
    [[nodiscard]] QuestionTurn answer(bool right, double time_s);
    void listen(QuestionState state, double time_s);

    Questions questions_;
    dialogue::Conversation conversation_;
    QuestionState state_ = QuestionState::closed;
    std::string question_;                 // of every state but closed
    std::optional<dialogue::Mark> heard_;  // in judging and judging_again
    std::vector<bool> verdicts_;           ///< on the readings of what was heard, so far
    std::optional<AnsweredEvent>
        right_;  // in invited and judging_again: what the lesson will be told
    double invited_until_s_ = 0.0;
    double asked_at_s_ = 0.0;
    int turns_ = 0;
};

}  // namespace fulcrum::runtime
