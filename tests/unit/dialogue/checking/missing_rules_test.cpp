#include "tests/unit/dialogue/checking/checked.h"

using namespace fulcrum::dialogue;

TEST_CASE("free English: a verb or a pronoun that is missing or said twice") {
    check_rows({{"It heavy.", "M:VERB => It *is* heavy."},
                {"They very small.", "M:VERB => They *are* very small."},
                {"The tallest block the metal block.",
                 "M:VERB => The tallest block *is* the metal block."},
                {"The apple heavier.", "M:VERB => The apple *is* heavier."},
                {"Rock rough.", "M:VERB => Rock *is* rough."},
                {"There no wind.", "M:VERB => There *is* no wind."},
                {"Watermelon heavier than apple.", "M:VERB => Watermelon *is* heavier than apple."},
                {"Is very heavy.", "M:PRON => *It is* very heavy."},
                {"The rock it is hard.", "U:PRON => The rock is hard."},
                {"The lift it pulls the kite up.", "U:PRON => The lift pulls the kite up."}});
}

TEST_CASE("free English: a sentence of two names, a place or a question without its verb") {
    check_rows(
        {{"An apple the heaviest of all.", "M:VERB => An apple *is* the heaviest of all."},
         {"Uranus the biggest planet of them all.",
          "M:VERB => Uranus *is* the biggest planet of them all."},
         {"The lightest object a banana.", "M:VERB => The lightest object *is* a banana."},
         {"It Venus.", "M:VERB => It *is* Venus."},
         {"It on top of the stone block.", "M:VERB => It *is* on top of the stone block."},
         {"It the weight of the line.", "M:VERB => It *is* the weight of the line."},
         {"There not any lift.", "M:VERB => There *is* not any lift."},
         {"The wind stronger high above it.", "M:VERB => The wind *is* stronger high above it."},
         {"The lift too weak.", "M:VERB => The lift *is* too weak."},
         {"What the distance of Venus from the Sun?",
          "M:VERB => What *is* the distance of Venus from the Sun?"},
         {"How big the Earth?", "M:VERB => How big *is* the Earth?"}});
    check_right({"The red one between the others.", "What the boy said?", "How big a dog?",
                 "There, not here.", "Mars, the red planet.", "On top of the stone block."});
}

TEST_CASE(
    "free English: among several adjectives a verb or its it is missed, with commas or without") {
    check_rows(
        {{"It slippery, soft and hard.", "M:VERB => It *is* slippery, soft and hard."},
         {"It sticky smooth and soft.", "M:VERB => It *is* sticky smooth and soft."},
         {"Rubber soft and hard and sticky.", "M:VERB => Rubber *is* soft and hard and sticky."},
         {"Is sticky smooth and soft.", "M:PRON => *It is* sticky smooth and soft."},
         {"Is slippery, soft and hard.", "M:PRON => *It is* slippery, soft and hard."}});
    check_right({"Soft, hard and sticky.", "Is it soft and hard?", "Is metal hard and smooth?",
                 "The smooth and hard rock fell.", "It feels soft and hard."});
}

TEST_CASE(
    "free English: a clause behind when, as or since may miss its verb or name its subject twice") {
    check_rows(
        {{"It pulls more when the wind stronger.",
          "M:VERB => It pulls more when the wind *is* stronger."},
         {"When the wind stronger, it flies.", "M:VERB => When the wind *is* stronger, it flies."},
         {"It fell since the kite heavier than the lift.",
          "M:VERB => It fell since the kite *is* heavier than the lift."},
         {"It pulls more when the wind it is stronger.",
          "U:PRON => It pulls more when the wind is stronger."},
         {"As the wind it was stronger.", "U:PRON => As the wind was stronger."},
         {"It the blue one.", "M:VERB => It *is* the blue one."},
         {"Lift stronger than drag.", "M:VERB => Lift *is* stronger than drag."},
         {"It the lift that holds it up.", "M:VERB => It *is* the lift that holds it up."},
         {"The drag the force that pulls it back.",
          "M:VERB => The drag *is* the force that pulls it back."},
         {"It fell because there more weight.",
          "M:VERB => It fell because there *is* more weight."},
         {"The apple the heavier of the two.", "M:VERB => The apple *is* the heavier of the two."},
         {"It fell because the weight more than the lift.",
          "M:VERB => It fell because the weight *is* more than the lift."},
         {"Is the weight of the line.", "M:PRON => *It is* the weight of the line."},
         {"Is made out of glass.", "M:PRON => *It is* made out of glass."}});
    check_right({"A bit bigger than without the wind.", "The planets orbit the Sun.",
                 "It is lift in the line.", "A lot weaker.", "It is as heavy as the heavier one.",
                 "It is easier when the arm is longer.",
                 "It pulls more when the wind gets stronger.", "It moves as the hand it follows.",
                 "The longer the arm, the easier it is.", "I feel the weight more than the lift.",
                 "The heavier of the two."});
}

TEST_CASE("free English: there is, behind because") {
    check_rows(
        {{"It fell because no wind.", "M:VERB => It fell because *there is* no wind."},
         {"It fell because not wind.", "M:VERB => It fell because *there is no* wind."},
         {"It pulls because is more wind.", "M:PRON => It pulls because *there* is more wind."}});
    check_right({"It fell, but not hard.", "It is late, but no worries.",
                 "It fell because nobody held it.", "It is good because no wind blows."});
}

TEST_CASE("free English: is with nothing but a name behind it wants its it") {
    check_rows(
        {{"Is the lift.", "M:PRON => *It is* the lift."}, {"Is wood.", "M:PRON => *It is* wood."}});
    check_right({"Is the lift weak?", "Is it?", "It is wood."});
}

TEST_CASE("free English: what is measured and stuff without an article miss their verb as well") {
    check_rows(
        {{"Weight stronger.", "M:VERB => Weight *is* stronger."},
         {"Rock harder.", "M:VERB => Rock *is* harder."},
         {"Lift the bigger force.", "M:VERB => Lift *is* the bigger force."},
         {"Wood the harder of the two.", "M:VERB => Wood *is* the harder of the two."},
         {"Rock the more slippery one.", "M:VERB => Rock *is* the more slippery one."},
         {"Wood slippery like glass.", "M:VERB => Wood *is* slippery like glass."},
         {"The lift force bigger than the weight.",
          "M:VERB => The lift force *is* bigger than the weight."},
         {"It the weight force.", "M:VERB => It *is* the weight force."},
         {"The force of the weight stronger than the lift.",
          "M:VERB => The force of the weight *is* stronger than the lift."},
         {"The weight bigger now.", "M:VERB => The weight *is* bigger now."},
         {"Uranus closer to the Sun.", "M:VERB => Uranus *is* closer to the Sun."},
         {"It is easier where my arm long.", "M:VERB => It is easier where my arm *is* long."},
         {"It easier the longer I push.", "M:VERB => It *is* easier the longer I push."},
         {"It made of grey cloth.", "M:VERB => It *is* made of grey cloth."}});
    check_right({"The force of the weight.", "The lift force of the kite.",
                 "The force of the weight is stronger.", "It is made of grey paper.",
                 "Lift the knot.", "The weight of the apple.", "Wood or rock.",
                 "The harder of the two.", "The line of the kite pulls harder.",
                 "It pulls me up where my arm is."});
}
