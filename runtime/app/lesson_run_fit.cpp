// The part of LessonRun that fits scene and arm to each other, and knows whether the arm was tried. See lesson_run.h.
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

// What is kept of a good trial: with another arm at the same address it is none.
std::string verdict_of(bool asked, const std::string& arm) {
    return (asked ? "good " : "moves ") + arm;
}

}  // namespace

bool LessonRun::needs_trial(const RunRequest& request, bool asked) const {
    if (!hand_->is_arm() || !device().traits().renders_force ||
        request.first_use == FirstUseTrial::never) {
        return false;
    }
    const std::string& arm = device().traits().name;
    const bool is_known =
        fit_.checked == verdict_of(true, arm) || (!asked && fit_.checked == verdict_of(false, arm));
    return request.first_use == FirstUseTrial::again || !is_known;
}

void LessonRun::take_trial(const FirstUse& trial, bool asked, const RunRequest& request,
                           ProgressStore& store) {
    hand_->begin_anew();
    const std::string sentence = tell(trial, fit_.axes.value_or(AxisOrder{}));
    const bool is_good = trial.end() == FirstUseEnd::good;
    if (!is_good) {
        std::fprintf(stderr, "%s\n", sentence.c_str());
    }
    if (!is_good) {
        hand_->give_no_force();
    }
    RunRequest tried = request;
    constexpr const char* kNotGood = "not good";
    tried.fit = {.checked = is_good ? verdict_of(asked, device().traits().name) : kNotGood};
    keep_fit_of(tried, store);
}

double LessonRun::force_limit_N(const RunRequest& request) const {
    double least_N = HandDevice::force_limit_N(request);
    // An arm at the other end of a link tells it when it is open.
    if (hand_ && request.hand == HandKind::link) {
        least_N = std::min(least_N, device().traits().max_force_N);
    }
    for (const HandChoice& choice : request.more_hands) {
        RunRequest own = request;
        static_cast<HandChoice&>(own) = choice;
        least_N = std::min(least_N, HandDevice::force_limit_N(own));
    }
    return least_N;
}

// Weights that were fitted to more than the arm can give are fitted again, so that what is heavier is felt heavier.
Expected<void> LessonRun::fit_to_force(const Places& places, const RunRequest& request) {
    if (force_limit_N(request) >= plan_.haptic.safety.max_force_N) {
        return {};
    }
    auto plan = compile(places, request, scene_);
    if (!plan) {
        return tl::unexpected(plan.error());
    }
    plan_ = std::move(*plan);
    return {};
}

// Where the scene cannot be felt at that scale, the lesson's own stays: a part of it is then out of reach, but for the clutch.
void LessonRun::fit_to_reach(const Places& places, const RunRequest& request, double factor) {
    LessonDescription scene = scene_;
    scene.hand.scale *= factor;
    const std::string reached = "The arm reaches " + size_of(device().traits().reach_m);
    auto plan = compile(places, request, scene).and_then([&](Plan&& compiled) {
        return validate(compiled.haptic, device().traits()).map([&] {
            return std::move(compiled);
        });
    });
    if (!plan) {
        plan_.notices.push_back(
            reached + ", and a part of the scene lies outside that: " + to_sentence(plan.error()));
        return;
    }
    std::array<char, 32> times{};
    std::snprintf(times.data(), times.size(), "%.1f", factor);
    plan_ = std::move(*plan);
    scene_ = std::move(scene);
    plan_.notices.push_back(
        reached + ", so it moves " + times.data() +
        " times as far in the scene as the lesson says; --scale says otherwise.");
}

}  // namespace fulcrum::runtime
