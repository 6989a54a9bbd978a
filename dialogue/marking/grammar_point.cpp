#include "dialogue/marking/grammar_point.h"

namespace fulcrum::dialogue {
namespace {

/// What "is made of" makes of a code; its articles, numbers and spellings stay what they are.
GrammarPoint point_in_passive(const FormError& error) {
    switch (error.code) {
        case ErrorCode::agreement:
            return GrammarPoint::agreement;
        case ErrorCode::spelling:
        case ErrorCode::orthography:
            return GrammarPoint::spelling;
        case ErrorCode::wrong_preposition:
        case ErrorCode::missing_preposition:
            return GrammarPoint::preposition;
        case ErrorCode::word_order:
            return GrammarPoint::wording;
        default:
            return GrammarPoint::passive_voice;
    }
}

/// "Metal is harder", where no comparison was asked for, is a point of the adjective.
GrammarPoint point_of_adjective(const FormError& error) {
    return error.degree == Degree::positive ? GrammarPoint::adjective : GrammarPoint::comparison;
}

}  // namespace

GrammarPoint grammar_point(const FormError& error) {
    if (error.passive) {
        return point_in_passive(error);
    }
    switch (error.code) {
        case ErrorCode::missing_determiner:
        case ErrorCode::wrong_determiner:
        case ErrorCode::extra_determiner:
            return GrammarPoint::article;
        case ErrorCode::adjective_form:
        case ErrorCode::morphology:
            return point_of_adjective(error);
        case ErrorCode::wrong_adverb:
            return error.right == "very" ? GrammarPoint::adjective : GrammarPoint::comparison;
        case ErrorCode::agreement:
            return GrammarPoint::agreement;
        case ErrorCode::verb_voice:
            return GrammarPoint::passive_voice;
        case ErrorCode::missing_verb:
        case ErrorCode::verb_form:
        case ErrorCode::verb_tense:
        case ErrorCode::verb_inflection:
            return GrammarPoint::verb;
        case ErrorCode::missing_pronoun:
        case ErrorCode::extra_pronoun:
        case ErrorCode::wrong_pronoun:
            return GrammarPoint::pronoun;
        case ErrorCode::wrong_preposition:
        case ErrorCode::missing_preposition:
        case ErrorCode::extra_preposition:
            return error.right == "than" ? GrammarPoint::comparison : GrammarPoint::preposition;
        case ErrorCode::noun_number:
        case ErrorCode::noun_inflection:
            return GrammarPoint::noun_number;
        case ErrorCode::missing_conjunction:
        case ErrorCode::wrong_conjunction:
            return GrammarPoint::joining;
        case ErrorCode::wording:
        case ErrorCode::word_order:
            return GrammarPoint::wording;
        case ErrorCode::none:
        case ErrorCode::spelling:
        case ErrorCode::orthography:
            break;
    }
    return GrammarPoint::spelling;
}

}  // namespace fulcrum::dialogue
