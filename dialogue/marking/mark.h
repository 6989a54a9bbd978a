// What an answer meant, and how it was formed: two things that are kept apart. Whether the meaning is right is not known
// here; the simulation decides.
//
// Thread: pure.
// Source: the codes are ERRANT's (english/error_code.h). One part is emphasised, for a recast works when the learner can
//   see what was changed: Lyster and Ranta 1997, "Corrective feedback and learner uptake", Studies in Second Language
//   Acquisition 19(1).
#pragma once

#include "dialogue/english/adjective.h"
#include "dialogue/english/error_code.h"
#include "dialogue/template/graph.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fulcrum::dialogue {

/// One error of form.
struct FormError {
    ErrorCode code = ErrorCode::none;
    std::string said;       ///< the learner's letters; empty when something is missing
    std::size_t begin = 0;  ///< bytes of the utterance, [begin, end)
    std::size_t end = 0;
    std::string right;   ///< the words that belong there; empty when nothing does
    std::string phrase;  ///< the right phrase around it: "the heaviest", "an apple"
    std::string base;    ///< an adjective's or counted noun's own word: "heavy"; empty for others
    Role role = Role::word;
    Degree degree = Degree::positive;
    bool target = false;   ///< in the form that the question teaches
    bool passive = false;  ///< in "is made of": the auxiliary, the participle or the preposition

    /// The code as ERRANT writes it, "R:ADJ:FORM".
    [[nodiscard]] std::string_view errant() const { return errant_code(code); }
};

/// An answer, marked.
struct Mark {
    std::string said;
    bool understood = false;  ///< false: no template fits; what was meant and its form are empty
    std::string
        opposite_said;  ///< not understood, for "lighter" was said where "heavier" is asked; else empty
    std::string opposite_of;  ///< what is asked: "heavier", "the heaviest"
    std::string
        pointed_with;  ///< not understood, for a thing was pointed at and not named: "this one"
    std::string
        other_number;  ///< understood, but a number that no list has: it can't be right, and fills no slot
    Claim claim = Claim::
        same;  ///< what is said of `slots`; else the lesson is asked about each of `readings` (readings.h)
    std::vector<std::vector<std::pair<std::string, std::string>>> readings;
    std::vector<bool> denied;   ///< of `every`: which of them have to be wrong
    int answer = kNone;         ///< which of the question's answers it is, from 0
    bool short_answer = false;  ///< "The watermelon.": fine
    bool turned_round =
        false;  ///< "Metal is made of a spaceship.": thing and material changed places, so it can't be true
    bool form_known =
        true;  ///< false: the meaning alone was heard, and of the form nothing is known
    std::string
        unread;  ///< a reason behind the answer that no template asks for: "because it is big"; it was let pass
    std::size_t unread_begin = 0;  ///< its first byte in `said`
    double confidence = 1.0;       ///< the recogniser's, 0 to 1; 1 for typed answers
    std::vector<std::pair<std::string, std::string>> slots;  ///< thing -> watermelon
    std::vector<FormError> form_errors;                      ///< in the order said
    std::string corrected;  ///< the whole right sentence: "A watermelon is the heaviest."
    std::string
        emphasised;  ///< the same with what was wrong in *asterisks*; without errors as `corrected`
    std::string gapped;    ///< the same with "…" in that place
    std::string emphasis;  ///< that part alone: "the heaviest"; empty without errors

    /// The form is known, and there is no error in it.
    [[nodiscard]] bool form_right() const { return form_known && form_errors.empty(); }
    /// The form that the question teaches is known and right, whatever else is wrong.
    [[nodiscard]] bool target_right() const;
    /// Errors outside that form.
    [[nodiscard]] int other_errors() const;
    /// The error that feedback speaks of: the taught form first, then by order of importance; null without errors.
    [[nodiscard]] const FormError* main_error() const;
    /// The value of a slot, empty when it isn't filled.
    [[nodiscard]] std::string_view slot(std::string_view name) const;
};

/// A mark for somebody of whom only the meaning was heard: no errors of form, and no proof of a right form.
[[nodiscard]] Mark without_form(Mark mark);

}  // namespace fulcrum::dialogue
