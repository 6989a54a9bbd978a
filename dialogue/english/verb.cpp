#include "dialogue/english/verb.h"

#include "dialogue/english/letters.h"

#include <algorithm>
#include <array>

namespace fulcrum::dialogue {
namespace {

/// Verbs of lessons that agree by -s. A word outside this table is not taken for a verb.
constexpr std::array<std::string_view, 35> kBases = {
    "weigh", "feel", "look", "fall", "float", "sink",   "need",   "make",  "cost",
    "move",  "turn", "go",   "fly",  "have",  "do",     "hit",    "pull",  "push",
    "seem",  "take", "spin", "bend", "break", "bounce", "roll",   "shine", "burn",
    "lift",  "land", "stay", "hold", "keep",  "carry",  "travel", "rotate"};

}  // namespace

std::string third_person(std::string_view base) {
    if (base == "have") {
        return "has";
    }
    const std::string text(base);
    const std::size_t n = text.size();
    if (n == 0) {
        return text;
    }
    const bool consonant_y = n > 1 && text[n - 1] == 'y' && !is_vowel_letter(text[n - 2]);
    if (consonant_y) {
        return text.substr(0, n - 1) + "ies";
    }
    const std::string end = text.substr(n - std::min<std::size_t>(n, 2));
    const bool hissing =
        end == "ss" || end == "sh" || end == "ch" || text[n - 1] == 'x' || text[n - 1] == 'z';
    return text + (hissing || text[n - 1] == 'o' ? "es" : "s");
}

bool understand_verb(std::string_view word, VerbForms& forms) {
    if (word == "is" || word == "are") {
        forms = {"is", "are", true};
        return true;
    }
    if (word == "was" || word == "were") {
        forms = {"was", "were", true};
        return true;
    }
    for (const std::string_view base : kBases) {
        if (!word.starts_with(base.front())) {
            continue;  // "have" and "has", "fly" and "flies" begin alike
        }
        const std::string singular = third_person(base);
        if (word == base || word == singular) {
            forms = {singular, std::string(base), false};
            return true;
        }
    }
    return false;
}

std::vector<LearnerVerb> learner_verbs(const VerbForms& forms) {
    if (forms.singular == "is") {
        return {{"be", ErrorCode::verb_form},
                {"being", ErrorCode::verb_form},
                {"am", ErrorCode::agreement},
                {"is be", ErrorCode::verb_form}};
    }
    if (forms.singular == "was") {
        return {{"be", ErrorCode::verb_form},
                {"is", ErrorCode::verb_tense},
                {"are", ErrorCode::verb_tense}};
    }
    std::vector<LearnerVerb> verbs = {{"is " + forms.plural, ErrorCode::verb_form},
                                      {"are " + forms.plural, ErrorCode::verb_form}};
    if (forms.plural == "weigh") {  // the noun sounds nearly alike
        verbs.push_back({"weight", ErrorCode::morphology});
        verbs.push_back({"weights", ErrorCode::morphology});
    }
    return verbs;
}

}  // namespace fulcrum::dialogue
