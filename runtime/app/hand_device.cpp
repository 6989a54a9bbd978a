#include "runtime/app/hand_device.h"

#include "haptics/base/clock.h"
#include "haptics/device/replay/recorded_traits.h"
#include "haptics/device/replay/replay_device.h"
#include "haptics/loop/workspace.h"
#include "haptics/record/record.h"
#include "haptics/record/record_reader.h"
#include "runtime/app/hand_fitting.h"
#include "runtime/app/interrupt.h"
#include "runtime/app/link_words.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <limits>
#include <thread>
#include <utility>
#include <vector>

namespace fulcrum::runtime {
namespace {

constexpr double kMeasured_s = 0.1;

// Of the way for which walls were made: what its margin of a tenth and its whole milliseconds do not cover.
constexpr double kSlowerWay = 1.5;

// A stick's place and its force each wait for their endpoint's turn: most ask for one in 8 ms (USB 2.0, 5.7.4: 1 to 255 frames of 1 ms).
constexpr double kHidRound_s = 0.016;

// A number that the repeated record tells.
std::optional<double> find_number(const RunRequest& request, const char* name) {
    const auto text = request.replayed ? find_fact(request.replayed->header, name) : std::nullopt;
    double value = 0.0;
    const bool is_number =
        text && std::from_chars(text->data(), text->data() + text->size(), value).ec == std::errc{};
    return is_number ? std::optional(value) : std::nullopt;
}

// Whether there is a mouse, and no hand that it moves.
bool mouse_is_free(const RunRequest& request) {
    return request.hands_there == HandsThere::desk && request.hand != HandKind::mouse &&
           std::ranges::find(request.more_hands, HandKind::mouse, &HandChoice::hand) ==
               request.more_hands.end();
}

void add_sentence(std::string& text, const std::string& sentence) {
    text += (text.empty() ? "" : " ") + sentence;
}

// There and back, as it usually takes: the median of what comes within kMeasured_s of the first that does. Commands of no force are asked for
// it, for an arm echoes nothing else; where none comes back it is as long as it may be.
double measure_way_s(LinkDevice& device, double began_s) {
    std::vector<double> trips_s;
    double until_s = monotonic_now_s() + kGreeting_s;
    DeviceReading reading;
    while (monotonic_now_s() < until_s && !interrupted()) {
        const double now_s = monotonic_now_s() - began_s;
        (void)device.read(now_s, reading);
        (void)device.write(now_s, Wrench{});
        if (const double trip_s = device.status().newest_round_trip_s; trip_s > 0.0) {
            until_s = trips_s.empty() ? monotonic_now_s() + kMeasured_s : until_s;
            trips_s.push_back(trip_s);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    const auto middle = trips_s.begin() + static_cast<std::ptrdiff_t>(trips_s.size() / 2);
    std::ranges::nth_element(trips_s, middle);
    return trips_s.empty() ? LinkDeviceSettings{}.most_round_trip_s : *middle;
}

}  // namespace

HandDevice::HandDevice(const HapticPlan& plan)
    : workspace_(plan.workspace), safety_(plan.safety), pointer_W_(plan.workspace.pose_WD) {}

HandDevice::~HandDevice() = default;

Expected<std::unique_ptr<HandDevice>> HandDevice::open(const RunRequest& request,
                                                       const HapticPlan& plan) {
    std::unique_ptr<HandDevice> hand(new HandDevice(plan));
    if (auto made = hand->make(request); !made) {
        return tl::unexpected(made.error());
    }
    hand->device_ = fit_device(request, std::move(hand->device_));
    hand->fitted_ = dynamic_cast<FittedDevice*>(hand->device_.get());
    hand->axes_ = request.fit.axes.value_or(AxisOrder{});
    constexpr bool kAsked = false;
    if (hand->hid_ != nullptr && hand->can_push() &&
        !is_tried(request.fit, kAsked, hand->device_->traits().name)) {
        hand->fitted_->give_part(kUntriedPart);
    }
    if (hand->points() || !mouse_is_free(request)) {
        return hand;
    }
    return hand->make_pointer(request.yield).map([&](std::unique_ptr<PointerDevice>&& pointer) {
        auto stand_in =
            std::make_unique<StandInDevice>(std::move(hand->device_), std::move(pointer));
        hand->stand_in_ = stand_in.get();
        hand->device_ = std::move(stand_in);
        return std::move(hand);
    });
}

double HandDevice::force_limit_N(const RunRequest& request) {
    switch (request.hand) {
        case HandKind::scripted:
            return SimulatedHandSettings{}.max_force_N;
        case HandKind::hid:
            return runtime::force_limit_N(request.hid);
        case HandKind::replay:
            // As when it was recorded: felt weights were fitted to it.
            if (const auto was = find_number(request, "option.device N")) {
                return *was;
            }
            break;
        case HandKind::link:  // what it can give it tells when it is opened
        case HandKind::mouse:
        case HandKind::keys:
        case HandKind::none:
            break;
    }
    return std::numeric_limits<double>::infinity();
}

Expected<void> HandDevice::make(const RunRequest& request) {
    kind_ = request.hand;
    switch (request.hand) {
        case HandKind::scripted: {
            if (request.spoil_seed) {
                spoil(request);
                return {};
            }
            const SimulatedHandSettings settings;
            return validate(settings).map([&] {
                auto simulated = std::make_unique<SimulatedHand>(settings, hand_target_);
                simulated_ = simulated.get();
                device_ = std::move(simulated);
                hand_target_.publish({});
            });
        }
        case HandKind::mouse:
        case HandKind::keys:
            return make_pointer(request.yield).map([&](std::unique_ptr<PointerDevice>&& pointer) {
                device_ = std::move(pointer);
                pointer_target_.publish({});
            });
        case HandKind::hid:
            return open_hid_hand(request.hid, workspace_)
                .map([&](std::unique_ptr<hid::HidHand>&& opened) {
                    hid_ = opened.get();
                    const SensorWatch watch = sensor_watch(
                        opened->traits(), hid_settings(workspace_).stick_pointer.half_extent_D);
                    auto watched = std::make_unique<WatchedDevice>(watch, std::move(opened));
                    watched_ = watched.get();
                    device_ = std::move(watched);
                });
        case HandKind::link:
            return link(request);
        case HandKind::replay:
            if (request.replayed) {
                device_ = std::make_unique<ReplayDevice>(*request.replayed);
                return {};
            }
            return load_record(request.hand_file.string()).map([&](auto&& record) {
                device_ = std::make_unique<ReplayDevice>(record);
            });
        case HandKind::none:
            break;
    }
    return fail("nobody moves this hand", {}, "give --hand a device");
}

Expected<std::unique_ptr<PointerDevice>> HandDevice::make_pointer(double yield) {
    PointerSettings settings = make_yielding(yield);
    settings.half_extent_D = Vector3::Constant(1.0 / std::max(workspace_.scale, 0.1));
    if (auto valid = validate(settings); !valid) {
        return tl::unexpected(valid.error());
    }
    return std::make_unique<PointerDevice>(settings, pointer_target_);
}

// All in this program, under its clock; every number comes from the seed. The arm stands in the same place, and is a strong one: what it may
// give in this run it must be told.
void HandDevice::spoil(const RunRequest& request) {
    hand_target_.publish({});
    SafetySettings own = ArmServerSettings{}.safety;
    own.max_felt_speed_m_per_s = request.plan.site.speed_m_per_s;
    own.max_energy_J = request.plan.site.energy_J;
    auto arm =
        std::make_unique<SpoiledArm>(*request.spoil_seed, hand_target_, own, request.spoil_model);
    spoiled_ = arm.get();
    device_ = std::move(arm);
}

void HandDevice::keep_limits(const SafetySettings& run) {
    if (spoiled_ != nullptr) {
        spoiled_->keep_limits(run);
    }
    if (linked_ != nullptr) {
        linked_->tell_limits(run);
    }
}

// The arm must say what it is before anything is built for it.
Expected<void> HandDevice::link(const HandChoice& request) {
    auto line = ArmLine::open(request);
    if (!line) {
        return tl::unexpected(line.error());
    }
    line_ = std::move(*line);
    LinkDeviceSettings settings;
    settings.max_force_N = safety_.max_force_N;
    settings.max_torque_Nm = safety_.max_torque_Nm;
    settings.max_slew_N_per_s = safety_.max_slew_N_per_s;
    if (auto good = validate(settings); !good) {
        return good;
    }
    const double began_s = monotonic_now_s();
    auto greeted = line_->greet(settings, began_s);
    if (!greeted) {
        return tl::unexpected(greeted.error());
    }
    std::unique_ptr<LinkDevice> device = std::move(*greeted);
    link_s_ = measure_way_s(*device, began_s);
    // The run has a clock of its own.
    device->part();
    linked_ = device.get();
    device_ = std::move(device);
    return {};
}

void HandDevice::give_no_force() {
    if (fitted_ != nullptr) {
        fitted_->give_no_force();
    }
}

void HandDevice::give_all_force() {
    if (fitted_ != nullptr) {
        fitted_->give_part(1.0);
    }
}

TriedDevice HandDevice::tried() const {
    if (hid_ == nullptr) {
        return {};
    }
    const Vector3 pushed_D(hid_->pushes_x() ? 1.0 : 0.0, hid_->pushes_y() ? 1.0 : 0.0, 0.0);
    const Vector3 pushed = axes_.turn(pushed_D).cwiseAbs();
    return {.is_stick = true, .pushes = {pushed.x() > 0.5, pushed.y() > 0.5, pushed.z() > 0.5}};
}

void HandDevice::begin_anew() {
    if (linked_ != nullptr) {
        linked_->part();
    }
    if (watched_ != nullptr) {
        watched_->begin_anew();
    }
    if (stand_in_ != nullptr) {
        stand_in_->begin_anew();
    }
}

// In whole milliseconds, so that one way gives one plan, but for what waking up late adds; an arm's own round is never none.
double HandDevice::planned_link_s() const {
    constexpr double kWakesLate_ms = 0.3;
    return 1.0e-3 * std::max(std::ceil(1.0e3 * link_s_ - kWakesLate_ms), 1.0);
}

std::optional<WallHolder> HandDevice::wall_holder() const {
    if (linked_ == nullptr) {
        return hid_ != nullptr && can_push()
                   ? std::optional(make_wall_holder(device_->traits(), kHidRound_s))
                   : std::nullopt;
    }
    return make_wall_holder(device_->traits(), planned_link_s());
}

std::optional<LinkStatus> HandDevice::link_status() {
    return linked_ != nullptr ? std::optional(linked_->status()) : std::nullopt;
}

std::optional<Vector3> HandDevice::true_velocity_W() const {
    if (simulated_ == nullptr) {
        return std::nullopt;
    }
    return workspace_.pose_WD.orientation * (workspace_.scale * simulated_->velocity_D());
}

std::string HandDevice::take_notice() {
    std::string notice = hid_ != nullptr        ? hid_->take_notice()
                         : own_arm() != nullptr ? own_arm()->take_notice()
                                                : std::string();
    if (stands_in() != std::exchange(told_stand_in_, stands_in())) {
        add_sentence(notice, stands_in() ? "The mouse moves the hand until it is there again."
                                         : "It moves the hand again; its force comes softly.");
    }
    if (linked_ != nullptr) {
        add_link_notice(notice);
    }
    return notice;
}

void HandDevice::add_link_notice(std::string& notice) {
    const LinkStatus link = linked_->status();
    if (link.too_long != std::exchange(told_too_long_, link.too_long)) {
        add_sentence(notice, describe_way(link, LinkDeviceSettings{}.most_round_trip_s));
    }
    const bool is_slow = !link.too_long && link.round_trip_s > kSlowerWay * planned_link_s();
    if (is_slow && !std::exchange(told_slower_, is_slow)) {
        add_sentence(notice, describe_slower_way(link, planned_link_s()));
    }
}

void HandDevice::see(const std::optional<Vector3>& thing_W) {
    thing_D_.reset();
    if (thing_W) {
        thing_D_ = compute_device_pose(workspace_, Pose::at(*thing_W)).position;
    }
}

void HandDevice::follow(const Pose& target_W, std::uint32_t buttons) {
    HandTarget target;
    target.sees_thing = thing_D_.has_value();
    target.thing_D = thing_D_.value_or(Vector3::Zero());
    target.pose_D = compute_device_pose(workspace_, target_W);
    target.buttons = buttons;
    hand_target_.publish(target);
}

void HandDevice::point_at(const Vector3& position_W, std::uint32_t buttons) {
    pointer_W_ = Pose::at(position_W);
    pointer_target_.publish({compute_device_pose(workspace_, pointer_W_).position, buttons});
}

}  // namespace fulcrum::runtime
