#include "tests/unit/dialogue/checking/checked.h"

using namespace fulcrum::dialogue;

TEST_CASE("free making: what things are made of") {
    check_rows(
        {{"A spaceship is made by metal.", "R:PREP => A spaceship is made *of* metal."},
         {"A spaceship is make of metal.", "R:VERB:FORM => A spaceship is *made* of metal."},
         {"A spaceship is maked of metal.", "R:VERB:INFL => A spaceship is *made* of metal."},
         {"He maked it.", "R:VERB:INFL => He *made* it."},
         {"A spaceship made of metal.", "M:VERB => A spaceship *is* made of metal."},
         {"A spaceship makes of metal.", "R:VERB:VOICE => A spaceship *is made* of metal."},
         {"A spaceship is made metal.", "M:PREP => A spaceship is made *of* metal."},
         {"A spaceship is made of the metal.", "U:DET => A spaceship is made of metal."}});
}

TEST_CASE("free making: good English that looks alike") {
    check_right({"Paper is made from wood.", "It was made by hand.", "It is made out of wood.",
                 "The cake was made with love.", "It was made by metal workers.",
                 "I have a spaceship made of metal in my room.", "What do you make of it?",
                 "It is made of the metal from the mine."});
}

TEST_CASE("free making: behind be, not and something") {
    check_rows({{"It could be made rubber.", "M:PREP => It could be made *of* rubber."},
                {"It made of thick paper.", "M:VERB => It *is* made of thick paper."},
                {"It is not made gold.", "M:PREP => It is not made *of* gold."},
                {"It must be made by metal.", "R:PREP => It must be made *of* metal."}});
    check_right({"It could be made of rubber.", "It must be made by hand."});
}
