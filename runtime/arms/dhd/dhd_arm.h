// One of Force Dimension's arms in the hands of the one thread that calls its library: poses out, forces in, and what is amiss.
//
//   p_D = (y, z, x)_A    q_D = (w, y, z, x)_A    f_A = (f_z, f_x, f_y)_D     A: +X to the person, +Y right, +Z up
// Each round reads and then sets a force, zero as well: the arm carries its own weight with orders only, and its watchdog takes the
// force away kDhdWatchdog_s after the last one. Every kStatusEvery rounds it is asked whether it has braked and why; then there is no
// force and no pose that counts. What goes by itself is switched on again after kDhdRest_s; the loop's gate then waits for calm and rises
// softly. Where calls fail for kDhdLost_s it is opened again, every kDhdRest_s, and counts only if it is the same arm and knows its zero:
// nothing here ever moves it by itself.
//
// Thread: the port's, made and begun by who opens it. Cost: the library's calls, which may wait.
// Source: dhd_library.h; that compensation goes out with forces alone, the watchdog and the brake: dhdc.h of SDK 3.17.5.
#pragma once

#include "haptics/device/device.h"
#include "runtime/arms/arm_port.h"
#include "runtime/arms/dhd/dhd_library.h"
#include "runtime/arms/dhd/dhd_trouble.h"

namespace fulcrum::runtime {

inline constexpr unsigned char kDhdWatchdogTicks = 160;
inline constexpr double kDhdWatchdog_s = kDhdWatchdogTicks * kDhdTick_s;  ///< 20 ms, kArmSilence_s
inline constexpr int kDhdStatusEvery = 10;
inline constexpr double kDhdUnwatched_N = 1.0;  ///< the most of an arm without a watchdog
inline constexpr double kDhdRest_s = 0.5;
inline constexpr double kDhdLost_s = 0.3;

class DhdArm {
  public:
    /// An arm that is open as `id` and knows its zero. `serial`: 0 of one that tells none.
    DhdArm(const DhdFunctions& use, char id, unsigned short serial, const DeviceTraits& traits)
        : use_(use), id_(id), serial_(serial), traits_(traits) {}

    /// Its own limits and watchdog, its weight carried, its force on; false where a call failed.
    [[nodiscard]] bool begin() noexcept;
    /// Where the handle is now; not there while `trouble` is something.
    [[nodiscard]] ArmSample read(double now_s) noexcept;
    /// What it is to give until the next round; nothing but its own weight while there is trouble.
    void feel(const Wrench& wrench_D) noexcept;
    /// Without force, and closed. It brakes nothing.
    void end() noexcept;

    [[nodiscard]] DhdTrouble trouble() const noexcept {
        return round_ != DhdTrouble::none ? round_ : status_;
    }
    /// As it was made; once it was begun without a watchdog it gives kDhdUnwatched_N at most.
    [[nodiscard]] const DeviceTraits& traits() const noexcept { return traits_; }
    /// Whether its watchdog was set.
    [[nodiscard]] bool is_watched() const noexcept { return is_watched_; }

  private:
    [[nodiscard]] DhdTrouble read_pose(ArmSample& sample) noexcept;
    void look_at_status(double now_s) noexcept;
    void open_again(double now_s) noexcept;

    DhdFunctions use_;
    char id_;
    unsigned short serial_;
    DeviceTraits traits_;
    bool is_watched_ = false;
    bool is_open_ = true;
    bool is_deaf_ = false;  // the last order did not get through
    int rounds_ = 0;
    DhdTrouble round_ = DhdTrouble::none;   // of this round's calls
    DhdTrouble status_ = DhdTrouble::none;  // as the arm told it last
    double off_since_s_ = 0.0;     // since when the status is amiss, or it was switched on last
    double failed_since_s_ = 0.0;  // 0: calls work
    double opened_s_ = 0.0;        // when it was last tried
};

}  // namespace fulcrum::runtime
