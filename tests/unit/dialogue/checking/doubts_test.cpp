#include "dialogue/checking/doubts.h"

#include "tests/unit/dialogue/checking/checked.h"

#include <string>
#include <vector>

using namespace fulcrum::dialogue;

namespace {

bool doubted(std::string_view text) {
    static const Lexicon lexicon = opened_lexicon();
    static const std::vector<std::string> things = {"hand", "tail", "block"};
    const auto sentences = read_sentences(lexicon, text, things);
    REQUIRE(sentences.size() == 1);
    return is_doubtful(sentences[0]);
}

}  // namespace

TEST_CASE("doubts: what a judge of sentences lets pass, and may be no English") {
    for (const char* text : {"The kite is fly.",
                             "The support has to come nearer hand.",
                             "It needs longer tail.",
                             "Thirteen planets they are round it.",
                             "An apple is more much lighter than an egg.",
                             "It is a glorpfish.",
                             "The kite flies very highly.",
                             "It pulls more hardly.",
                             "It makes the kite to fly.",
                             "It pushes in up.",
                             "It turns around himself.",
                             "Because he is big.",
                             "It wishes a tail.",
                             "It misses the tail.",
                             "It is heavier as the wood.",
                             "It is the same than before.",
                             "It is as heavy than an egg.",
                             "It flies more high.",
                             "It is too much heavy.",
                             "It has not a tail.",
                             "How many moons have the Earth?",
                             "Because wind stopped.",
                             "It is easier in the side.",
                             "The Sun gives light and warm.",
                             "It is big and have moons.",
                             "A tail is longer.",
                             "It must have longer."}) {
        INFO(text);
        CHECK(doubted(text));
    }
}

TEST_CASE("doubts: none about good English") {
    for (const char* text : {"The kite flies.",
                             "The support has to come nearer the hand.",
                             "It needs a longer tail.",
                             "It needs one tail.",
                             "Thirteen planets are round it.",
                             "It is heavy.",
                             "An apple is much lighter than an egg.",
                             "Under the red block there is metal.",
                             "It is on top.",
                             "Jupiter is bigger than Mars.",
                             "My hand feels two tails.",
                             "The kite flies very high.",
                             "Hardly any wind is there.",
                             "It is nearly as heavy.",
                             "It makes the kite fly.",
                             "It comes from under the block.",
                             "It turns around itself.",
                             "I think he turns himself.",
                             "We miss the block.",
                             "It is as heavy as an egg.",
                             "It is the same as before.",
                             "It does not have a tail.",
                             "How many moons has it got?",
                             "The wind stopped.",
                             "It is in the middle.",
                             "It is hard and rough.",
                             "They are big and have moons.",
                             "The tail is longer.",
                             "It has a longer tail."}) {
        INFO(text);
        CHECK_FALSE(doubted(text));
    }
}
