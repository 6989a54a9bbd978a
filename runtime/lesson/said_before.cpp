#include "runtime/lesson/said_before.h"

#include <algorithm>

namespace fulcrum::runtime {

void SaidBefore::add(std::string_view text) {
    if (text.empty()) {
        return;
    }
    looked_at_s_ = -kForgets_s;
    if (!kept_.empty() && kept_.back() == text) {
        return;
    }
    kept_.emplace_back(text);
    if (kept_.size() > kMostKept) {
        kept_.pop_front();
    }
}

std::vector<std::string> SaidBefore::look_back(const std::vector<std::string>& standing,
                                               double now_s) {
    const bool begins = !looks(now_s);
    looked_at_s_ = now_s;
    if (begins) {
        at_ = kept_.size();
        standing_ = !standing.empty();
        if (standing_) {
            return standing;
        }
    }
    standing_ = false;
    // What stands there has been heard already.
    const auto stands = [&](std::size_t i) {
        return std::ranges::find(standing, kept_[i]) != standing.end();
    };
    std::size_t further = at_;
    while (further > 0 && stands(further - 1)) {
        --further;
    }
    if (further > 0) {
        at_ = further - 1;
    }
    return at_ < kept_.size() ? std::vector{kept_[at_]} : standing;
}

std::string SaidBefore::shown(double now_s) const {
    if (!looks(now_s) || standing_ || at_ >= kept_.size()) {
        return {};
    }
    std::string text = kept_[at_];
    std::ranges::replace(text, '\n', ' ');
    return text;
}

}  // namespace fulcrum::runtime
