#include "dialogue/english/adjective.h"
#include "dialogue/english/antonyms.h"
#include "dialogue/english/common_noun.h"
#include "dialogue/english/determiner.h"
#include "dialogue/english/error_code.h"
#include "dialogue/english/letters.h"
#include "dialogue/english/lexicon.h"
#include "dialogue/english/making.h"
#include "dialogue/english/measure.h"
#include "dialogue/english/noun.h"
#include "dialogue/english/number.h"
#include "dialogue/english/opposite.h"
#include "dialogue/english/unit.h"
#include "dialogue/english/variant.h"
#include "dialogue/english/verb.h"
#include "tests/unit/dialogue/rig.h"
#include "tests/unit/dialogue/table.h"

using namespace fulcrum::dialogue;

namespace {

/// WordNet's files, opened once.
template <class Opened>
const Opened& opened_once() {
    static const auto opened = Opened::open();
    REQUIRE(opened);
    return *opened;
}

/// "heavy: most heavy" or "heavy / light" in its two parts.
std::pair<std::string, std::string> parted_at(const std::string& text, const std::string& between) {
    const std::size_t at = text.find(between);
    REQUIRE(at != std::string::npos);
    return {text.substr(0, at), text.substr(at + between.size())};
}

template <class Words>
bool among(const Words& words, const std::string& word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

template <std::size_t N>
std::size_t index_of(const std::array<const char*, N>& names, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    REQUIRE(found != names.end());
    return static_cast<std::size_t>(found - names.begin());
}

WordKind kind_named(const std::string& name) {
    constexpr std::array kNames{"noun", "verb", "adjective", "adverb"};
    return static_cast<WordKind>(index_of(kNames, name));
}

Degree degree_named(const std::string& name) {
    constexpr std::array kNames{"positive", "comparative", "superlative"};
    return static_cast<Degree>(index_of(kNames, name));
}

/// The code that `said` has among what learners say; "" where it is none of it.
template <class Forms>
std::string code_among(const Forms& forms, const std::string& said) {
    const auto found =
        std::ranges::find_if(forms, [&](const auto& form) { return form.text == said; });
    return found == forms.end() ? "" : std::string(errant_code(found->code));
}

std::string learner_adjective(TableScene& scene, const std::string& in) {
    const auto [adjective, said] = parted_at(in, ": ");
    return code_among(learner_forms(adjective, degree_named(scene.with)), said);
}

std::string learner_making(TableScene& scene, const std::string& in) {
    return scene.with == "learner_participles"   ? code_among(learner_participles(), in)
           : scene.with == "learner_auxiliaries" ? code_among(learner_auxiliaries(), in)
                                                 : code_among(active_for_passive(), in);
}

std::string degrees(TableScene&, const std::string& in) {
    return spaced(degree_forms(in, Degree::comparative), "/") + " | " +
           spaced(degree_forms(in, Degree::superlative), "/");
}

std::string compared(TableScene&, const std::string& in) {
    constexpr std::array kNames{"ending", "more_most", "both", "irregular"};
    return kNames.at(static_cast<std::size_t>(comparison_of(in)));
}

/// Whether the second is an opposite of the first; "both ways": and the first of the second.
std::string are_opposites(TableScene& scene, const std::string& in) {
    const auto [one, other] = parted_at(in, " / ");
    const auto& antonyms = opened_once<Antonyms>();
    return yes_or_no(among(antonyms.of(one), other) &&
                     (scene.with.empty() || among(antonyms.of(other), one)));
}

/// Of a scale's adjective what the probe is told; "back": its opposite's opposite is the word.
std::string measure(TableScene& scene, const std::string& in) {
    const Measure& found = measure_of(in);
    if (scene.with == "back") {
        return yes_or_no(measure_of(found.opposite).opposite == in);
    }
    if (scene.with == "is_felt") {
        return yes_or_no(found.is_felt);
    }
    const std::map<std::string, std::string_view> parts{{"adjective", found.adjective},
                                                        {"opposite", found.opposite},
                                                        {"noun", found.noun},
                                                        {"more", found.more}};
    return std::string(parts.at(scene.with));
}

/// Each of a word's opposites has it as an opposite.
std::string opposite_back(TableScene&, const std::string& in) {
    return yes_or_no(std::ranges::all_of(opposites_of(in), [&](std::string_view opposite) {
        return among(opposites_of(opposite), in);
    }));
}

std::string noun_class(TableScene&, const std::string& in) {
    constexpr std::array kNames{"count",     "mass",        "plural", "name",
                                "named_the", "name_or_the", "no_noun"};
    return kNames.at(static_cast<std::size_t>(understand_noun(in).noun_class));
}

std::string verb_forms(TableScene&, const std::string& in) {
    VerbForms forms;
    return understand_verb(in, forms)
               ? forms.with(Number::singular) + " | " + forms.with(Number::plural)
               : "no verb";
}

std::string is_be(TableScene&, const std::string& in) {
    VerbForms forms;
    REQUIRE(understand_verb(in, forms));
    return yes_or_no(forms.is_be);
}

/// How often the noun "weight" is among what learners say for the verb.
std::string weight_for(TableScene&, const std::string& in) {
    VerbForms forms;
    REQUIRE(understand_verb(in, forms));
    return std::to_string(std::ranges::count_if(learner_verbs(forms), [](const LearnerVerb& verb) {
        return verb.text == "weight" && verb.code == ErrorCode::morphology;
    }));
}

template <class Say>
Probe told(Say say) {
    return [say](TableScene&, const std::string& in) { return std::string(say(in)); };
}

template <class Ask>
Probe answered(Ask ask) {
    return [ask](TableScene&, const std::string& in) { return yes_or_no(ask(in)); };
}

template <class List>
Probe all_of(List list) {
    return [list](TableScene&, const std::string& in) { return spaced(list(in), ", "); };
}

const std::map<std::string, Probe> kEnglishProbes{
    {"degrees", degrees},
    {"compared", compared},
    {"syllables", told([](const auto& word) { return std::to_string(syllables(word)); })},
    {"adjective", learner_adjective},
    {"making", learner_making},
    {"opposites", are_opposites},
    {"antonyms", all_of([](const auto& word) { return opened_once<Antonyms>().of(word); })},
    {"opposites_of", all_of(opposites_of)},
    {"opposite", opposite_back},
    {"article", told(indefinite_article)},
    {"both_articles", answered(both_articles)},
    {"common_noun",
     answered([](const auto& word) { return opened_once<CommonNouns>().has(word); })},
    {"sole_determiner", answered(is_sole_determiner)},
    {"distance",
     [](TableScene&, const std::string& in) {
         const auto [one, other] = parted_at(in, " / ");
         return std::to_string(edit_distance(one, other));
     }},
    {"lower_case", told(lower_case)},
    {"sentence_case", told(sentence_case)},
    {"sentences_case", told(sentences_case)},
    {"allowed_slip",
     told([](const auto& size) { return std::to_string(allowed_slip(std::stoul(size))); })},
    {"lexicon_has",
     [](TableScene& scene, const std::string& in) {
         return yes_or_no(opened_once<Lexicon>().has(in, kind_named(scene.with)));
     }},
    {"lexicon_bases",
     [](TableScene& scene, const std::string& in) {
         return spaced(opened_once<Lexicon>().bases(in, kind_named(scene.with)), ", ");
     }},
    {"irregular_plurals",
     all_of([](const auto& noun) { return opened_once<Lexicon>().irregular_plurals(noun); })},
    {"changed_in_making",
     [](TableScene&, const std::string& in) {
         const auto [thing, material] = parted_at(in, " / ");
         return yes_or_no(changed_in_making(thing, material));
     }},
    {"measure", measure},
    {"plural", told(plural_of)},
    {"singular", told(singular_of)},
    {"looks_plural", answered(looks_plural)},
    {"plural_only", answered(is_plural_only)},
    {"class", noun_class},
    {"text", told([](const auto& entry) { return understand_noun(entry).text; })},
    {"number", told([](const auto& entry) {
         return understand_noun(entry).number() == Number::plural ? "plural" : "singular";
     })},
    {"wrong_plurals", all_of(learner_plurals)},
    {"plural_is_wrong",
     answered([](const auto& noun) { return among(learner_plurals(noun), plural_of(noun)); })},
    {"mass", answered(is_mass_noun)},
    {"has_kinds", answered(has_kinds)},
    {"names_force", answered(names_force)},
    {"describes", answered(describes)},
    {"in_words", told([](const auto& number) { return spaced(number_words(std::stol(number))); })},
    {"number_word", answered(is_number_word)},
    {"unit", answered(is_unit)},
    {"other_spelling", told([](const auto& word) { return other_spelling(word); })},
    {"spelled",
     answered([](const auto& word) { return other_spelling(other_spelling(word)) == word; })},
    {"verb", verb_forms},
    {"is_be", is_be},
    {"weight", weight_for}};

}  // namespace

TEST_CASE("english: each word has its forms and kinds as the tables say") {
    hold_tables("english", kEnglishProbes);
}
