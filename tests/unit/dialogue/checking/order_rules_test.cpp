#include "tests/unit/dialogue/checking/checked.h"

using namespace fulcrum::dialogue;

TEST_CASE("free order: adjectives before their nouns, verbs before the subject of a question") {
    check_rows({{"I felt a car red.", "R:WO => I felt *a red car*."},
                {"It is an apple heavy.", "R:WO => It is *a heavy apple*."},
                {"The car red is fast.", "R:WO => *The red car* is fast."},
                {"Why the apple is heavy?", "R:WO => Why *is the apple* heavy?"},
                {"What it is?", "R:WO => What *is it*?"},
                {"How many moons Jupiter has?", "R:WO => How many moons *does Jupiter have*?"}});
}

TEST_CASE("free order: an adverb or a noun where the adjective belongs") {
    check_rows({{"The rock feels hardly.", "R:MORPH => The rock feels *hard*."},
                {"The metal is hardness.", "R:MORPH => The metal is *hard*."},
                {"It feels smoothy.", "R:MORPH => It feels *smooth*."},
                {"Metal feels like hard.", "U:PREP => Metal feels hard."}});
}

TEST_CASE("free order: of a material, and behind feels, nothing but an adjective") {
    check_rows({{"Rock feels smoothness.", "R:MORPH => Rock feels *smooth*."},
                {"This one feels roughness.", "R:MORPH => This one feels *rough*."},
                {"Metal is smooths.", "R:MORPH => Metal is *smooth*."},
                {"It feels roughs and hard.", "R:MORPH => It feels *rough* and hard."},
                {"Wood is hardy.", "R:MORPH => Wood is *hard*."},
                {"Rubber is stick.", "R:MORPH => Rubber is *sticky*."},
                {"It feels stick.", "R:MORPH => It feels *sticky*."}});
    check_right({"The plant is hardy.", "Metal feels sticky.", "That is a stick.",
                 "This is softness.", "It is dust.", "These are lights."});
}

TEST_CASE("free order: what is compared stands before its noun, unless it is made so") {
    check_rows({{"It needs a tail shorter.", "R:WO => It needs *a shorter tail*."},
                {"We have to use a cloth heavier.", "R:WO => We have to use *a heavier cloth*."},
                {"It is far of the support.", "R:PREP => It is far *from* the support."}});
    check_right({"You have to make the tail shorter.", "I want to make a tail shorter.",
                 "The kite needs a shorter tail."});
}

TEST_CASE("free order: good English that looks alike") {
    check_right({"I painted the door red.", "It is a day old.", "I know why it is heavy.",
                 "How heavy is it?", "Is it heavy?", "The first time it is hard.", "It is really.",
                 "This feels rough.", "That sounds good.", "How many moons are there around Mars?",
                 "The weight it lifts is big.", "Make the box heavy.", "She hardly feels it.",
                 "I feel happiness.", "You are welcome too.", "It is a bit cold.",
                 "The game it is based on is old."});
}
