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
