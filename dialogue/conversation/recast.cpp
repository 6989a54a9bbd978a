#include "dialogue/conversation/recast.h"

namespace fulcrum::dialogue {

bool says_yes_or_no(const Mark& mark) {
    const std::string first = mark.corrected.substr(0, mark.corrected.find_first_of(" ,."));
    return first == "Yes" || first == "Yeah" || first == "Sure" ||
           mark.corrected.starts_with("No,");
}

bool asks_back(std::string_view sentence) {
    return sentence.ends_with('?');
}

const char* recast_key(const Mark& mark) {
    if (asks_back(mark.corrected)) {
        return "feedback.recast_question";
    }
    return says_yes_or_no(mark) ? "feedback.recast_said" : "feedback.recast";
}

}  // namespace fulcrum::dialogue
