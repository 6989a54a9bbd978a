#include "runtime/app/run_hand.h"

namespace fulcrum::runtime {

// What the last gate lets through is the least of device, place and lesson.
void RunHand::build_loop(const Plan& plan, const HapticPlan& own, bool is_told) {
    if (is_told) {
        told = std::make_unique<HandChannels>();
        told->add(own, plan.rigid.has_value());
        told->touches = channels.touches;
    }
    loop = std::make_unique<HapticLoop>(own, device->device(), loop_channels());
    SafetySettings limits = own.safety;
    limits.max_force_N = loop->max_force_N();
    limits.max_torque_Nm = loop->max_torque_Nm();
    device->keep_limits(limits);
}

HapticState RunHand::seen() const {
    HapticState shown = state();
    const bool is_shut = shown.gate == GatePhase::fading || shown.gate == GatePhase::stopped;
    if (!device->renders_force() && !is_shut && !any(shown.faults)) {
        shown.applied_W = shown.commanded_W;
    }
    return shown;
}

HandScenery RunHand::scenery() const {
    const HapticState shown = seen();
    const bool points = !device->renders_force() && device->points();
    return {shown, points, points ? device->pointer_W() : shown.tool_pose_W};
}

FeltTime RunHand::felt_time() const {
    FeltTime time = loop->felt_time();
    if (!device->renders_force()) {
        time.waiting_s = 0.0;
        time.felt_s = time.asked_s - time.taken_s;
    }
    return time;
}

bool RunHand::is_lost() const {
    return any(state().faults & (Fault::device_read | Fault::device_stale | Fault::device_write));
}

bool RunHand::holds_back(const SafetySettings& limits) const {
    const double least_Nm = limits.engage_below_N * limits.max_torque_Nm / limits.max_force_N;
    const bool asks = state().commanded_W.force.norm() >= limits.engage_below_N ||
                      (device->device().traits().max_torque_Nm > 0.0 && least_Nm > 0.0 &&
                       state().commanded_W.torque.norm() >= least_Nm);
    return device->renders_force() && state().gate == GatePhase::waiting && !any(state().faults) &&
           asks;
}

void RunHand::aim(const HandWish& wanted) {
    device->follow(wanted.target_W, wanted.buttons);
    wish = wanted;
}

namespace {

template <class Take>
auto of_each(const RunHands& hands, const Take& take) {
    std::vector<decltype(take(*hands.front()))> taken;
    for (const auto& hand : hands) {
        taken.push_back(take(*hand));
    }
    return taken;
}

}  // namespace

std::vector<HapticChannels*> channels_of(const RunHands& hands) {
    return of_each(hands, [](RunHand& hand) -> HapticChannels* { return &hand.channels; });
}

std::vector<const HapticLoop*> loops_of(const RunHands& hands) {
    return of_each(hands, [](const RunHand& hand) -> const HapticLoop* { return hand.loop.get(); });
}

std::vector<DeviceTraits> traits_of(const RunHands& hands) {
    return of_each(
        hands, [](const RunHand& hand) { return DeviceTraits(hand.device->device().traits()); });
}

std::vector<FeltTime> felt_times_of(const RunHands& hands) {
    return of_each(hands, [](const RunHand& hand) { return hand.felt_time(); });
}

}  // namespace fulcrum::runtime
