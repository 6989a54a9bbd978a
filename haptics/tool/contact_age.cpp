#include "haptics/tool/contact_age.h"

#include <algorithm>

namespace fulcrum {

void ContactAge::restart() noexcept {
    asked_s_ = -1.0;
    age_s_ = 0.0;
    share_ = 1.0;
}

void ContactAge::step(double began_s, double told_s, double dt_s) noexcept {
    asked_s_ = asked_s_ < 0.0 ? began_s : asked_s_;
    const double since_s = told_s < 0.0 ? asked_s_ : told_s;
    age_s_ = began_s < since_s ? 0.0 : began_s - since_s;
    const double change = dt_s / settings_.fade_s;
    share_ = std::clamp(is_late() ? share_ - change : share_ + change, 0.0, 1.0);
}

}  // namespace fulcrum
