#include "runtime/app/hand_trial.h"

#include "runtime/app/hand_fitting.h"

#include <cstdio>

namespace fulcrum::runtime {

bool needs_trial(const RunHand& hand, const RunRequest& request, bool asked) {
    if (!hand.device->can_push() || request.first_use == FirstUseTrial::never) {
        return false;
    }
    return request.first_use == FirstUseTrial::again ||
           !is_tried(hand.fit, asked, hand.device->device().traits().name);
}

std::vector<std::string> withhold_refused(const RunHands& hands, const RunRequest& request) {
    std::vector<std::string> sentences;
    for (const auto& hand : hands) {
        HandDevice& device = *hand->device;
        if (!device.can_push() || request.first_use != FirstUseTrial::never ||
            !is_refused(hand->fit, device.device().traits().name)) {
            continue;
        }
        device.give_no_force();
        sentences.push_back(
            "the " + std::string(hand == hands.front() ? "" : "second ") + device.tried().name() +
            " gives no force in this lesson: its last trial was not good; start the lesson without "
            "--first-use never, and it is tried again.");
    }
    return sentences;
}

void take_trial(RunHand& hand, const std::string& whose, const FirstUse& trial, bool asked,
                const RunRequest& request, ProgressStore& store) {
    HandDevice& device = *hand.device;
    device.begin_anew();
    const bool is_good = trial.end() == FirstUseEnd::good;
    if (!is_good) {
        const std::string sentence = tell(trial, hand.fit.axes.value_or(AxisOrder{}));
        std::fprintf(stderr, "%s%s\n", whose.c_str(), sentence.c_str());
        device.give_no_force();
    } else {
        device.give_all_force();
    }
    RunRequest tried = request;
    static_cast<HandChoice&>(tried) = hand.choice;
    const std::string& name = device.device().traits().name;
    tried.fit = {.checked = is_good ? verdict_of(asked, name) : bad_verdict_of(name)};
    keep_fit_of(tried, store);
}

}  // namespace fulcrum::runtime
