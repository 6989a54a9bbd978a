// The program's own haptic loop on a simulated arm above a floor: what the hard cases of the closed loop share.
#pragma once

#include "haptics/device/simulated/simulated_arm.h"
#include "haptics/loop/haptic_loop.h"
#include "tests/stability/cases/stability_case.h"

#include <array>
#include <cmath>
#include <memory>

namespace fulcrum::stability {

/// Passes everything on to an arm, and lets a case spoil what it reports.
class SpoiledArm final : public Device {
  public:
    SpoiledArm(const SimulatedArmSettings& settings, LatestValue<HandTarget>& target)
        : arm(settings, target) {}

    [[nodiscard]] const DeviceTraits& traits() const noexcept override { return arm.traits(); }
    [[nodiscard]] bool read(double now_s, DeviceReading& reading) noexcept override {
        const bool good = arm.read(now_s, reading);
        if (spoil != nullptr) {
            spoil(n_reads, reading);
        }
        ++n_reads;
        return good;
    }
    [[nodiscard]] bool write(double now_s, const Wrench& wrench_D) noexcept override {
        written_D = wrench_D;
        return arm.write(now_s, wrench_D);
    }

    SimulatedArm arm;
    void (*spoil)(int, DeviceReading&) = nullptr;
    int n_reads = 0;
    Wrench written_D{};
};

/// A floor at height zero, the arm that starts 10 mm above it, and the loop between them, at 1 kHz.
class HeldArm {
  public:
    HeldArm(const HapticPlan& plan, const SimulatedArmSettings& settings);

    /// One round, `dt_s` after the last.
    void step(double dt_s = 0.001);
    /// Rounds of a millisecond for `seconds`.
    void run(double seconds);
    /// Where the hand wants to be: `height_m` over the floor.
    void aim(double height_m) { aim_at({0.013, height_m, 0.017}); }
    void aim_at(const Vector3& position_D);

    /// What the lesson asks for; stamped at each round.
    ForceCommand command;

    [[nodiscard]] SimulatedArm& arm() { return device_.arm; }
    [[nodiscard]] Vector3 position_m() const { return device_.arm.position_D(); }
    [[nodiscard]] double height_m() const { return device_.arm.position_D().y(); }
    [[nodiscard]] SpoiledArm& device() { return device_; }
    [[nodiscard]] const HapticState& state() const { return loop_->state(); }

  private:
    LatestValue<HandTarget> target_;
    SpoiledArm device_;
    std::unique_ptr<HapticChannels> channels_ = std::make_unique<HapticChannels>();
    std::unique_ptr<HapticLoop> loop_;
    double now_s_ = 0.0;
};

/// The lowest and the highest of a number.
struct Swing {
    double low = HUGE_VAL;
    double high = -HUGE_VAL;
    void take(double value) {
        low = -worse(-low, -value);
        high = worse(high, value);
    }
    [[nodiscard]] double width() const { return high - low; }
};

inline constexpr double kEncoderStep_m = 5.5e-5;  ///< of the arm
inline constexpr std::array kHands{kFingertip, kArm, kPosture};

/// How far the arm still goes to and fro, in any direction, in the last of eleven seconds pressed on the plan's floor, for near the edge a vibration
/// takes seconds to go; infinite where it does not lie on the floor.
[[nodiscard]] double measure_swing(const HapticPlan& plan, const HumanImpedance& human);

/// How far below the floor the hand of a case wants to be.
inline constexpr double kFloorPress_m = 0.004;
/// Nine tenths of the stiffness at which the map of stable walls ends for this hand, at this damping of the coupling.
[[nodiscard]] double find_stiffness_inside(const HumanImpedance& human, double damping);

/// A plan with the floor in it, the program's coupling, and no wait before forces come.
[[nodiscard]] HapticPlan make_floor_plan();
/// A desktop arm over the floor, in this hand; without dry friction, which would hide what a case looks for.
[[nodiscard]] SimulatedArmSettings make_arm_over_floor(const HumanImpedance& human);

}  // namespace fulcrum::stability
