#include "tests/unit/dialogue/checking/checked.h"

using namespace fulcrum::dialogue;

TEST_CASE("free comparison: degrees that are formed twice or in the wrong way") {
    check_rows(
        {{"The watermelon is more heavier than the egg.",
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
