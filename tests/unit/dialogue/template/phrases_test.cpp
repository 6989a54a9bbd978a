#include "dialogue/template/phrases.h"

#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

#include <map>

using namespace fulcrum::dialogue;

namespace {

/// What each wording of a one-place graph is marked as.
template <class Write>
std::map<std::string, ErrorCode> codes(const Write& write) {
    TemplateSet set;
    ArcWriter writer(set, 1000);
    const int start = writer.add_node();
    const int end = writer.add_node();
    write(writer, start, end);
    const Graph graph = writer.finish(start, end);
    std::map<std::string, ErrorCode> result;
    for (const Arc& arc : graph.arcs) {
        std::string said;
        for (const int word : graph.said_by(arc)) {
            said += (said.empty() ? "" : " ") + set.words.text(word);
        }
        if (arc.element != kNone) {
            result[said] = arc.code;
        }
    }
    return result;
}

WordList only(const std::string& word) {
    return {"", {{word, {Noun{word}}}}};
}

}  // namespace

TEST_CASE("phrases: a literal verb knows its other number, its absence and its wrong forms") {
    const auto is =
        codes([](ArcWriter& writer, int a, int b) { add_word(writer, "is", "is", {}, a, b); });
    CHECK(is.at("is") == ErrorCode::none);
    CHECK(is.at("are") == ErrorCode::agreement);
    CHECK(is.at("") == ErrorCode::missing_verb);
    CHECK(is.at("be") == ErrorCode::verb_form);
    CHECK(is.at("was") == ErrorCode::none);
    CHECK(is.at("were") == ErrorCode::agreement);
    const auto floats = codes([](ArcWriter& writer, int a, int b) {
        add_word(writer, "floats", "floats", {.after_list = true}, a, b);
    });
    CHECK(floats.at("float") == ErrorCode::agreement);
    CHECK(floats.at("it") == ErrorCode::extra_pronoun);
    CHECK(floats.count("") == 0);
}

TEST_CASE("phrases: a literal article may be wrong or missing, <article> may not") {
    const auto the =
        codes([](ArcWriter& writer, int a, int b) { add_word(writer, "the", "the", {}, a, b); });
    CHECK(the.at("the") == ErrorCode::none);
    CHECK(the.at("a") == ErrorCode::wrong_determiner);
    CHECK(the.at("") == ErrorCode::missing_determiner);
    for (const auto& [said, code] : codes([](ArcWriter&writer, int a, int b) {
             add_article(writer, "", SubjectNumber::unknown, a, b);
         })) {
        CHECK(code == ErrorCode::none);
    }
    CHECK(is_article("an"));
    CHECK_FALSE(is_article("one"));
}

TEST_CASE("phrases: prepositions are confused and left out, other words are as they are") {
    const auto than =
        codes([](ArcWriter& writer, int a, int b) { add_word(writer, "than", "than", {}, a, b); });
    CHECK(than.at("then") == ErrorCode::wrong_preposition);
    CHECK(than.at("") == ErrorCode::missing_preposition);
    const auto fruit = codes(
        [](ArcWriter& writer, int a, int b) { add_word(writer, "fruit", "fruit", {}, a, b); });
    CHECK(fruit.size() == 1);
}

TEST_CASE("phrases: degrees and plurals hold right and wrong forms") {
    const auto heavier = codes([](ArcWriter& writer, int a, int b) {
        add_degree(writer, only("heavy"), kNone, Degree::comparative, false, a, b);
    });
    CHECK(heavier.at("heavier") == ErrorCode::none);
    CHECK(heavier.at("much") == ErrorCode::none);
    CHECK(heavier.at("very") == ErrorCode::wrong_adverb);
    CHECK(heavier.at("more heavy") == ErrorCode::adjective_form);
    const auto heaviest = codes([](ArcWriter& writer, int a, int b) {
        add_degree(writer, only("heavy"), kNone, Degree::superlative, true, a, b);
    });
    CHECK(heaviest.count("the") == 0);
    CHECK(heaviest.count("much") == 0);
    const auto feet =
        codes([](ArcWriter& writer, int a, int b) { add_plural(writer, "foot", false, a, b); });
    CHECK(feet.at("feet") == ErrorCode::none);
    CHECK(feet.at("foot") == ErrorCode::noun_number);
    CHECK(feet.at("foots") == ErrorCode::noun_inflection);
    CHECK(feet.count("") == 0);
    const auto counted =
        codes([](ArcWriter& writer, int a, int b) { add_plural(writer, "foot", true, a, b); });
    CHECK(counted.at("") == ErrorCode::none);
    const auto sheep =
        codes([](ArcWriter& writer, int a, int b) { add_plural(writer, "sheep", false, a, b); });
    CHECK(sheep.at("sheep") == ErrorCode::none);
}

TEST_CASE("phrases: and between adjectives may be but, is left out or is another word") {
    const auto between = codes([](ArcWriter& writer, int a, int b) {
        add_word(writer, "and", "and", {.after_adjective = true, .before_adjective = true}, a, b);
    });
    CHECK(between.at("and") == ErrorCode::none);
    CHECK(between.at("but") == ErrorCode::none);
    CHECK(between.at("") == ErrorCode::missing_conjunction);
    CHECK(between.at("or") == ErrorCode::wrong_conjunction);
    const auto plain = codes([](ArcWriter& writer, int a, int b) {
        add_word(writer, "and", "and", {.after_adjective = true}, a, b);
    });
    CHECK(plain.size() == 1);
}

TEST_CASE("phrases: feels takes no like before an adjective, and may be felt") {
    const auto feels = codes([](ArcWriter& writer, int a, int b) {
        add_word(writer, "feels", "feels", {.before_adjective = true}, a, b);
    });
    CHECK(feels.at("feels like") == ErrorCode::extra_preposition);
    CHECK(feels.at("felt") == ErrorCode::none);
    const auto like = codes(
        [](ArcWriter& writer, int a, int b) { add_word(writer, "feels", "feels", {}, a, b); });
    CHECK(like.count("feels like") == 0);
}

TEST_CASE("phrases: <it> is one or many, or forgotten; tyre is tire") {
    const auto it = codes(
        [](ArcWriter& writer, int a, int b) { add_it(writer, SubjectNumber::unknown, a, b); });
    CHECK(it.at("it") == ErrorCode::none);
    CHECK(it.at("those") == ErrorCode::none);
    CHECK(it.at("") == ErrorCode::missing_pronoun);
    const auto one = codes(
        [](ArcWriter& writer, int a, int b) { add_it(writer, SubjectNumber::singular, a, b); });
    CHECK(one.at("it") == ErrorCode::none);
    CHECK(one.at("they") == ErrorCode::wrong_pronoun);
    const auto many =
        codes([](ArcWriter& writer, int a, int b) { add_it(writer, SubjectNumber::plural, a, b); });
    CHECK(many.at("those") == ErrorCode::none);
    CHECK(many.at("this") == ErrorCode::wrong_pronoun);
    const auto tyre =
        codes([](ArcWriter& writer, int a, int b) { add_word(writer, "tyre", "tyre", {}, a, b); });
    CHECK(tyre.at("tire") == ErrorCode::none);
}
