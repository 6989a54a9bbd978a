#include "dialogue/checking/author_slips.h"
#include "dialogue/checking/doubts.h"
#include "dialogue/checking/grammar_words.h"
#include "dialogue/template/tokens.h"
#include "tests/unit/dialogue/checking/checked.h"
#include "tests/unit/dialogue/rig.h"
#include "tests/unit/dialogue/table.h"

using namespace fulcrum::dialogue;

namespace {

const std::vector<std::string> kAuthorsThings{"block", "ball", "apple"};

const Lexicon& table_lexicon() {
    static const Lexicon lexicon = opened_lexicon();
    return lexicon;
}

/// What is found in a text where the things named behind the probe stand before the learner.
CheckedText found(const TableScene& scene, const std::string& in) {
    static EnglishChecker checker = words_alone();
    checker.set_things(listed(scene.with));
    return checker.check(in);
}

/// "R:ADJ:FORM | The egg is *heavier*."
std::string checked_text(TableScene& scene, const std::string& in) {
    const CheckedText result = found(scene, in);
    std::vector<std::string> codes;
    for (const FreeError& error : result.errors) {
        codes.emplace_back(errant_code(error.code));
    }
    return std::string(without_blanks(spaced(codes) + " | " + result.marked));
}

/// "right" where nothing is found and nothing changed.
std::string right(TableScene& scene, const std::string& in) {
    const CheckedText result = found(scene, in);
    return result.errors.empty() && result.marked == in && result.corrected == in ? "right"
                                                                                  : result.marked;
}

/// "float -> floats", or nothing.
std::string slip(TableScene&, const std::string& in) {
    std::vector<std::string> all;
    for (const FreeError& error :
         find_author_slips(read_sentences(table_lexicon(), in, kAuthorsThings), in)) {
        CHECK(in.substr(error.begin, error.end - error.begin) == error.said);
        all.push_back(error.said + " -> " + error.right);
    }
    return std::string(without_blanks(spaced(all, ", ")));
}

std::string doubtful_question(TableScene&, const std::string& in) {
    return std::string(
        find_doubtful_question(read_sentences(table_lexicon(), in, kAuthorsThings), in));
}

std::string doubted(TableScene&, const std::string& in) {
    const std::vector<std::string> things{"hand", "tail", "block"};
    const auto sentences = read_sentences(table_lexicon(), in, things);
    REQUIRE(sentences.size() == 1);
    return yes_or_no(is_doubtful(sentences[0]));
}

/// The words of a text of one sentence; "#" behind a number of more than one.
std::string words_read(TableScene&, const std::string& in) {
    const FreeSentence sentence = only_sentence(in);
    std::vector<std::string> words;
    for (int i = 0; i < sentence.size(); ++i) {
        words.push_back(sentence[i].text + (sentence[i].number ? "#" : ""));
    }
    return spaced(words);
}

/// Whether a word is in the table that the probe is told, or in any of them.
std::string in_table(TableScene& scene, const std::string& in) {
    static const std::map<std::string, bool (*)(std::string_view)> tables{
        {"is_closed_word", is_closed_word},
        {"is_determiner", is_determiner},
        {"is_possessive", is_possessive},
        {"is_modal", is_modal},
        {"is_question_word", is_question_word},
        {"is_linking_verb", is_linking_verb},
        {"is_telling_verb", is_telling_verb},
        {"is_light_adverb", is_light_adverb},
        {"is_central_determiner", is_central_determiner},
        {"is_third_singular", is_third_singular},
        {"is_other_person", is_other_person},
        {"is_strictly_mass", is_strictly_mass},
        {"is_material", is_material},
        {"is_collective", is_collective},
        {"is_physical", is_physical},
        {"is_planet", is_planet},
        {"is_month_or_day", is_month_or_day},
        {"is_time_or_amount", is_time_or_amount}};
    REQUIRE((scene.with == "any" || tables.count(scene.with) == 1));
    return yes_or_no(std::ranges::any_of(tables, [&](const auto& table) {
        return (scene.with == "any" || scene.with == table.first) && table.second(in);
    }));
}

const std::map<std::string, Probe> kCheckingProbes{
    {"checked", checked_text},
    {"right", right},
    {"marked", [](TableScene& scene, const std::string& in) { return found(scene, in).marked; }},
    {"corrected",
     [](TableScene& scene, const std::string& in) { return found(scene, in).corrected; }},
    {"slip", slip},
    {"question", doubtful_question},
    {"doubted", doubted},
    {"words", words_read},
    {"word", in_table}};

}  // namespace

TEST_CASE("checking: each text has its errors and is put right as the tables say") {
    hold_tables("checking", kCheckingProbes);
}
