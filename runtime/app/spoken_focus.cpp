#include "runtime/app/spoken_focus.h"

namespace fulcrum::runtime {

std::optional<std::string> SpokenFocus::look(const std::string& words, double now_s) {
    if (words != words_) {
        words_ = words;
        since_s_ = now_s;
        is_said_ = words.empty();
    }
    if (is_said_ || now_s - since_s_ < kRest_s) {
        return std::nullopt;
    }
    is_said_ = true;
    return words_;
}

}  // namespace fulcrum::runtime
