#include "runtime/app/taped_loops.h"

#include "runtime/app/repeated_faults.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fulcrum::runtime {
namespace {

template <class T>
void pass(const LatestValue<T>& from, std::uint64_t& n_heard, LatestValue<T>& to) noexcept {
    if (from.n_taken() != n_heard) {
        n_heard = from.n_taken();
        to.publish(from.value());
    }
}

}  // namespace

void TapedDevice::put(const DeviceReading& reading, bool is_read) noexcept {
    reading_ = reading;
    is_read_ = is_read;
}

bool TapedDevice::read(double /*now_s*/, DeviceReading& reading) noexcept {
    reading = reading_;
    return is_read_;
}

bool TapedDevice::write(double /*now_s*/, const Wrench& /*wrench_D*/) noexcept {
    return true;
}

TapedHand::TapedHand(const HapticPlan& plan, const DeviceTraits& traits, bool has_rigid)
    : device_(std::make_unique<TapedDevice>(traits)), channels_(std::make_unique<HandChannels>()) {
    channels_->add(plan, has_rigid);
    loop_ = std::make_unique<HapticLoop>(plan, *device_, *channels_);
}

void TapedHand::step(const TapedRound& round, const DeviceReading& reading, double now_s) noexcept {
    repeat_faults(round.faults, round.gate, was_stopped_, *channels_);
    device_->put(reading, !any(round.faults & Fault::device_read));
    loop_->step(now_s);
    if (BesideTask* const beside = loop_->beside()) {
        (void)beside->run_once();
    }
}

void TapedHand::hear(const TapedHand& other) noexcept {
    const HapticChannels& told = other.channels();
    pass(told.command, heard_[0], channels_->command);
    pass(told.world, heard_[1], channels_->world);
    if (told.axles != nullptr) {
        pass(told.axles->orders, heard_[2], channels_->axles->orders);
    }
    if (told.rigid != nullptr) {
        pass(told.rigid->frame, heard_[3], channels_->rigid->frame);
    }
    if (told.kite != nullptr) {
        pass(told.kite->line, heard_[4], channels_->kite->line);
    }
}

TapedLoops::TapedLoops(const Plan& plan, const std::vector<DeviceTraits>& hands) : plan_(plan) {
    plan_.touch_sound = false;  // nobody listens
    for (std::size_t i = 0; i < hands.size(); ++i) {
        hands_.push_back(
            std::make_unique<TapedHand>(plan_.of_hand(i), hands[i], plan_.rigid.has_value()));
    }
}

Expected<std::unique_ptr<TapedLoops>> TapedLoops::create(const Plan& plan,
                                                         const std::vector<DeviceTraits>& hands,
                                                         const std::vector<WorldCommand>& first) {
    std::unique_ptr<TapedLoops> loops(new TapedLoops(plan, hands));
    std::vector<HapticChannels*> channels;
    for (const auto& hand : loops->hands_) {
        channels.push_back(&hand->channels());
    }
    return loops->effects_.build({loops->plan_, channels, first}).map([&] {
        return std::move(loops);
    });
}

void TapedLoops::step(const RunTape& tape) noexcept {
    for (; frame_ < tape.frames().size() && tape.frames()[frame_].round <= round_; ++frame_) {
        tell(tape.frames()[frame_]);
    }
    const double now_s = static_cast<double>(round_) / plan_.haptic.rate_hz;
    for (std::size_t i = 0; i < hands_.size(); ++i) {
        const TapedRound& round = tape.round(round_, i);
        hands_[i]->step(round, round.reading, now_s);
    }
    step_effects(now_s);
    ++round_;
}

void TapedLoops::tell(const TapedFrame& frame) {
    for (const auto& hand : hands_) {
        hand->channels().command.publish(frame.command);
    }
    (void)effects_.order(frame.orders);
}

// As the virtual clock has them; what is faster than the hand's rounds several times in one, at the round's end last.
void TapedLoops::step_effects(double now_s) noexcept {
    const double rate_hz = plan_.haptic.rate_hz;
    for (const EffectLoop& loop : effects_.loops()) {
        const auto every = static_cast<std::size_t>(std::lround(rate_hz / loop.rate_hz));
        if (every > 1 && round_ % every != 0) {
            continue;
        }
        const long n = std::max(std::lround(loop.rate_hz / rate_hz), 1L);
        for (long i = n - 1; i >= 0; --i) {
            loop.task->step(now_s - static_cast<double>(i) / (static_cast<double>(n) * rate_hz));
        }
    }
}

}  // namespace fulcrum::runtime
