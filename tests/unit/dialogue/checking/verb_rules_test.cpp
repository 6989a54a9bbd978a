#include "tests/unit/dialogue/checking/checked.h"

using namespace fulcrum::dialogue;

TEST_CASE("free verbs: without do, with to behind a modal, turning back to somebody") {
    check_rows({{"It not have a tail.", "R:VERB:FORM => It *does not* have a tail."},
                {"It no have a tail.", "R:VERB:FORM => It *does not* have a tail."},
                {"They not need it.", "R:VERB:FORM => They *do not* need it."},
                {"The kite not need a tail.", "R:VERB:FORM => The kite *does not* need a tail."},
                {"It must to have a tail.", "U:PREP => It must have a tail."},
                {"The kite should to fly.", "U:PREP => The kite should fly."},
                {"It turns around himself.", "R:PRON => It turns around *itself*."}});
    check_right({"It does not have a tail.", "It has no tail.", "It can not fly.",
                 "He turns around himself.", "The man said it to himself.",
                 "The can to the left is full.", "A garbage can to fill is there.",
                 "If it not only pulls, it turns."});
}
