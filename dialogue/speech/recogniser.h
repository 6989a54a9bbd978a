// Whatever hears the learner: a keyboard, a script, a microphone with a recogniser behind it.
//
// A recogniser is told which templates to listen for; their graph holds the right sentences and the errors that learners
// make, so that it doesn't mend what it hears. Marking is done on the words it returns.
//
// Thread: one, that of the lesson loop; what a recogniser does elsewhere is its own affair.  Cost: `poll` never waits.
#pragma once

#include "dialogue/result.h"
#include "dialogue/template/graph.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::dialogue {

/// What may have been said.
struct Hypothesis {
    std::string text;
    double confidence = 1.0;  ///< 0 to 1; 1 for what was typed
    bool form =
        true;  ///< the words are the learner's own; false: they mean the same, and show no error of form
};

/// The interface of all recognisers.
class Recogniser {
  public:
    Recogniser() = default;
    Recogniser(const Recogniser&) = delete;
    Recogniser& operator=(const Recogniser&) = delete;
    virtual ~Recogniser() = default;

    /// Listens for one answer to `templates` from now on. An error says why it can't, e.g. a word without pronunciation.
    [[nodiscard]] virtual Expected<bool> listen(std::shared_ptr<const TemplateSet> templates) = 0;
    /// The hypotheses for an answer that is complete, the best first; empty while there is none. Ends the listening.
    [[nodiscard]] virtual std::vector<Hypothesis> poll() = 0;
    /// Stops listening; what was half heard is dropped.
    virtual void stop() = 0;
    [[nodiscard]] virtual bool listening() const = 0;
    /// "text", "null", …; as the command line names it.
    [[nodiscard]] virtual std::string_view name() const = 0;
};

}  // namespace fulcrum::dialogue
