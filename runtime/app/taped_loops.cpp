#include "runtime/app/taped_loops.h"

#include "runtime/app/repeated_faults.h"
#include "runtime/scene/plan_kite.h"

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
    : device_(std::make_unique<TapedDevice>(traits)),
      channels_(std::make_unique<HapticChannels>()) {
    if (!plan.axles.empty()) {
        axles_ = std::make_unique<AxleChannels>();
        channels_->axles = axles_.get();
    }
    if (has_rigid) {
        rigid_ = std::make_unique<RigidChannels>();
        channels_->rigid = rigid_.get();
    }
    if (plan.line) {
        kite_ = std::make_unique<KiteChannels>();
        channels_->kite = kite_.get();
    }
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
    if (axles_) {
        pass(told.axles->orders, heard_[2], axles_->orders);
    }
    if (rigid_) {
        pass(told.rigid->frame, heard_[3], rigid_->frame);
    }
    if (kite_) {
        pass(told.kite->line, heard_[4], kite_->line);
    }
}

TapedLoops::TapedLoops(const Plan& plan, const std::vector<DeviceTraits>& hands) : plan_(plan) {
    for (std::size_t i = 0; i < hands.size(); ++i) {
        hands_.push_back(std::make_unique<TapedHand>(
            i == 0 ? plan_.haptic : plan_.more_hands[i - 1], hands[i], plan_.rigid.has_value()));
    }
    if (plan_.kite) {
        kite_loop_ = std::make_unique<KiteLoop>(plan_.kite->flight,
                                                plan_.kite->rate_hz * plan_.kite->n_parts,
                                                *hands_.front()->channels().kite);
    }
    if (plan_.world || plan_.rigid) {
        world_channels_ = std::make_unique<WorldChannels>();
    }
    if (plan_.world) {
        std::vector<std::int32_t> solid_bodies;
        for (const SolidPlan& solid : plan_.haptic.solids) {
            solid_bodies.push_back(solid.body);
        }
        world_loop_ = std::make_unique<WorldLoop>(*plan_.world, std::move(solid_bodies),
                                                  *world_channels_, hands_.front()->channels());
    }
}

Expected<std::unique_ptr<TapedLoops>> TapedLoops::create(const Plan& plan,
                                                         const std::vector<DeviceTraits>& hands,
                                                         const std::vector<WorldCommand>& first) {
    std::unique_ptr<TapedLoops> loops(new TapedLoops(plan, hands));
    if (plan.rigid) {
        std::vector<RigidChannels*> channels;
        for (const auto& hand : loops->hands_) {
            channels.push_back(hand->channels().rigid);
        }
        auto rigid = RigidLoop::create(*plan.rigid, loops->world_channels_.get(), channels);
        if (!rigid) {
            return tl::unexpected(rigid.error());
        }
        loops->rigid_loop_ = std::move(*rigid);
    }
    if (plan.world) {
        (void)loops->to_world_.send(first, loops->world_channels_->commands);
    }
    return loops;
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
    step_world(now_s);
    ++round_;
}

void TapedLoops::tell(const TapedFrame& frame) {
    for (const auto& hand : hands_) {
        hand->channels().command.publish(frame.command);
    }
    HapticChannels& first = hands_.front()->channels();
    if (first.axles != nullptr) {
        first.axles->orders.publish(frame.axles);
    }
    if (first.kite != nullptr) {
        if (frame.kite_design) {
            first.kite->built.put(
                std::make_unique<KiteFlight>(with_design(plan_.kite->flight, *frame.kite_design)));
        }
        first.kite->orders.publish(frame.kite);
    }
    if (world_channels_) {
        (void)to_world_.send(frame.world, world_channels_->commands);
    }
}

// As the virtual clock has them; what is faster than the hand's rounds several times in one, at the round's end last.
void TapedLoops::step_world(double now_s) noexcept {
    const double rate_hz = plan_.haptic.rate_hz;
    const auto run = [&](PeriodicTask* task, double task_rate_hz) {
        const auto every = static_cast<std::size_t>(std::lround(rate_hz / task_rate_hz));
        if (task == nullptr || (every > 1 && round_ % every != 0)) {
            return;
        }
        const long n = std::max(std::lround(task_rate_hz / rate_hz), 1L);
        for (long i = n - 1; i >= 0; --i) {
            task->step(now_s - static_cast<double>(i) / (static_cast<double>(n) * rate_hz));
        }
    };
    run(world_loop_.get(), plan_.world ? plan_.world->rate_hz : rate_hz);
    run(rigid_loop_.get(), plan_.rigid ? plan_.rigid->rate_hz : rate_hz);
    run(kite_loop_.get(), plan_.kite ? plan_.kite->rate_hz : rate_hz);
}

}  // namespace fulcrum::runtime
