// What a lesson knows of its things, as far as a learner may ask for it: which words ask for what.
//
//   words --find--> which L:knows, its slots, the question said rightly        the lesson's own function gives the answer
//
// Thread: load to compile, lesson loop to find.  Cost: one match.
#pragma once

#include "dialogue/catalogue.h"
#include "dialogue/marking/mark.h"
#include "dialogue/marking/question.h"
#include "haptics/base/error.h"
#include "runtime/scene/description.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::runtime {

/// What was asked for.
struct AskedFor {
    std::string knowledge;  ///< the name that L:knows gave it
    dialogue::Mark mark;    ///< its slots and errors of form
    std::string praise{};   ///< said before the answer, where asking was what was asked for
};

/// A sentence that asks for something.
struct AskingSentence {
    std::string knowledge;
    std::string said;
};

/// Whether words are put as a question: a word that asks or a verb stands first, or a question mark last. Who learns English may put them
/// otherwise, and is understood where nothing else is asked.
[[nodiscard]] bool begins_as_question(std::string_view words);

/// Whether words that fit no answer are a question of the learner's own: "can I eat it?", "what colour is it". Neither "is on the block",
/// which lacks its "it", nor "when the wind stops" nor "the apple?" are.
[[nodiscard]] bool asks_something(std::string_view words);

/// Whether to tell this to who `asked` while that question is open would answer it, or come near to it: it is one of its answers, it is yes
/// or no, or one of the words from which an answer chooses stands in either.
[[nodiscard]] bool gives_away(const dialogue::Question& question, std::string_view asked,
                              std::string_view told);

class Knowledge {
  public:
    /// Nothing for a lesson that knows nothing. The catalogue lives longer. All that it knows shares its lists: one name with two
    /// meanings is the lesson's error, as all that cannot be compiled with what stands before it, at its line.
    [[nodiscard]] static Expected<std::optional<Knowledge>> compile(
        const LessonDescription& lesson, const dialogue::Catalogue& catalogue);

    /// Nothing where the words ask for nothing that the lesson knows. Without `form` they show the meaning alone.
    [[nodiscard]] std::optional<AskedFor> find(std::string_view words, bool form = true) const;
    /// All ways to ask, each one of its answers.
    [[nodiscard]] const dialogue::Question& question() const { return question_; }
    /// What a recogniser listens for while nothing else is asked.
    [[nodiscard]] std::shared_ptr<const dialogue::TemplateSet> templates() const {
        return question_.templates;
    }
    /// What is said to who asked for it: the lesson's answer, or that it is not known; before it the question as it is said rightly,
    /// where it was not.
    [[nodiscard]] std::string told(const AskedFor& asked, const std::string& answer) const;
    /// To words that ask for nothing: what might be asked, another thing each time.
    [[nodiscard]] std::string unknown();
    /// To who answers a question that is to be asked again.
    [[nodiscard]] std::string not_now() const { return catalogue_->say("knowledge.not_now"); }
    /// To what was not heard well.
    [[nodiscard]] std::string heard_badly() const {
        return catalogue_->say("feedback.heard_badly");
    }
    /// To who asks while a question is open.
    [[nodiscard]] std::string first_mine() const { return catalogue_->say("knowledge.first_mine"); }
    /// Each way to ask as it is said rightly, with each word of its lists, in the lesson's order.
    [[nodiscard]] std::vector<AskingSentence> every_way() const;

  private:
    explicit Knowledge(const dialogue::Catalogue& catalogue) : catalogue_(&catalogue) {}

    const dialogue::Catalogue* catalogue_;
    dialogue::Question question_;        // each way to ask is one of its answers
    std::vector<std::string> names_;     // by answer
    std::vector<std::string> examples_;  // one each
    std::size_t next_example_ = 0;
};

}  // namespace fulcrum::runtime
