#include "tests/unit/dialogue/checking/checked.h"

using namespace fulcrum::dialogue;

TEST_CASE("free agreement: pronouns and nouns with their verbs") {
    check_rows({{"It have a ring.", "R:VERB:SVA => It *has* a ring."},
                {"They goes around the sun.", "R:VERB:SVA => They *go* around the sun."},
                {"I thinks it is round.", "R:VERB:SVA => I *think* it is round."},
                {"She don't know.", "R:VERB:SVA => She *doesn't* know."},
                {"I isn't heavy.", "R:VERB:SVA => I *am not* heavy."},
                {"There isn't two moons.", "R:VERB:SVA => There *aren't* two moons."},
                {"He like this place.", "R:VERB:SVA => He *likes* this place."},
                {"You was there.", "R:VERB:SVA => You *were* there."},
                {"I think it have a ring.", "R:VERB:SVA => I think it *has* a ring."},
                {"The planets is round.", "R:VERB:SVA => The planets *are* round."},
                {"Jupiter have a ring.", "R:VERB:SVA => Jupiter *has* a ring."},
                {"Rock are rough.", "R:VERB:SVA => Rock *is* rough."},
                {"The kite have a tail.", "R:VERB:SVA => The kite *has* a tail."},
                {"There are no wind.", "R:VERB:SVA => There *is* no wind."},
                {"The moon are small.", "R:VERB:SVA => The moon *is* small."}});
}

TEST_CASE("free agreement: there is and there are") {
    check_rows({{"There is two moons.", "R:VERB:SVA => There *are* two moons."},
                {"There's secrets.", "R:VERB:SVA => There *are* secrets."},
                {"Is there things inside?", "R:VERB:SVA => *Are* there things inside?"},
                {"There are a moon.", "R:VERB:SVA => There *is* a moon."},
                {"There are person.", "R:NOUN:NUM => There are *people*."}});
}

TEST_CASE("free agreement: it behind a clause without a comma, and stuff that there is") {
    check_rows(
        {{"When you push the side it turn more.",
          "R:VERB:SVA => When you push the side it *turns* more."},
         {"Near the pole it turn faster.", "R:VERB:SVA => Near the pole it *turns* faster."},
         {"There are metal under the cloth.", "R:VERB:SVA => There *is* metal under the cloth."}});
    check_right({"When I push the side I make it turn.", "Let the planet see it turn.",
                 "If you push the pole does it turn?", "If you push the side it can turn.",
                 "There are metal balls.", "There are wood and metal."});
}

TEST_CASE("free agreement: forms behind an auxiliary") {
    check_rows({{"It does not likes me.", "R:VERB:FORM => It does not *like* me."},
                {"Does it has a ring?", "R:VERB:FORM => Does it *have* a ring?"},
                {"It can goes fast.", "R:VERB:FORM => It can *go* fast."},
                {"It be heavy.", "R:VERB:FORM => It *is* heavy."},
                {"You are push it.", "R:VERB:FORM => You push it."},
                {"It is push it more.", "R:VERB:FORM => It *pushes* it more."},
                {"I can is push it.", "R:VERB:FORM => I can push it."}});
}

TEST_CASE("free agreement: good English that looks alike") {
    check_right({"I suggested she sell it.",
                 "I heard it break down.",
                 "Does it have a ring?",
                 "If I were you, I would go.",
                 "Let it go.",
                 "The police are here.",
                 "There are a lot of moons.",
                 "There are dependency conflicts.",
                 "My team is good.",
                 "Last time I was there flags were up.",
                 "There are description and instruction keys.",
                 "What is he like?",
                 "He put it there.",
                 "You and I are here.",
                 "Are there set rules?",
                 "The number of moons is large.",
                 "Star Wars is one of the best.",
                 "My brother and she go there.",
                 "It is open.",
                 "Three newtons is enough.",
                 "They are clean.",
                 "It is lift.",
                 "I think it is drag."});
}

TEST_CASE("free agreement: two things, many in a place, none of what can't be counted") {
    check_rows(
        {{"The egg and the apple is equal.", "R:VERB:SVA => The egg and the apple *are* equal."},
         {"Metal and wood has no smell.", "R:VERB:SVA => Metal and wood *have* no smell."},
         {"Both the egg and the apple does not roll.",
          "R:VERB:SVA => Both the egg and the apple *do* not roll."},
         {"In the solar system there is twenty eight planets.",
          "R:VERB:SVA => In the solar system there *are* twenty eight planets."},
         {"There are no lift.", "R:VERB:SVA => There *is* no lift."},
         {"There is four.", "R:VERB:SVA => There *are* four."},
         {"There is two forces on the kite.", "R:VERB:SVA => There *are* two forces on the kite."},
         {"The force of the weight are small.",
          "R:VERB:SVA => The force of the weight *is* small."},
         {"As far away as possible it get easier.",
          "R:VERB:SVA => As far away as possible it *gets* easier."},
         {"It is easier the closer you is.", "R:VERB:SVA => It is easier the closer you *are*."},
         {"It pulls more when it have wind.", "R:VERB:SVA => It pulls more when it *has* wind."}});
    check_right({"Is the egg and the apple the same?", "The egg fell and the apple is here.",
                 "It is the egg and the apple is red.", "The egg, and the apple is red.",
                 "The one behind you is heavy.", "Bigger than you is the Sun.",
                 "The size of the egg and the apple is the same."});
}
