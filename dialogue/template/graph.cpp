#include "dialogue/template/graph.h"

namespace fulcrum::dialogue {

int StringTable::intern(std::string_view text) {
    if (const auto found = numbers_.find(text); found != numbers_.end()) {
        return found->second;
    }
    const int number = size();
    texts_.emplace_back(text);
    numbers_.emplace(text, number);
    return number;
}

int StringTable::find(std::string_view text) const {
    const auto found = numbers_.find(text);
    return found == numbers_.end() ? kNone : found->second;
}

}  // namespace fulcrum::dialogue
