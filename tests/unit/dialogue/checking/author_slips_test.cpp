#include "dialogue/checking/author_slips.h"

#include "tests/unit/dialogue/checking/checked.h"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

using namespace fulcrum::dialogue;

namespace {

const std::vector<std::string> kThings = {"block", "ball", "apple"};

/// "float -> floats", or nothing.
std::string slip(std::string_view text) {
    static const Lexicon lexicon = opened_lexicon();
    std::string all;
    for (const FreeError& error : find_author_slips(read_sentences(lexicon, text, kThings), text)) {
        all += (all.empty() ? "" : ", ") + error.said + " -> " + error.right;
        CHECK(text.substr(error.begin, error.end - error.begin) == error.said);
    }
    return all;
}

}  // namespace

TEST_CASE("author slips: what a caption, a hint or a prompt cannot mean") {
    CHECK(slip("The wooden block float.") == "float -> floats");
    CHECK(slip("Look! The ball fall.") == "fall -> falls");
    CHECK(slip("Lifts the block.") == "Lifts -> Lift");
    CHECK(slip("Feels them again.") == "Feels -> Feel");
    CHECK(slip("Which one are light?") == "are -> is");
    CHECK(slip("Which block are heavier?") == "are -> is");
    CHECK(slip("Where float the wooden block?") == " -> does");
}

TEST_CASE("author slips: good English is none") {
    for (const char* text : {"The wooden block floats.",
                             "The wooden block.",
                             "The wooden blocks float.",
                             "The block float",
                             "Lift the block.",
                             "Which one are you?",
                             "Which ones are light?",
                             "Which one is light?",
                             "Which blocks are heavy?",
                             "Planets the hand can turn are small.",
                             "Rocks are hard.",
                             "Weights pull the hand down.",
                             "Is it hard?",
                             "Let the ball fall.",
                             "Where does the block float?",
                             "Where is the block?",
                             "How heavy the block is!",
                             "How can the ball roll?",
                             "Watch the ball fall.",
                             "Which one are the apples in?"}) {
        CAPTURE(text);
        CHECK(slip(text).empty());
    }
}

TEST_CASE("author slips: why with a plain verb asks what for, which is seldom meant") {
    static const Lexicon lexicon = opened_lexicon();
    const auto why = [&](std::string_view text) {
        return find_doubtful_question(read_sentences(lexicon, text, kThings), text);
    };
    CHECK(why("Look. Why float the wooden block?") == "Why float the wooden block");
    CHECK(why("Why does the wooden block float?").empty());
    CHECK(why("Why not?").empty());
    CHECK(why("What is made the wooden block?") == "What is made the wooden block");
    CHECK(why("What is the wooden block made of?").empty());
    CHECK(why("What is made of wood?").empty());
}

TEST_CASE("author slips: a review tells them, and what is said to learners does not") {
    EnglishChecker checker = words_alone();
    checker.set_things(kThings);
    const CheckedText review = checker.review("The wooden block float.");
    REQUIRE(review.errors.size() == 1);
    CHECK(review.errors[0].right == "floats");
    CHECK_FALSE(review.proven);
    CHECK(checker.advise("The wooden block float.").errors.empty());
    CHECK(checker.review("Why float the block?").unread == "Why float the block");
}
