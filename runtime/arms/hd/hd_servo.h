// What runs in the library's own thread, a thousand times a second: a pose out, a force in, and what is amiss.
//
//   tick   begin frame · read · calibration · exchange with the port · set the force, zero too · end frame · errors
//   p_D = p / 1000    q_D of the matrix, made of length 1    f as it is: the frames are the same
// No force until the arm knows its zero, none of what is no pose, none for a rest after an error; the pose does not count then either, so
// that the loop's gate waits for calm and rises softly. A frame that sets no force has none, so that a loop that says nothing is none as
// well, by `exchange`.
// A timer's error in the first second is the library's habit and no trouble: whether it runs the ticks tell.
//
// Thread: the library's, but for what says otherwise; no lock, no allocation. Cost: the library's calls and two hand-overs.
// Source: OpenHaptics 3.0, Programmer's Guide, chapter 5 (frames; that the update follows needs_update, and a person needs_person).
#pragma once

#include "haptics/device/device.h"
#include "runtime/arms/arm_port.h"
#include "runtime/arms/hd/hd_library.h"
#include "runtime/arms/port_door.h"

#include <atomic>

namespace fulcrum::runtime {

inline constexpr int kHdCalibrationEvery = 20;  ///< ticks
inline constexpr double kHdBegin_s = 1.0;

/// The port's side of a tick.
class HdExchange {
  public:
    virtual ~HdExchange() = default;
    /// Takes the newest pose, and gives the force that is wanted now. Neither waits nor allocates.
    [[nodiscard]] virtual Wrench exchange(const ArmSample& newest) noexcept = 0;
};

class HdServo {
  public:
    /// `arm` is open; `side` is touched while the door is open, and not after.
    HdServo(const HdFunctions& use, std::uint32_t arm, std::uint32_t calibration_style,
            const DeviceTraits& traits, HdExchange& side)
        : use_(use), arm_(arm), style_(calibration_style), traits_(traits), side_(&side) {}
    HdServo(const HdServo&) = delete;
    HdServo& operator=(const HdServo&) = delete;

    /// What the scheduler calls; `self` is an HdServo.
    static std::uint32_t run(void* self) noexcept {
        static_cast<HdServo*>(self)->tick(monotonic_now_s());
        return kHdAgain;
    }
    /// One of them. `now_s` only goes on.
    void tick(double now_s) noexcept;

    /// Any thread: no force from the next tick on, and the port is left alone.
    void shut() noexcept { door_.shut(); }
    /// Any thread: how many there have been.
    [[nodiscard]] std::uint64_t ticks() const noexcept {
        return ticks_.load(std::memory_order_acquire);
    }
    /// Any thread: whether the library's thread is in one now.
    [[nodiscard]] bool is_inside() const noexcept {
        return is_inside_.load(std::memory_order_acquire);
    }
    /// Any thread: of the last tick.
    [[nodiscard]] std::uint32_t trouble() const noexcept {
        return trouble_.load(std::memory_order_acquire);
    }

  private:
    [[nodiscard]] ArmSample read(double now_s) noexcept;
    void look_at_calibration() noexcept;
    [[nodiscard]] std::uint32_t judge(double now_s) noexcept;
    void give(const Vector3& force) noexcept;
    void take_errors(double now_s) noexcept;

    HdFunctions use_;
    std::uint32_t arm_;
    std::uint32_t style_;
    DeviceTraits traits_;
    HdExchange* side_;
    PortDoor door_;
    double begun_s_ = 0.0;  // at the first tick; 0 before
    bool is_pose_ = false;
    std::uint32_t calibration_ = hd_needs_person;  // until it says otherwise
    std::uint32_t error_ = hd_no_error;            // the last, until its rest is over
    double rests_until_s_ = 0.0;
    std::atomic<bool> is_inside_{false};
    std::atomic<std::uint64_t> ticks_{0};
    std::atomic<std::uint32_t> trouble_{hd_needs_person};
};

}  // namespace fulcrum::runtime
