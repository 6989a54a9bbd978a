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

TEST_CASE("free order: a verb at the end, or behind what is compared") {
    check_rows(
        {{"It the apple is.", "R:WO => It *is the apple*."},
         {"The egg is of metal made.", "R:WO => The egg is *made of metal*."},
         {"The bowl heavier is than the egg.", "R:WO => The bowl *is heavier* than the egg."},
         {"The bowl the heaviest is.", "R:WO => The bowl *is the heaviest*."}});
    check_right({"It is the apple.", "I know what it is.", "This the teacher is sure of.",
                 "The heavier is the egg.", "The best is yet to come.", "It is of metal.",
                 "The bowl is heavier than the egg is."});
}

TEST_CASE("free order: what is pointed out by it is goes on with that") {
    check_rows({{"It's lift what holds up.", "R:PRON => It's lift *that* holds up."},
                {"It is the lift what pulls it.", "R:PRON => It is the lift *that* pulls it."}});
    check_right({"It is what it is.", "It is lift that holds it up.", "It is clear what it does.",
                 "It is the lift."});
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
