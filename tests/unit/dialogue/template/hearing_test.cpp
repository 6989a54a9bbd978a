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
    CHECK(heard("so the egg") == "(so) the egg");
    CHECK(heard("the egg so") == "the egg so");
    CHECK(heard("the egg of course") == "the egg (of) (?)");
    CHECK(heard("now exactly an egg altogether") == "(?) (?) an egg (?)");
    CHECK(heard("dinosaur") == "?");
    CHECK(heard("ham leg") == "? ?");
    CHECK(heard("").empty());
}

TEST_CASE("hearing: what frames an answer is let pass, one frame behind the other") {
    CHECK(heard("well of course I think the egg I guess") ==
          "(?) (of) (?) (?) (?) the egg (?) (?)");
    CHECK(heard("the egg I think because it is the most heavy") ==
          "the egg (?) (?) (?) (?) (?) (?) (?) (?)");
    CHECK(heard("I don't think the egg") == "? do not ? the egg");
    CHECK(heard("the egg since it is heavy") == "the egg (?) (?) (?) (?)");
    CHECK(heard("the egg so that it is heavy") == "the egg (?) (?) (?) (?) (?)");
    CHECK(heard("because the egg") == "? the egg");  // no answer before it
    CHECK(heard("I think") == "? ?");
    CHECK(heard("the egg not because it is heavy") == "the egg not (?) (?) (?) (?)");
    // A template may ask for the reason itself.
    const TemplateSet asked =
        compiled_templates({{"it floats because it is <comparative:light>"}, {}, {}});
    std::size_t work = 0;
    CHECK_FALSE(hear_words(asked, "it floats because it is lighter", work)[2].filler);
}

TEST_CASE("hearing: then, first or last, is no slip of than") {
    const TemplateSet set =
        compiled_templates({{"the lift is <comparative:small> [than the weight]"}, {}, {}});
    std::size_t work = 0;
    CHECK(hear_words(set, "the lift is smaller then", work)[4].filler);
    CHECK(hear_words(set, "then the lift is smaller", work)[0].filler);
    CHECK(hear_words(set, "the lift is smaller then because it fell", work)[4].filler);
    CHECK_FALSE(hear_words(set, "the lift is smaller then the weight", work)[4].filler);
    CHECK_FALSE(hear_words(set, "then", work)[0].filler);
}

TEST_CASE("hearing: who is spoken to is let pass first or last, and is a verb elsewhere") {
    CHECK(heard("Miss, the egg") == "(?) the egg");
    CHECK(heard("um teacher the egg") == "(?) (?) the egg");
    CHECK(heard("the egg, sir, because it is heavy") == "the egg (?) (?) (?) (?) (?)");
    CHECK(heard("it miss the egg") == "it ? the egg");
}

TEST_CASE("hearing: so before a clause begins a reason where that is asked for, and not else") {
    const Question question = heaviest();
    const auto unread = [&](std::string_view said, Reason reason) {
        std::size_t work = 0;
        int count = 0;
        for (const HeardWord& word :
             hear_words(*question.templates, said, work, Its::contraction, reason)) {
            count += word.unread ? 1 : 0;
        }
        return count;
    };
    CHECK(unread("the egg so it falls", Reason::so_too) == 3);
    CHECK(unread("the egg so it falls", Reason::because) == 0);
    CHECK(unread("the egg is so heavy", Reason::so_too) == 0);
    CHECK(unread("the egg because it falls", Reason::because) == 3);
    CHECK(has_consequence(*question.templates, "so it is"));
    CHECK_FALSE(has_consequence(*question.templates, "it is"));
}

TEST_CASE("hearing: two letters may be a slip of a listed noun, and of nothing else") {
    CHECK(heard("the eg") == "the egg~");
    CHECK(heard("th egg") == "? egg");
    CHECK(heard("on ha up") == "? ? ?");
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
