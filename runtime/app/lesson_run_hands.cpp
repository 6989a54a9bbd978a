// What a lesson's run has to do with hands beside the first; for lesson_run.cpp.
#include "haptics/device/replay/recorded_traits.h"
#include "runtime/app/hand_fitting.h"
#include "runtime/app/lesson_run.h"
#include "runtime/lesson/scenery.h"
#include "runtime/scene/plan_hands.h"

#include <charconv>
#include <optional>
#include <system_error>
#include <utility>

namespace fulcrum::runtime {
namespace {

// What the record that the first hand repeats has of this one; null where it has nothing, or another file is repeated.
std::shared_ptr<const Record> find_replayed(const RunRequest& request, std::size_t hand) {
    const HandChoice& choice = request.more_hands[hand - 1];
    const bool is_of_it = request.replayed && choice.hand == HandKind::replay &&
                          choice.hand_file == request.hand_file;
    auto alone = is_of_it ? find_hand(*request.replayed, hand) : std::nullopt;
    return alone ? std::make_shared<const Record>(std::move(*alone)) : nullptr;
}

// How far it went in the scene then, times the lesson's own scale.
std::optional<double> find_replayed_scale(const RunRequest& request, std::size_t hand) {
    const auto told = find_fact(request.replayed->header, fact_prefix(hand) + kScaleFact);
    double scale = 1.0;
    const bool is_number =
        told && std::from_chars(told->data(), told->data() + told->size(), scale).ec == std::errc{};
    return is_number ? std::optional(scale) : std::nullopt;
}

// What is asked of that hand; of one that the record is `alone` for, with what that has of it.
Expected<RunRequest> whole_request(const RunRequest& request, std::size_t hand,
                                   const std::shared_ptr<const Record>& alone) {
    RunRequest own = of_hand(request, hand);
    if (!alone) {
        return with_record(std::move(own));
    }
    own.replayed = alone;
    own.fit.scale = own.fit.scale ? own.fit.scale : find_replayed_scale(request, hand);
    return own;
}

// What the last gate lets through: the least of device, place and lesson.
SafetySettings felt_limits_of(const HapticLoop& loop, const HapticPlan& plan) {
    SafetySettings limits = plan.safety;
    limits.max_force_N = loop.max_force_N();
    limits.max_torque_Nm = loop.max_torque_Nm();
    return limits;
}

}  // namespace

// As many as are planned; the request has been settled. Each device stands before the learner as it is kept for it, and goes as far in the
// scene as was said or as it reaches.
Expected<void> LessonRun::open_more_hands(const Places& places, const RunRequest& request,
                                          ProgressStore& store) {
    for (std::size_t hand = 1; hand <= plan_.more_hands.size(); ++hand) {
        const std::shared_ptr<const Record> alone = find_replayed(request, hand);
        const auto whole = whole_request(request, hand, alone);
        if (!whole) {
            return tl::unexpected(whole.error());
        }
        const RunRequest fitted = with_kept_fit(*whole, store);
        if (auto scaled = scale_as_said(places, request, hand, fitted.fit); !scaled) {
            return scaled;
        }
        auto device = HandDevice::open(fitted, plan_.more_hands[hand - 1]);
        if (!device) {
            return tl::unexpected(device.error());
        }
        auto made = std::make_unique<MoreHand>();
        made->device = std::move(*device);
        made->replayed = alone;
        made->choice = request.more_hands[hand - 1];
        made->fit = fitted.fit;
        if (plan_.rigid) {
            made->channels.rigid = &made->rigid;
        }
        more_hands_.push_back(std::move(made));
        if (hand_at(hand).wall_holder()) {
            if (auto refitted = fit_to_force(places, request); !refitted) {
                return refitted;
            }
        }
        const DeviceTraits& traits = hand_at(hand).device().traits();
        if (const double factor = choose_scale(fitted.fit, traits); factor != 1.0) {
            fit_to_reach(places, request, hand, factor);
        }
        if (auto fits = validate(plan_.more_hands[hand - 1], traits); !fits) {
            return fits;
        }
    }
    withhold_refused(0, request, request.fit);
    for (std::size_t hand = 1; hand < n_hands(); ++hand) {
        withhold_refused(hand, request, fit_of(hand));
    }
    plan_.notices.insert(plan_.notices.end(), hand_notices_.begin(), hand_notices_.end());
    return {};
}

void LessonRun::build_hands(const RunRequest& request) {
    build_told(request);
    haptic_loop_ = std::make_unique<HapticLoop>(plan_.haptic, hand_->device(), loop_channels(0));
    hand_->keep_limits(felt_limits_of(*haptic_loop_, plan_.haptic));
    build_more_loops();
    build_replayed_stops(request);
    build_told_replay(request);
}

void LessonRun::build_more_loops() {
    if (more_hands_.empty()) {
        return;
    }
    std::vector<HandInRound> hands{{haptic_loop_.get(), &loop_channels(0)}};
    for (std::size_t i = 0; i < more_hands_.size(); ++i) {
        MoreHand& hand = *more_hands_[i];
        hand.loop = std::make_unique<HapticLoop>(plan_.more_hands[i], hand.device->device(),
                                                 loop_channels(i + 1));
        hand.device->keep_limits(felt_limits_of(*hand.loop, plan_.more_hands[i]));
        hands.push_back({hand.loop.get(), &loop_channels(i + 1)});
    }
    hands_loop_ = std::make_unique<HandsLoop>(hands);
}

void LessonRun::build_replayed_stops(const RunRequest& request) {
    std::vector<ReplayedStops::Hand> hands;
    if (!told_.empty()) {
        return;
    }
    if (request.replayed) {
        hands.push_back({request.replayed, &channels_});
    }
    for (const auto& hand : more_hands_) {
        if (hand->replayed) {
            hands.push_back({hand->replayed, &hand->channels});
        }
    }
    if (!hands.empty()) {
        stops_ = std::make_unique<ReplayedStops>(std::move(hands), hands_loop());
    }
}

PeriodicTask& LessonRun::hands_loop() {
    return told_replay_  ? static_cast<PeriodicTask&>(*told_replay_)
           : stops_      ? static_cast<PeriodicTask&>(*stops_)
           : hands_loop_ ? static_cast<PeriodicTask&>(*hands_loop_)
                         : *haptic_loop_;
}

void LessonRun::step_hands(double now_s, StageListener& listener) {
    if (told_replay_) {
        return told_replay_->step_observed(now_s, listener);
    }
    if (stops_) {
        stops_->repeat(now_s);
    }
    if (hands_loop_) {
        hands_loop_->step_observed(now_s, listener);
    } else {
        haptic_loop_->step_observed(now_s, listener);
    }
}

std::vector<const HapticLoop*> LessonRun::all_loops() const {
    std::vector<const HapticLoop*> loops{haptic_loop_.get()};
    for (const auto& hand : more_hands_) {
        loops.push_back(hand->loop.get());
    }
    return loops;
}

std::vector<DeviceTraits> LessonRun::all_traits() const {
    std::vector<DeviceTraits> traits;
    for (std::size_t hand = 0; hand < n_hands(); ++hand) {
        traits.push_back(hand_at(hand).device().traits());
    }
    return traits;
}

std::optional<std::size_t> LessonRun::find_hand(HandKind kind) const {
    if (hand_->kind() == kind) {
        return 0;
    }
    for (std::size_t i = 0; i < more_hands_.size(); ++i) {
        if (more_hands_[i]->device->kind() == kind) {
            return i + 1;
        }
    }
    // What was unplugged is moved by the mouse.
    if (kind == HandKind::mouse) {
        for (std::size_t i = 0; i <= more_hands_.size(); ++i) {
            if ((i == 0 ? *hand_ : *more_hands_[i - 1]->device).stands_in()) {
                return i;
            }
        }
    }
    return std::nullopt;
}

bool LessonRun::renders_force() const {
    bool renders = hand_->renders_force();
    for (const auto& hand : more_hands_) {
        renders = renders || hand->device->renders_force();
    }
    return renders;
}

HapticState LessonRun::seen(const HandDevice& device, const HapticState& state) {
    HapticState shown = state;
    const bool is_shut = state.gate == GatePhase::fading || state.gate == GatePhase::stopped;
    if (!device.renders_force() && !is_shut && !any(state.faults)) {
        shown.applied_W = state.commanded_W;
    }
    return shown;
}

std::vector<FeltTime> LessonRun::felt_times() const {
    std::vector<FeltTime> times;
    for (std::size_t hand = 0; hand < n_hands(); ++hand) {
        FeltTime time = (hand == 0 ? *haptic_loop_ : *more_hands_[hand - 1]->loop).felt_time();
        if (!hand_at(hand).renders_force()) {
            time.waiting_s = 0.0;
            time.felt_s = time.asked_s - time.taken_s;
        }
        times.push_back(time);
    }
    return times;
}

void LessonRun::gather_more_hands(SessionInput& gathered) {
    for (const auto& hand : more_hands_) {
        hand->channels.state_for_lesson.take();
        gathered.more_hands.push_back(seen(*hand->device, hand->channels.state_for_lesson.value()));
    }
}

// The lesson speaks to all alike; a simulated one goes where its own script wants.
void LessonRun::lead_more_hands(const SessionOutput& output) {
    for (std::size_t i = 0; i < more_hands_.size(); ++i) {
        MoreHand& hand = *more_hands_[i];
        hand.channels.command.publish(output.force);
        if (i < output.more_aims.size() && output.more_aims[i].is_given) {
            const HandAim& aim = output.more_aims[i];
            hand.device->follow(aim.target_W, aim.buttons);
            hand.wish = HandWish{aim.target_W, aim.buttons, {}};
        }
    }
}

void LessonRun::show_more_hands(Scenery& scenery) const {
    for (const auto& hand : more_hands_) {
        const HapticState state = seen(*hand->device, hand->channels.state_for_lesson.value());
        const bool points = !hand->device->renders_force() && hand->device->points();
        scenery.more_hands.push_back(
            {state, points, points ? hand->device->pointer_W() : state.tool_pose_W});
    }
}

std::optional<HandWish> LessonRun::second_wish() const {
    return more_hands_.empty() ? std::nullopt : more_hands_.front()->wish;
}

void LessonRun::point_at(std::size_t hand, const Vector3& position_W, std::uint32_t buttons) {
    (hand == 0 ? *hand_ : *more_hands_[hand - 1]->device).point_at(position_W, buttons);
}

namespace {

bool is_lost(const HapticState& state) {
    return any(state.faults & (Fault::device_read | Fault::device_stale | Fault::device_write));
}

}  // namespace

bool LessonRun::device_is_lost() const {
    return is_lost(channels_.state_for_lesson.value()) ||
           std::ranges::any_of(more_hands_, [](const auto& hand) {
               return is_lost(hand->channels.state_for_lesson.value());
           });
}

bool LessonRun::holds_back() const {
    const auto waits = [](const HandDevice& device, const HapticState& state,
                          const SafetySettings& safety) {
        const double least_Nm = safety.engage_below_N * safety.max_torque_Nm / safety.max_force_N;
        const bool asks = state.commanded_W.force.norm() >= safety.engage_below_N ||
                          (device.device().traits().max_torque_Nm > 0.0 && least_Nm > 0.0 &&
                           state.commanded_W.torque.norm() >= least_Nm);
        return device.renders_force() && state.gate == GatePhase::waiting && !any(state.faults) &&
               asks;
    };
    bool any_waits = waits(*hand_, channels_.state_for_lesson.value(), limits_of(0));
    for (std::size_t i = 0; i < more_hands_.size(); ++i) {
        const MoreHand& hand = *more_hands_[i];
        any_waits = any_waits ||
                    waits(*hand.device, hand.channels.state_for_lesson.value(), limits_of(i + 1));
    }
    return any_waits;
}

std::string LessonRun::take_device_notice() {
    std::string notice = hand_->take_notice();
    for (const auto& hand : more_hands_) {
        if (const std::string more = hand->device->take_notice(); !more.empty()) {
            notice += (notice.empty() ? "" : " ") + ("The second hand: " + more);
        }
    }
    return notice;
}

void fill_in_memory(Plan& plan, const std::string& name, const HapticLoop& loop) {
    for (const StageInfo& built : loop.stages()) {
        for (PlanStage& planned : plan.stages) {
            if (planned.loop == name && planned.name == name_of(built.stage)) {
                planned.memory_bytes = built.bytes;
            }
        }
    }
}

}  // namespace fulcrum::runtime
