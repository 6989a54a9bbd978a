// Verbs that answers use: the forms that agree with the subject, and the other forms that learners say instead.
//
// Thread: pure functions.  Cost: a table look-up; at load.
// Source: Quirk, Greenbaum, Leech and Svartvik 1985, "A Comprehensive Grammar of the English Language", chapter 10
//   (subject-verb concord); spelling of -s, chapter 3.
#pragma once

#include "dialogue/english/error_code.h"
#include "dialogue/english/noun.h"

#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::dialogue {

/// A finite verb form with both numbers of its third person.
struct VerbForms {
    std::string singular;  ///< is, was, has, does, weighs
    std::string plural;    ///< are, were, have, do, weigh
    bool is_be = false;    ///< a form of "be", which learners leave out

    /// The form that agrees with `number`.
    [[nodiscard]] const std::string& with(Number number) const {
        return number == Number::plural ? plural : singular;
    }
};

/// Understands a finite verb form of the third person; false for any other word.
[[nodiscard]] bool understand_verb(std::string_view word, VerbForms& forms);

/// A wrong form of the same verb and its error, e.g. for was/were: "be" R:VERB:FORM, "is" R:VERB:TENSE.
struct LearnerVerb {
    std::string text;
    ErrorCode code = ErrorCode::none;
};

/// What learners say for `forms`, apart from its two numbers.
[[nodiscard]] std::vector<LearnerVerb> learner_verbs(const VerbForms& forms);

/// "weigh" -> "weighs", "fly" -> "flies", "go" -> "goes", "have" -> "has".
[[nodiscard]] std::string third_person(std::string_view base);

}  // namespace fulcrum::dialogue
