#include "dialogue/template/hearing.h"

#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

namespace {

/// Each word as the templates know it: "word", "(filler)", "word~" when a slip was put right, "?" when unknown.
std::string heard(std::string_view utterance) {
    const Question question = heaviest();
    std::size_t work = 0;
    std::string result;
    for (const HeardWord& word : hear_words(*question.templates, utterance, work)) {
        const std::string text =
            word.word == kNone ? "?" : question.templates->words.text(word.word);
        result +=
            (result.empty() ? "" : " ") +
            (word.filler ? "(" + text + ")" : text + (word.slip == ErrorCode::none ? "" : "~"));
    }
    return result;
}

}  // namespace

TEST_CASE("hearing: known words, slips, fillers and unknown words") {
    CHECK(heard("a watermelon is heaviest") == "a watermelon is heaviest");
    CHECK(heard("watermellon") == "watermelon~");
    CHECK(heard("wtaermelon") == "watermelon~");
    CHECK(heard("water melon") == "watermelon~");
    CHECK(heard("its an egg") == "it~ is an egg");
    CHECK(heard("um an egg please") == "(?) an egg (?)");
    CHECK(heard("I think the egg") == "(?) (?) the egg");
    CHECK(heard("well, I think that the egg") == "(?) (?) (?) (that) the egg");
    CHECK(heard("the egg of course") == "the egg (?) (?)");
    CHECK(heard("dinosaur") == "?");
    CHECK(heard("ham leg") == "? ?");
    CHECK(heard("").empty());
}

TEST_CASE("hearing: what frames an answer is let pass, one frame behind the other") {
    CHECK(heard("well of course I think the egg I guess") == "(?) (?) (?) (?) (?) the egg (?) (?)");
    CHECK(heard("the egg I think because it is the most heavy") ==
          "the egg (?) (?) (?) (?) (?) (?) (?) (?)");
    CHECK(heard("I don't think the egg") == "? ? ? ? the egg");
    CHECK(heard("because the egg") == "? the egg");  // no answer before it
    CHECK(heard("I think") == "? ?");
    CHECK(heard("the egg not because it is heavy") == "the egg ? (?) (?) (?) (?)");
    // A template may ask for the reason itself.
    const TemplateSet asked =
        compiled_templates({{"it floats because it is <comparative:light>"}, {}, {}});
    std::size_t work = 0;
    CHECK_FALSE(hear_words(asked, "it floats because it is lighter", work)[2].filler);
}

TEST_CASE("hearing: two letters may be a slip of a listed noun, and of nothing else") {
    CHECK(heard("the eg") == "the egg~");
    CHECK(heard("th egg") == "? egg");
    CHECK(heard("on no up") == "? ? ?");
    const auto word = [](std::vector<std::string> things, std::string_view said) {
        const TemplateSet set =
            compiled_templates({{"it is <article> {thing}"}, {{"thing", std::move(things)}}, {}});
        std::size_t work = 0;
        const int number = hear_words(set, said, work).at(0).word;
        return number == kNone ? std::string("?") : set.words.text(number);
    };
    CHECK(word({"cup", "box"}, "bx") == "box");
    CHECK(word({"cup", "cap"}, "cp") == "?");
    CHECK(word({"ton"}, "to") == "?");  // a word of its own
    CHECK(word({"ton"}, "tn") == "ton");
    CHECK(word({"tea", "egg"}, "te") == "?");  // or "the"
}

TEST_CASE("hearing: two words are one only when they aren't both known") {
    const auto words_heard = [](std::vector<std::string> things, std::string_view said) {
        const TemplateSet set =
            compiled_templates({{"it is <article> {thing}"}, {{"thing", std::move(things)}}, {}});
        std::size_t work = 0;
        return hear_words(set, said, work).size();
    };
    CHECK(words_heard({"watermelon"}, "water melon") == 1);
    CHECK(words_heard({"watermelon", "water"}, "water melon") == 1);
    CHECK(words_heard({"watermelon", "a melon"}, "water melon") == 1);
    CHECK(words_heard({"watermelon", "water", "a melon"}, "water melon") == 2);
}

TEST_CASE("hearing: a slip needs the same first letter or its swap, and one best word") {
    CHECK(heard("batermelon") == "?");
    CHECK(heard("awtermelon") == "watermelon~");
    CHECK(heard("appel") == "apple~");
    CHECK(heard("bananna") == "banana~");
}

TEST_CASE("hearing: a frame whose words the templates know is no frame") {
    const Question question = feels_how();
    std::size_t work = 0;
    for (const HeardWord& word : hear_words(*question.templates, "it feels like hard", work)) {
        CHECK_FALSE(word.filler);
    }
    const Question plain = heaviest();
    CHECK(hear_words(*plain.templates, "it feels like an egg", work)[2].filler);
}

TEST_CASE("hearing: real words near to the words of textures are no slips") {
    const Question question = feels_how();
    for (const char* said : {"stinky", "grass", "sort", "robber", "medal", "hare", "word"}) {
        INFO(said);
        std::size_t work = 0;
        CHECK(hear_words(*question.templates, said, work)[0].word == kNone);
    }
}
