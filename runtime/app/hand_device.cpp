#include "runtime/app/hand_device.h"

#include "haptics/device/replay/replay_device.h"
#include "haptics/loop/workspace.h"
#include "haptics/record/record.h"

#include <algorithm>
#include <limits>

namespace fulcrum::runtime {
namespace {

// With a mouse, weight is seen: 5 N hang 2 cm lower in the device's frame and follow half as fast.
constexpr double kMouseSag_m_per_N = 0.004;
constexpr double kMouseSlow_per_N = 0.2;

}  // namespace

Expected<std::unique_ptr<HandDevice>> HandDevice::open(const RunRequest& request,
                                                       const HapticPlan& plan) {
    std::unique_ptr<HandDevice> hand(new HandDevice(plan));
    if (auto made = hand->make(request); !made) {
        return tl::unexpected(made.error());
    }
    return hand;
}

double HandDevice::force_limit_N(const RunRequest& request) {
    switch (request.hand) {
        case HandKind::scripted:
            return SimulatedHandSettings{}.max_force_N;
        case HandKind::hid:
            return runtime::force_limit_N(request.hid);
        case HandKind::mouse:
        case HandKind::replay:
            break;
    }
    return std::numeric_limits<double>::infinity();
}

Expected<void> HandDevice::make(const RunRequest& request) {
    switch (request.hand) {
        case HandKind::scripted: {
            const SimulatedHandSettings settings;
            return validate(settings).map([&] {
                auto simulated = std::make_unique<SimulatedHand>(settings, hand_target_);
                simulated_ = simulated.get();
                device_ = std::move(simulated);
                hand_target_.publish({});
            });
        }
        case HandKind::mouse: {
            PointerSettings settings;
            settings.sag_m_per_N = kMouseSag_m_per_N;
            settings.slow_per_N = kMouseSlow_per_N;
            settings.half_extent_D = Vector3::Constant(1.0 / std::max(workspace_.scale, 0.1));
            return validate(settings).map([&] {
                device_ = std::make_unique<PointerDevice>(settings, pointer_target_);
                pointer_target_.publish({});
            });
        }
        case HandKind::hid:
            return open_hid_hand(request.hid, workspace_).map([&](auto&& opened) {
                hid_ = opened.get();
                device_ = std::move(opened);
            });
        case HandKind::replay:
            return load_record(request.hand_file.string()).map([&](auto&& record) {
                device_ = std::make_unique<ReplayDevice>(record);
            });
    }
    return {};
}

std::optional<Vector3> HandDevice::true_velocity_W() const {
    if (simulated_ == nullptr) {
        return std::nullopt;
    }
    return workspace_.pose_WD.orientation * (workspace_.scale * simulated_->velocity_D());
}

std::string HandDevice::take_notice() {
    return hid_ != nullptr ? hid_->take_notice() : std::string();
}

void HandDevice::follow(const Pose& target_W, std::uint32_t buttons) {
    HandTarget target;
    target.pose_D = compute_device_pose(workspace_, target_W);
    target.buttons = buttons;
    hand_target_.publish(target);
}

void HandDevice::point_at(const Vector3& position_W, std::uint32_t buttons) {
    pointer_W_ = Pose::at(position_W);
    pointer_target_.publish({compute_device_pose(workspace_, pointer_W_).position, buttons});
}

}  // namespace fulcrum::runtime
