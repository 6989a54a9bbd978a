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

TEST_CASE("free order: a verb or a pronoun that is missing or said twice") {
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
                {"The lift it pulls the kite up.", "U:PRON => The lift pulls the kite up."},
                {"It is far of the support.", "R:PREP => It is far *from* the support."}});
}

TEST_CASE("free order: good English that looks alike") {
    check_right({"I painted the door red.", "It is a day old.", "I know why it is heavy.",
                 "How heavy is it?", "Is it heavy?", "The first time it is hard.", "It is really.",
                 "This feels rough.", "That sounds good.", "How many moons are there around Mars?",
                 "The weight it lifts is big.", "Make the box heavy.", "She hardly feels it.",
                 "I feel happiness.", "You are welcome too.", "It is a bit cold.",
                 "The game it is based on is old."});
}
