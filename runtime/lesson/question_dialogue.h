// The question that a lesson has asked: who may speak next, what the learner is told, what the lesson is told.
//
// Where it stands and what may happen then is the conversation's (dialogue/conversation/course.h); here are the times and the lesson's side:
//   hear       the lesson is asked for its verdict on each reading of what was understood; words that fit nothing need none
//   judge      its verdict; in a state that waits for none it is late, and dropped
//   step       an invitation ends after 12 s, in which the answer was right
//   end_exchange   the verdict did not come with the reply: what was said is forgotten, and the learner may speak
//   close      what has not been told by then never is
// So no state that shuts the learner's mouth outlives the exchange of one frame with the lesson.
//
// Thread: lesson loop.  Cost: one match an answer.
#pragma once

#include "dialogue/catalogue.h"
#include "dialogue/conversation/conversation.h"
#include "runtime/scene/lesson_messages.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fulcrum::runtime {

/// An answer with all that is known of it.
struct MarkedAnswer : dialogue::Turn {
    std::string question;
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

    [[nodiscard]] dialogue::CourseState state() const { return conversation_.state(); }
    /// The learner may speak.
    [[nodiscard]] bool listens() const { return dialogue::listens(state()); }
    /// The learner is being asked, or has just answered.
    [[nodiscard]] bool is_open() const { return listens() || dialogue::is_judging(state()); }
    /// The answer was right already.
    [[nodiscard]] bool is_invited() const { return dialogue::is_invited(state()); }
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
    void listen(double time_s);
    void forget();

    Questions questions_;
    dialogue::Conversation conversation_;
    std::string question_;                 // of every state but idle, left and done
    std::optional<dialogue::Mark> heard_;  // while a verdict is waited for
    std::vector<bool> verdicts_;           ///< on the readings of what was heard, so far
    std::optional<AnsweredEvent> right_;   // while it is invited: what the lesson will be told
    double invited_until_s_ = 0.0;
    double asked_at_s_ = 0.0;
    int turns_ = 0;
};

}  // namespace fulcrum::runtime
