#include "tests/unit/dialogue/checking/checked.h"

using namespace fulcrum::dialogue;

TEST_CASE("free number: what asks for a plural has one, what asks for a singular too") {
    check_rows(
        {{"Mars has two moon.", "R:NOUN:NUM => Mars has two *moons*."},
         {"I see 2 small planet.", "R:NOUN:NUM => I see 2 small *planets*."},
         {"I watch many kind of movies.", "R:NOUN:NUM => I watch many *kinds* of movies."},
         {"It is one of the biggest planet.", "R:NOUN:NUM => It is one of the biggest *planets*."},
         {"It has one moons.", "R:NOUN:NUM => It has one *moon*."},
         {"Every planets is round.", "R:NOUN:NUM => Every *planet* is round."},
         {"How much moons are there?", "R:DET => How *many* moons are there?"},
         {"I have many information.", "R:DET => I have *much* information."}});
}

TEST_CASE("free number: plurals that are wrongly formed, and of what has none") {
    check_rows(
        {{"I see two moones.", "R:NOUN:INFL => I see two *moons*."},
         {"Three mans and two childs.",
          "R:NOUN:INFL R:NOUN:INFL => Three *men* and two *children*."},
         {"I have two foots.", "R:NOUN:INFL => I have two *feet*."},
         {"Thank you for your advices.", "R:NOUN:NUM => Thank you for your *advice*."},
         {"The informations are good.", "R:NOUN:NUM R:VERB:SVA => The *information* *is* good."},
         {"It takes seven hourss.", "R:NOUN:INFL => It takes seven *hours*."},
         {"Peopless call it energy.", "R:NOUN:INFL => *People* call it energy."}});
}

TEST_CASE("free number: good English that looks alike") {
    check_right({"It is a two year course.", "There are two-door cars.", "I saw a 2020 movie.",
                 "Two fish and three sheep swim.", "I need 20 N.", "Many a man has tried.",
                 "I was in room two today.", "One of them is heavy.", "The news is good.",
                 "How much water is there?", "I went to Los Angeles.", "One way is to push it.",
                 "Two plus two is four.", "Both apple and egg fall."});
}

TEST_CASE("number rules: twenty-one are more than one") {
    check_right({"It has twenty one moons.", "It has twenty-one moons.", "There is one moon.",
                 "It takes a hundred and one hours."});
    check_rows({{"It has twenty one moon.", "R:NOUN:NUM => It has twenty one *moons*."},
                {"It has one moons.", "R:NOUN:NUM => It has one *moon*."}});
}

TEST_CASE("free number: a number before a noun that a verb follows") {
    check_rows(
        {{"Ten moon turn round our planet.", "R:NOUN:NUM => Ten *moons* turn round our planet."},
         {"About nine hour.", "R:NOUN:NUM => About nine *hours*."}});
    check_right({"Two moon rocks lie here.", "Two stones block the way."});
}
