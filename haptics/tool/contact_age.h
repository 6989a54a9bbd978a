// How long a tool goes on with what it was last told of contact by work beside it (beside_task.h), and what is felt then.
//
//   age <= hold       all that the last answer gives:                              share -> 1 by dt / fade a step
//   age >  hold       evenly less, until nothing is felt:                          share -> 0 by dt / fade a step
//   share = 0         the tool has lost its contacts; it is placed anew, without a force, where nothing is touched
// So no force is felt of an answer older than hold + fade, and the force changes by its largest times dt / fade a step for it at most, whether
// the answers stop or come again.
//
// Thread: haptic loop. Cost: nanoseconds.
#pragma once

#include "haptics/base/error.h"

namespace fulcrum {

/// Fixed at load.
struct ContactAgeSettings {
    double hold_s = 0.1;  ///< 1e-3 to 10
    double fade_s = 0.1;  ///< 1e-3 to 10
};

/// Refuses settings outside their ranges, NaN included.
[[nodiscard]] Expected<void> validate(const ContactAgeSettings& settings);

class ContactAge {
  public:
    /// Takes settings that `validate` accepted.
    explicit ContactAge(const ContactAgeSettings& settings) noexcept : settings_(settings) {}

    /// Nothing has been asked yet: the first answer is as old as its question.
    void restart() noexcept;
    /// A step of `dt_s` began; the newest answer is about `told_s`, below 0 where there is none.
    void step(double began_s, double told_s, double dt_s) noexcept;

    /// Of the step's answer, or since the first question without any. Seconds.
    [[nodiscard]] double age_s() const noexcept { return age_s_; }
    /// Older than `hold_s`; an age that is no number is, too.
    [[nodiscard]] bool is_late() const noexcept { return !(age_s_ <= settings_.hold_s); }
    /// Of the force that is felt, 0 to 1.
    [[nodiscard]] double share() const noexcept { return share_; }
    [[nodiscard]] bool is_lost() const noexcept { return share_ == 0.0; }

  private:
    ContactAgeSettings settings_;
    double asked_s_ = -1.0;
    double age_s_ = 0.0;
    double share_ = 1.0;
};

}  // namespace fulcrum
