#include "runtime/app/run_hand.h"

#include <algorithm>

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

void RunHand::measure(const std::string& name, std::vector<PlanStage>& stages) const {
    for (const StageInfo& built : loop->stages()) {
        for (PlanStage& planned : stages) {
            if (planned.loop == name && planned.name == name_of(built.stage)) {
                planned.memory_bytes = built.bytes;
            }
        }
    }
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

std::optional<HandWish> RunHand::take_wish() {
    std::optional<HandWish> taken = wish;
    if (wish) {
        wish->key.clear();
    }
    return taken;
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

std::optional<std::size_t> find_hand(const RunHands& hands, HandKind kind) {
    const auto find = [&](auto&& is_it) -> std::optional<std::size_t> {
        const auto found =
            std::ranges::find_if(hands, [&](const auto& hand) { return is_it(*hand->device); });
        return found == hands.end()
                   ? std::nullopt
                   : std::optional(static_cast<std::size_t>(found - hands.begin()));
    };
    const auto of_kind = find([&](const HandDevice& device) { return device.kind() == kind; });
    return of_kind || kind != HandKind::mouse
               ? of_kind
               : find([](const HandDevice& device) { return device.stands_in(); });
}

bool renders_force(const RunHands& hands) {
    return std::ranges::any_of(hands,
                               [](const auto& hand) { return hand->device->renders_force(); });
}

bool device_is_lost(const RunHands& hands) {
    return std::ranges::any_of(hands, [](const auto& hand) { return hand->is_lost(); });
}

bool holds_back(const RunHands& hands, const Plan& plan) {
    for (std::size_t hand = 0; hand < hands.size(); ++hand) {
        if (hands[hand]->holds_back(plan.of_hand(hand).safety)) {
            return true;
        }
    }
    return false;
}

std::string take_device_notice(const RunHands& hands) {
    std::string notice;
    for (const auto& hand : hands) {
        if (const std::string more = hand->device->take_notice(); !more.empty()) {
            notice += (notice.empty() ? "" : " ");
            notice += (hand == hands.front() ? "" : "The second hand: ") + more;
        }
    }
    return notice;
}

void look(const RunHands& hands, SessionInput& gathered) {
    for (const auto& hand : hands) {
        hand->channels.state_for_lesson.take();
        if (hand == hands.front()) {
            gathered.hand = hand->seen();
        } else {
            gathered.more_hands.push_back(hand->seen());
        }
    }
}

void lead(const RunHands& hands, const SessionOutput& output, const std::optional<Vector3>& sees) {
    if (output.has_hand_target) {
        hands.front()->device->see(sees);
        hands.front()->aim({output.hand_target_W, output.hand_buttons, output.hand_key});
    }
    const std::size_t n = std::min(output.more_aims.size(), hands.size() - 1);
    for (std::size_t i = 0; i < n; ++i) {
        if (const HandAim& aim = output.more_aims[i]; aim.is_given) {
            hands[i + 1]->aim({aim.target_W, aim.buttons, {}});
        }
    }
}

void show(const RunHands& hands, Scenery& scenery) {
    const HandScenery first = hands.front()->scenery();
    scenery.hand = first.hand;
    scenery.renders_force = hands.front()->device->renders_force();
    scenery.ghost = first.ghost;
    scenery.ghost_pose_W = first.ghost_pose_W;
    for (std::size_t i = 1; i < hands.size(); ++i) {
        scenery.more_hands.push_back(hands[i]->scenery());
    }
}

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
