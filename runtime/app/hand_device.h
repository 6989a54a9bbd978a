// The device of a hand, and what moves it when that is not the device itself: a lesson's simulated hand, or the mouse.
//
// Thread: made and moved by the lesson loop; `device` is read and written by the haptic loop. Targets cross as newest values.
#pragma once

#include "haptics/base/error.h"
#include "haptics/device/device.h"
#include "haptics/device/fitted/fitted_device.h"
#include "haptics/device/hid/hid_hand.h"
#include "haptics/device/mouse/pointer_device.h"
#include "haptics/device/simulated/simulated_hand.h"
#include "haptics/device/stand_in/stand_in_device.h"
#include "haptics/link/link_device.h"
#include "haptics/link/spoiled_arm.h"
#include "haptics/loop/haptic_plan.h"
#include "runtime/app/arm_line.h"
#include "runtime/app/run_request.h"
#include "runtime/lesson/first_use.h"

#include <memory>
#include <optional>
#include <string>

namespace fulcrum::runtime {

class HandDevice {
  public:
    /// Opens the device that `request` names, in the workspace of `plan`. Refuses a record that cannot be read.
    [[nodiscard]] static Expected<std::unique_ptr<HandDevice>> open(const RunRequest& request,
                                                                    const HapticPlan& plan);

    /// The most that the request's device can give, in newtons, before it is opened; infinite for one that renders none or repeats a run.
    [[nodiscard]] static double force_limit_N(const RunRequest& request);

    ~HandDevice();
    HandDevice(const HandDevice&) = delete;
    HandDevice& operator=(const HandDevice&) = delete;

    /// What moves it.
    [[nodiscard]] HandKind kind() const noexcept { return kind_; }
    [[nodiscard]] Device& device() noexcept { return *device_; }
    [[nodiscard]] const Device& device() const noexcept { return *device_; }

    /// Where the simulated person wants the hand, in the world; does nothing to other devices.
    void follow(const Pose& target_W, std::uint32_t buttons);
    /// The middle of the thing to touch that this person sees nearest to the hand, in the world, if there is any; before `follow`.
    void see(const std::optional<Vector3>& thing_W);
    [[nodiscard]] bool sees_thing() const noexcept { return thing_D_.has_value(); }
    /// Where the mouse points, in the world; does nothing to other devices.
    void point_at(const Vector3& position_W, std::uint32_t buttons);
    /// Where the mouse pointed last, whatever the hand on the screen does.
    [[nodiscard]] const Pose& pointer_W() const noexcept { return pointer_W_; }

    /// True where a pointer stands for the hand, false where the device itself tells its place.
    [[nodiscard]] bool points() const noexcept {
        return stands_in() || (hid_ == nullptr && linked_ == nullptr);
    }
    /// Whether what it does is felt now.
    [[nodiscard]] bool renders_force() const noexcept {
        return device_->traits().renders_force && !stands_in();
    }
    /// True while a pointer moves it for a device that was unplugged.
    [[nodiscard]] bool stands_in() const noexcept {
        return stand_in_ != nullptr && stand_in_->stands_in();
    }
    /// True for what can push a person's hand: an arm, or a joystick with motors, plugged in or not.
    [[nodiscard]] bool can_push() const noexcept {
        return (linked_ != nullptr || hid_ != nullptr) && device_->traits().renders_force;
    }
    /// What a first use of it has to try, as it stands before the learner.
    [[nodiscard]] TriedDevice tried() const;
    /// From now on an arm or a joystick gives none, whatever a loop asks for. Before the loop steps.
    void give_no_force();
    /// It was tried well: a joystick that was not known gives all that is asked for. Before the loop steps.
    void give_all_force();
    /// The next loop that has the device has a clock of its own.
    void begin_anew();
    /// What has happened to the device since the last call that people should know, a sentence; empty when nothing has.
    [[nodiscard]] std::string take_notice();
    /// Open: the arm at the other end of a link, or the joystick with motors, for which walls must be stable; nothing of another device.
    [[nodiscard]] std::optional<WallHolder> wall_holder() const;
    /// How the link to an arm does; nothing of another device. For the lesson loop.
    [[nodiscard]] std::optional<LinkStatus> link_status();

    /// Before the loop steps: the limits of its last gate. An arm is told them, and one on which things break is held to them; does nothing
    /// to other devices.
    void keep_limits(const SafetySettings& run);
    /// What was seen of an arm on which things break; null of another device.
    [[nodiscard]] const SpoiledCounts* spoiled_counts() const {
        return spoiled_ != nullptr ? &spoiled_->counts() : nullptr;
    }

    /// What is watched on it.
    [[nodiscard]] FeltLimits spoiled_limits() const {
        return spoiled_ != nullptr ? spoiled_->limits() : FeltLimits{};
    }

    /// How fast a simulated hand really moves, in the world, m/s; nothing of another device. Only where loops take turns under
    /// a virtual clock: it reads what the haptic thread writes.
    [[nodiscard]] std::optional<Vector3> true_velocity_W() const;

  private:
    explicit HandDevice(const HapticPlan& plan);
    [[nodiscard]] Expected<void> make(const RunRequest& request);
    [[nodiscard]] Expected<void> link(const HandChoice& request);
    void spoil(const RunRequest& request);
    void add_link_notice(std::string& notice);
    [[nodiscard]] double planned_link_s() const;
    [[nodiscard]] OwnArm* own_arm() const noexcept {
        return line_ != nullptr ? line_->own_arm().get() : nullptr;
    }
    [[nodiscard]] Expected<std::unique_ptr<PointerDevice>> make_pointer(double yield);

    HandKind kind_ = HandKind::none;
    Workspace workspace_;
    SafetySettings safety_;
    LatestValue<HandTarget> hand_target_;
    std::optional<Vector3> thing_D_{};  // that is seen nearest
    LatestValue<PointerTarget> pointer_target_;
    Pose pointer_W_;
    std::unique_ptr<ArmLine> line_;  // what a link needs; outlives the device
    std::unique_ptr<Device> device_;
    const SimulatedHand* simulated_ = nullptr;  // the device, where it is one
    hid::HidHand* hid_ = nullptr;               // likewise, as are the next
    LinkDevice* linked_ = nullptr;
    WatchedDevice* watched_ = nullptr;  // around a HID device
    FittedDevice* fitted_ = nullptr;    // around an arm or a HID device
    AxisOrder axes_{};                  // as it is set there
    StandInDevice* stand_in_ =
        nullptr;  // around an arm or a HID device, where the mouse has nothing else to move
    bool told_stand_in_ = false;
    bool told_too_long_ = false;
    bool told_slower_ = false;
    double link_s_ = 0.0;  // there and back, as it was greeted
    SpoiledArm* spoiled_ = nullptr;
};

}  // namespace fulcrum::runtime
