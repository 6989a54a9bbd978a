// The part of LessonRun that fits scene and arm to each other, and knows whether its forces were tried. See lesson_run.h.
#include "runtime/app/hand_fitting.h"
#include "runtime/app/lesson_run.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace fulcrum::runtime {
namespace {

std::string size_of(const Vector3& reach_m) {
    constexpr double kWholeInCm = 200.0;
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.0f by %.0f by %.0f cm", kWholeInCm * reach_m.x(),
                  kWholeInCm * reach_m.y(), kWholeInCm * reach_m.z());
    return text.data();
}

}  // namespace

bool LessonRun::needs_trial(std::size_t hand, const RunRequest& request, bool asked) const {
    const HandDevice& tried = hand_at(hand);
    if (!tried.can_push() || request.first_use == FirstUseTrial::never) {
        return false;
    }
    return request.first_use == FirstUseTrial::again ||
           !is_tried(fit_of(hand), asked, tried.device().traits().name);
}

// What this learner's last trial found not good gives nothing until a new one is good, also where none is to be.
void LessonRun::withhold_refused(std::size_t hand, const RunRequest& request, const HandFit& fit) {
    HandDevice& device = hand_at(hand);
    if (!device.can_push() || request.first_use != FirstUseTrial::never ||
        !is_refused(fit, device.device().traits().name)) {
        return;
    }
    const std::string name = std::string(hand == 0 ? "" : "second ") + device.tried().name();
    device.give_no_force();
    hand_notices_.push_back("the " + name +
                            " gives no force in this lesson: its last trial was not good; start "
                            "the lesson without --first-use never, and it is tried again.");
}

RunRequest LessonRun::request_of(std::size_t hand, const RunRequest& request) const {
    RunRequest own = request;
    if (hand > 0) {
        static_cast<HandChoice&>(own) = more_hands_[hand - 1]->choice;
    }
    return own;
}

void LessonRun::take_trial(std::size_t hand, const FirstUse& trial, bool asked,
                           const RunRequest& request, ProgressStore& store) {
    HandDevice& device = hand_at(hand);
    device.begin_anew();
    const bool is_good = trial.end() == FirstUseEnd::good;
    if (!is_good) {
        const std::string sentence = tell(trial, fit_of(hand).axes.value_or(AxisOrder{}));
        std::fprintf(stderr, "%s%s\n", hand == 0 ? "" : "The second hand: ", sentence.c_str());
        device.give_no_force();
    } else {
        device.give_all_force();
    }
    RunRequest tried = request_of(hand, request);
    const std::string& name = device.device().traits().name;
    tried.fit = {.checked = is_good ? verdict_of(asked, name) : bad_verdict_of(name)};
    keep_fit_of(tried, store);
}

double LessonRun::force_limit_N(const RunRequest& request) const {
    double least_N = HandDevice::force_limit_N(request);
    // An arm at the other end of a link tells it when it is open.
    for (std::size_t hand = 0; hand_ && hand < n_hands(); ++hand) {
        if (hand_at(hand).kind() == HandKind::link) {
            least_N = std::min(least_N, hand_at(hand).device().traits().max_force_N);
        }
    }
    for (const HandChoice& choice : request.more_hands) {
        RunRequest own = request;
        static_cast<HandChoice&>(own) = choice;
        least_N = std::min(least_N, HandDevice::force_limit_N(own));
    }
    return least_N;
}

// For which walls are made stable: open devices, and those that were where they are repeated, open yet or not.
WallHolders LessonRun::find_holders(const WallHolders& repeated) const {
    const bool repeats_all = hand_->kind() == HandKind::replay;
    WallHolders holders = repeats_all ? repeated : WallHolders{};
    for (std::size_t hand = 0; hand < n_hands(); ++hand) {
        if (hand_at(hand).kind() != HandKind::replay) {
            holders.resize(std::max(holders.size(), hand + 1));
            holders[hand] = hand_at(hand).wall_holder().value_or(WallHolder{});
        }
    }
    return holders;
}

// Weights that were fitted to more than the newest device can give are fitted again, so that what is heavier is felt heavier; and walls, to what
// that holds, and to the way to an arm on a link.
Expected<void> LessonRun::fit_to_force(const Places& places, const RunRequest& request) {
    const bool has_holder = hand_at(n_hands() - 1).wall_holder().has_value();
    if (force_limit_N(request) >= plan_.haptic.safety.max_force_N && !has_holder) {
        return {};
    }
    auto plan = compile(places, request, scene_);
    if (!plan) {
        return tl::unexpected(plan.error());
    }
    plan_ = std::move(*plan);
    return {};
}

// The lesson as it is when this hand goes `factor` times as far; its plan must suit the hand's device where that is open.
Expected<Plan> LessonRun::compile_scaled(const Places& places, const RunRequest& request,
                                         std::size_t hand, double factor,
                                         LessonDescription& scene) const {
    (hand == 0 ? scene.hand : scene.more_hands[hand - 1]).scale *= factor;
    return compile(places, request, scene).and_then([&](Plan&& compiled) {
        const HapticPlan& plan = hand == 0 ? compiled.haptic : compiled.more_hands[hand - 1];
        const bool is_open = hand <= more_hands_.size();
        return (is_open ? validate(plan, hand_at(hand).device().traits()) : validate(plan))
            .map([&] { return std::move(compiled); });
    });
}

// Of a hand beside the first; that one's scale is in the scene from the beginning.
Expected<void> LessonRun::scale_as_said(const Places& places, const RunRequest& request,
                                        std::size_t hand, const HandFit& fit) {
    if (fit.scale.value_or(1.0) == 1.0) {
        return {};
    }
    LessonDescription scene = scene_;
    return compile_scaled(places, request, hand, *fit.scale, scene).map([&](Plan&& plan) {
        plan_ = std::move(plan);
        scene_ = std::move(scene);
    });
}

// Where the scene cannot be felt at that scale, the lesson's own stays: a part of it is then out of reach, but for the clutch.
void LessonRun::fit_to_reach(const Places& places, const RunRequest& request, std::size_t hand,
                             double factor) {
    const std::string reached = std::string(hand == 0 ? "The arm" : "The second arm") +
                                " reaches " + size_of(hand_at(hand).device().traits().reach_m);
    LessonDescription scene = scene_;
    auto plan = compile_scaled(places, request, hand, factor, scene);
    if (!plan) {
        hand_notices_.push_back(
            reached + ", and a part of the scene lies outside that: " + to_sentence(plan.error()));
        return;
    }
    std::array<char, 32> times{};
    std::snprintf(times.data(), times.size(), "%.1f", factor);
    plan_ = std::move(*plan);
    scene_ = std::move(scene);
    hand_notices_.push_back(
        reached + ", so it moves " + times.data() +
        " times as far in the scene as the lesson says; --scale says otherwise.");
}

Expected<Plan> LessonRun::compile_changed(
    const Places& places, const RunRequest& request,
    const std::function<void(LessonDescription&)>& change) const {
    LessonDescription scene = scene_;
    change(scene);
    return compile(places, request, scene);
}

}  // namespace fulcrum::runtime
