#include "runtime/render/picture_quality.h"

#include <algorithm>
#include <utility>

namespace fulcrum::runtime {

double QualityControl::middle_of_taken() {
    const auto middle = taken_s_.begin() + static_cast<std::ptrdiff_t>(taken_s_.size() / 2);
    std::ranges::nth_element(taken_s_, middle);
    const double middle_s = *middle;
    taken_s_.clear();
    return middle_s;
}

void QualityControl::step(Step step) {
    const int way = step == Step::coarser ? 1 : -1;
    level_ = static_cast<PictureLevel>(static_cast<int>(level_) + way);
    last_step_ = step;
    n_since_step_ = 0;
}

void QualityControl::wait_longer() {
    patience_ = std::min(2 * patience_, settings_.longest_patience);
}

void QualityControl::take(double took_s) {
    taken_s_.push_back(took_s);
    ++n_since_step_;
    rest_ = std::max(0, rest_ - 1);
    if (taken_s_.size() < settings_.looks_at) {
        return;
    }
    const double middle_s = middle_of_taken();
    const bool is_slow = middle_s > settings_.most_s;
    const auto place = static_cast<std::size_t>(level_);
    const Step before = std::exchange(last_step_, Step::none);
    const bool is_coarsest = place + 1 == kPictureLevels.size();
    if (is_slow && rest_ == 0 && !is_coarsest) {
        if (before == Step::finer) {
            wait_longer();
        }
        if (before != Step::coarser) {
            descent_from_ = level_;
            descent_s_ = middle_s;
        }
        step(Step::coarser);
    } else if (is_slow && before == Step::coarser && middle_s > settings_.helps * descent_s_) {
        wait_longer();
        rest_ = patience_;
        level_ = descent_from_;
        n_since_step_ = 0;
    } else if (!is_slow && place > 0 && n_since_step_ >= patience_ &&
               middle_s * settings_.finer_costs[place] < settings_.spare * settings_.most_s) {
        step(Step::finer);
    } else if (!is_slow && before == Step::finer) {
        patience_ = settings_.patience;
    }
}

}  // namespace fulcrum::runtime
