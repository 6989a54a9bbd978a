#include "runtime/app/force_trial.h"

#include "haptics/base/clock.h"
#include "runtime/app/hand_trial.h"
#include "runtime/app/interrupt.h"
#include "runtime/app/stop_signal.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>

namespace fulcrum::runtime {
namespace {

constexpr double kFrame_s = 1.0 / 60.0;

void rest_s(double seconds) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

}  // namespace

Expected<std::unique_ptr<ForceTrial>> ForceTrial::begin(Device& device,
                                                        const SafetySettings& limits, bool asks,
                                                        const TriedDevice& tried) {
    HapticPlan plan;
    plan.lesson_force = true;
    plan.safety = limits;
    plan.safety.max_force_N = std::min(limits.max_force_N, kMostPush_N);
    if (auto good = validate(plan, device.traits()); !good) {
        return tl::unexpected(good.error());
    }
    std::unique_ptr<ForceTrial> made(new ForceTrial(asks, tried));
    made->fade_s_ = plan.safety.fade_s;
    made->loop_ = std::make_unique<HapticLoop>(plan, device, made->channels_);
    made->epoch_s_ = monotonic_now_s();
    RealtimeSettings pace;
    pace.rate_Hz = plan.rate_hz;
    pace.epoch_s = made->epoch_s_;
    if (auto started = made->thread_.start(*made->loop_, pace); !started) {
        return tl::unexpected(started.error());
    }
    set_stop_target(&made->channels_.emergency_stop);
    return made;
}

ForceTrial::~ForceTrial() {
    constexpr double kMargin_s = 0.05;
    if (thread_.status().running) {
        channels_.ended.store(true, std::memory_order_release);
        rest_s(fade_s_ + kMargin_s);
    }
    thread_.stop();
    set_stop_target(nullptr);
}

void ForceTrial::frame(bool rests) {
    const double now_s = monotonic_now_s() - epoch_s_;
    channels_.state_for_lesson.take();
    ForceCommand command;
    command.stamp_s = command.linearised.stamp_s = now_s;
    command.lesson_alive = true;
    if (!rests) {
        command.linearised.force_W =
            trial_.step(channels_.state_for_lesson.value(), now_s - rested_s_);
    } else {
        rested_s_ += now_s - framed_s_;
    }
    framed_s_ = now_s;
    channels_.command.publish(command);
}

Expected<void> try_forces(LessonRun& run, const RunRequest& request, ProgressStore& store) {
    constexpr bool kAsked = false;
    for (std::size_t hand = 0; hand < run.hands().size() && !interrupted(); ++hand) {
        if (!needs_trial(run.hand_at(hand), request, kAsked)) {
            continue;
        }
        HandDevice& device = *run.hand_at(hand).device;
        const TriedDevice tried = device.tried();
        std::printf("The %s%s pushes gently for a moment, to be tried.\n",
                    hand == 0 ? "" : "second ", tried.name());
        (void)std::fflush(stdout);
        auto begun =
            ForceTrial::begin(device.device(), run.plan().of_hand(hand).safety, kAsked, tried);
        if (!begun) {
            return tl::unexpected(begun.error());
        }
        while ((*begun)->trial().end() == FirstUseEnd::running && !interrupted()) {
            (*begun)->frame(false);
            rest_s(kFrame_s);
        }
        const FirstUse trial = (*begun)->trial();
        begun->reset();
        // Who broke it off has not tried it to the end: nothing is known.
        if (trial.end() == FirstUseEnd::running) {
            run.hand_at(hand).device->begin_anew();
            run.hand_at(hand).device->give_no_force();
            return {};
        }
        take_trial(run.hand_at(hand), hand == 0 ? "" : "The second hand: ", trial, kAsked, request,
                   store);
    }
    return {};
}

}  // namespace fulcrum::runtime
