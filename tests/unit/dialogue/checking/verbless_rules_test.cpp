#include "tests/unit/dialogue/checking/checked.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

TEST_CASE("free English: two that are compared, and none, want their verb") {
    check_rows(
        {{"The egg and the apple the same.", "M:VERB => The egg and the apple *are* the same."},
         {"Metal and wood identical.", "M:VERB => Metal and wood *are* identical."},
         {"None heavier.", "M:VERB => None *is* heavier."}});
    check_right({"The egg and the apple are the same.", "None is heavier.", "None.",
                 "The egg and the apple."});
}

TEST_CASE("free English: behind where something is or what one does a clause wants its verb too") {
    check_rows({{"When we press far from it it easier.",
                 "M:VERB => When we press far from it it *is* easier."},
                {"At the handle it easier than here.",
                 "M:VERB => At the handle it *is* easier than here."},
                {"Near the side the arm longer.", "M:VERB => Near the side the arm *is* longer."},
                {"At the pole of it the lever arm longer.",
                 "M:VERB => At the pole of it the lever arm *is* longer."},
                {"Pressing it far from the support easier.",
                 "M:VERB => Pressing it far from the support *is* easier."},
                {"Turning the Earth harder than turning Jupiter.",
                 "M:VERB => Turning the Earth *is* harder than turning Jupiter."},
                {"To turn Jupiter more difficult than to turn the Earth.",
                 "M:VERB => To turn Jupiter *is* more difficult than to turn the Earth."},
                {"What the distance of Venus?", "M:VERB => What *is* the distance of Venus?"}});
    check_right({"Pressing it harder.", "To turn it harder.", "Near the side the arm is longer.",
                 "Pushing it far from the support is easier.", "At the side, harder.",
                 "Turning the Earth is harder than turning Jupiter.", "On the table the egg."});
}
