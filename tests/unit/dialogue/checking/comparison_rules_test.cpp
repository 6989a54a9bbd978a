#include "tests/unit/dialogue/checking/checked.h"

using namespace fulcrum::dialogue;

TEST_CASE("free comparison: degrees that are formed twice or in the wrong way") {
    check_rows(
        {{"It is bigger then Mars.", "R:PREP => It is bigger *than* Mars."},
         {"The watermelon is more heavier than the egg.",
          "R:ADJ:FORM => The watermelon is *heavier* than the egg."},
         {"It is the most heaviest fruit.", "R:ADJ:FORM => It is the *heaviest* fruit."},
         {"The watermelon is the most heavy.", "R:ADJ:FORM => The watermelon is the *heaviest*."},
         {"The red car is more fast.", "R:ADJ:FORM => The red car is *faster*."},
         {"It is more easy far from it.", "R:ADJ:FORM => It is *easier* far from it."},
         {"It needs a more long tail.", "R:ADJ:FORM => It needs a *longer* tail."},
         {"This one is more better.", "R:ADJ:FORM => This one is *better*."},
         {"It is most best.", "R:ADJ:FORM => It is *the best*."},
         {"A watermelon is most heavy.", "R:ADJ:FORM => A watermelon is *the heaviest*."},
         {"It is the most heavy.", "R:ADJ:FORM => It is the *heaviest*."},
         {"They are the most heaviest.", "R:ADJ:FORM => They are the *heaviest*."},
         {"Rock is gooder.", "R:ADJ:FORM => Rock is *better*."},
         {"The egg is beautifuler.", "R:ADJ:FORM => The egg is *more beautiful*."},
         {"It is heavyer.", "R:SPELL => It is *heavier*."},
         {"It is biger.", "R:SPELL => It is *bigger*."}});
}

TEST_CASE("free comparison: as for than, adverbs made twice, much before a plain adjective") {
    check_rows(
        {{"It is heavier as the wood.", "R:PREP => It is heavier *than* the wood."},
         {"It is stronger as before.", "R:PREP => It is stronger *than* before."},
         {"It is more heavier as the egg.", "R:ADJ:FORM R:PREP => It is *heavier* *than* the egg."},
         {"It pulls more hardly.", "R:MORPH => It pulls *harder*."},
         {"The kite flies more high.", "R:ADJ:FORM => The kite flies *higher*."},
         {"I must push more hard.", "R:ADJ:FORM => I must push *harder*."},
         {"The kite is too much heavy.", "R:ADV => The kite is too heavy."}});
    check_right({"It is heavier as a whole.", "It gets heavier as the day goes on.",
                 "It is as heavy as the egg.", "It is much too heavy.", "It weighs too much.",
                 "It needs more hard work.", "There are more high than low places."});
}

TEST_CASE("free comparison: more with a short adjective, wherever it stands") {
    check_rows(
        {{"It turns more fast near the pole.", "R:ADJ:FORM => It turns *faster* near the pole."},
         {"It turns more good at the side.", "R:ADJ:FORM => It turns *better* at the side."},
         {"The more heavy one is the egg.", "R:ADJ:FORM => The *heavier* one is the egg."},
         {"I make the tail more short.", "R:ADJ:FORM => I make the tail *shorter*."},
         {"You must use a more light cloth.", "R:ADJ:FORM => You must use a *lighter* cloth."},
         {"It must be more near to your hand.", "R:ADJ:FORM => It must be *nearer* to your hand."},
         {"Uranus is the most near one to the Sun.",
          "R:ADJ:FORM => Uranus is the *nearest* one to the Sun."},
         {"Saturn is more farther from the Sun.",
          "R:ADJ:FORM => Saturn is *farther* from the Sun."},
         {"A banana is light than an egg.", "R:ADJ:FORM => A banana is *lighter* than an egg."}});
    check_right({"It turns more near the pole.", "More near the side it turns better.",
                 "It does more good than harm.", "The more heavy work we do the better.",
                 "It makes everything more easy.", "I want more fast food."});
}

TEST_CASE("free comparison: than, as and what stands around") {
    check_rows(
        {{"The egg is heavy than the apple.", "R:ADJ:FORM => The egg is *heavier* than the apple."},
         {"My diet is worst than before.", "R:ADJ:FORM => My diet is *worse* than before."},
         {"The egg is heavier then the apple.", "R:PREP => The egg is heavier *than* the apple."},
         {"The egg is heavier that the apple.", "R:PREP => The egg is heavier *than* the apple."},
         {"The egg is very heavier.", "R:ADV => The egg is *much* heavier."},
         {"It feels much hard.", "R:ADV => It feels *very* hard."},
         {"The egg is as heavier as the apple.",
          "R:ADJ:FORM => The egg is as *heavy* as the apple."},
         {"The egg is the heavier than the apple.", "U:DET => The egg is heavier than the apple."},
         {"The watermelon is heaviest.", "M:DET => The watermelon is *the* heaviest."}});
}

TEST_CASE("free comparison: than is meant where then compares") {
    check_rows(
        {{"It is stronger then before.", "R:PREP => It is stronger *than* before."},
         {"It is easier then the others.", "R:PREP => It is easier *than* the others."},
         {"It is bigger then all the other planets.",
          "R:PREP => It is bigger *than* all the other planets."},
         {"It is heavier then the egg when it is wet.",
          "R:PREP => It is heavier *than* the egg when it is wet."},
         {"It was weaker then in the breeze.", "R:PREP => It was weaker *than* in the breeze."},
         {"It must be longer then that.", "R:PREP => It must be longer *than* that."},
         {"Stronger then without the wind.", "R:PREP => Stronger *than* without the wind."},
         {"The pull got a bit bigger then before.",
          "R:PREP => The pull got a bit bigger *than* before."},
         {"An apple falls faster then a watermelon.",
          "R:PREP => An apple falls faster *than* a watermelon."},
         {"Lift is bigger then weight now.", "R:PREP => Lift is bigger *than* weight now."},
         {"It is by far heaviest.", "M:DET => It is by far *the* heaviest."},
         {"An egg is not heaviest.", "M:DET => An egg is not *the* heaviest."}});
    check_right({"It gets heavier, then the egg falls.", "It gets heavier then the egg falls.",
                 "It was bigger then.", "It gets bigger then falls.",
                 "It was smaller then in many ways it hurt.",
                 "It is heavier then the others are lighter."});
}

TEST_CASE("free comparison: good English that looks alike") {
    check_right({"I need more time.", "I am more human than machine.",
                 "It is more subtle than direct.", "There are more foreign visitors this year.",
                 "It is getting hotter, then the water boils.",
                 "Jupiter is much bigger than the Earth.",
                 "The more you push, the faster it moves.", "It is other than that.",
                 "Which one is heaviest?", "She would rather go than stay.",
                 "A larger number of moons is better.", "It is heavier than I thought.",
                 "The egg is more beautiful than the apple.", "He likes it most of all."});
}
