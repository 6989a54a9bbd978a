// Errors of where a thing is.
#include "dialogue/checking/proposal.h"

namespace fulcrum::dialogue {

void find_place_errors(const FreeSentence& sentence, Proposals& proposals) {
    for (int i = 0; i < sentence.size(); ++i) {
        if (sentence.is(i, {"next"}) && sentence.be_at(i - 1) && !sentence[i].before_stop &&
            sentence.is(i + 1, {"of"}) && !sentence.is(i + 2, {"all"})) {
            proposals.replace(i + 1, ErrorCode::wrong_preposition, "to");
        }
    }
}

}  // namespace fulcrum::dialogue
