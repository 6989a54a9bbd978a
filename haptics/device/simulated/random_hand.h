// A hand that does what nobody planned, from one seed: deed after deed, each beginning where the last one left it.
//
//   follow    where the lesson's own hand wants to be
//   press     up to 10 cm from there some way, turned by up to half a radian, and stays
//   slide     pressed by up to 4 cm, and to and fro across that, up to 0.5 m/s
//   jerk      shaken by up to 4 cm, two to eight times a second
//   let go    nobody holds the arm
//   touch     goes back to where it felt something last, or to the thing that it sees, presses and strokes there; where it feels nothing any more
//             it lifts off for a moment and comes again
//   wanted = planned + o,   o = o_0 + s(t / T) (o_1 - o_0) + a sin(2 pi f t) c,   s(x) = x^2 (3 - 2 x)      o_0: of the last deed
// Every other deed is to follow, so that a lesson comes on: as long as something is felt, and where it sees a thing to touch not for long
// without. All lengths in the device's frame.
//
// Thread: that of the arm it holds. Cost: some ten nanoseconds. No allocation.
#pragma once

#include "haptics/device/simulated/hand_target.h"
#include "haptics/math/split_mix.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>

namespace fulcrum {

enum class HandDeed : std::uint8_t { follow, press, slide, jerk, let_go, touch };
inline constexpr std::size_t kHandDeeds = static_cast<std::size_t>(HandDeed::touch) + 1;
[[nodiscard]] constexpr const char* name_of(HandDeed deed) noexcept {
    constexpr const char* kNames[] = {"follows", "presses", "slides",
                                      "jerks",   "lets go", "touches"};
    static_assert(std::size(kNames) == kHandDeeds);
    return kNames[static_cast<std::size_t>(deed)];
}

/// What a hand knows without looking.
struct HandFeeling {
    Vector3 position_D{Vector3::Zero()};  ///< of the handle
    Vector3 force_D{Vector3::Zero()};     ///< on the hand
};

class RandomHand {
  public:
    static constexpr double kFarthest_m = 0.5;  ///< from where the lesson's hand wants to be

    explicit RandomHand(std::uint64_t seed) noexcept : chance_(seed) {}

    /// Where it wants to be at `now_s`, where the lesson's hand wants to be there, and it feels this.
    [[nodiscard]] HandTarget step(double now_s, const HandTarget& planned,
                                  const HandFeeling& felt = {}) noexcept;
    /// Whether it holds the arm.
    [[nodiscard]] bool holds() const noexcept { return deed_ != HandDeed::let_go; }
    [[nodiscard]] HandDeed deed() const noexcept { return deed_; }
    /// How often it did each, by HandDeed.
    [[nodiscard]] const std::array<std::uint64_t, kHandDeeds>& done() const noexcept {
        return done_;
    }

  private:
    void begin(double now_s) noexcept;
    [[nodiscard]] HandDeed draw_deed(double now_s) noexcept;
    void choose_way() noexcept;
    void feel(double now_s, const HandTarget& planned, const HandFeeling& felt) noexcept;
    [[nodiscard]] bool has_enough(double now_s) const noexcept;
    [[nodiscard]] Vector3 compute_offset(double now_s) const noexcept;
    [[nodiscard]] Vector3 find_touch_goal(double now_s) const noexcept;
    [[nodiscard]] Vector3 compute_touch(double now_s, const HandTarget& planned) noexcept;
    [[nodiscard]] bool misses(double now_s) const noexcept;
    void try_again(double now_s) noexcept;
    [[nodiscard]] double draw(double low, double high) noexcept {
        return low + (high - low) * chance_.draw_chance();
    }
    [[nodiscard]] Vector3 draw_direction() noexcept;

    SplitMix chance_;
    HandDeed deed_ = HandDeed::follow;
    std::array<std::uint64_t, kHandDeeds> done_{};
    double from_s_ = 0.0;
    double until_s_ = 0.0;
    bool started_ = false;
    // The deed's way: o_0, o_1, T, a, f, c; and how it turns.
    Vector3 begin_D_{Vector3::Zero()};
    Vector3 goal_D_{Vector3::Zero()};
    double reach_s_ = 1.0;
    double swing_m_ = 0.0;
    double swing_Hz_ = 0.0;
    Vector3 across_D_{Vector3::Zero()};
    Vector3 begin_turn_D_{Vector3::Zero()};
    Vector3 goal_turn_D_{Vector3::Zero()};
    // The thing that it sees, if any, where on it something was felt last, and which way in.
    bool sees_ = false;
    Vector3 thing_D_{Vector3::Zero()};
    Vector3 place_D_{Vector3::Zero()};  // from the thing
    Vector3 into_D_{Vector3::Zero()};   // of length 1; nothing where nothing was felt yet
    double felt_s_ = -1.0;              // when it felt something last
    // A touch: since when it tries, how often in vain, how deep, whether it is lifted off, or on its way to the thing.
    double tried_s_ = 0.0;
    double phase_s_ = 0.0;
    int tries_ = 0;
    double depth_m_ = 0.0;
    bool is_lifted_ = false;
    bool reaches_ = false;
    Vector3 search_D_{Vector3::Zero()};      // from the thing, where nothing was felt at its middle
    Vector3 lifts_from_D_{Vector3::Zero()};  // where it was when the touch began
    double last_s_ = 0.0;
    HandFeeling felt_D_{};
    Vector3 wanted_D_{Vector3::Zero()};  // told last
    // Now.
    Vector3 offset_D_{Vector3::Zero()};
    Vector3 turn_D_{Vector3::Zero()};
};

}  // namespace fulcrum
