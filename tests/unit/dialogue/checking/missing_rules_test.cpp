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

TEST_CASE("free English: is with nothing but a name behind it wants its it") {
    check_rows(
        {{"Is the lift.", "M:PRON => *It is* the lift."}, {"Is wood.", "M:PRON => *It is* wood."}});
    check_right({"Is the lift weak?", "Is it?", "It is wood."});
}
