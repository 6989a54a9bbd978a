// A young hand at a mouse, from one seed: late, never still, now and then somewhere else, and the button slips.
//
//   seen      where it is meant to be, 0.3 s ago
//   tremor    x' = -x / tau + sigma sqrt(2 / tau) w   in each direction, w white, so that its spread is sigma
//   elsewhere every few seconds it goes to a place of the picture by chance, and stays for a while
//   slips     every few seconds it lets go of the button, or presses it where nothing is asked
// Its figures are chosen so that who plays so hits a thing 40 px wide every other time; no study is behind them.
//
// Thread: the lesson's. Cost: microseconds a frame.
#pragma once

#include "haptics/math/spatial.h"
#include "haptics/math/split_mix.h"
#include "runtime/app/key_hand.h"

#include <cstdint>
#include <deque>

namespace fulcrum::runtime {

/// A mouse, in pixels from the upper left corner.
struct MousePlace {
    Vector2 pointer_px{Vector2::Zero()};
    std::uint32_t buttons = 0;  ///< bit 0: the left one
};

class ClumsyHand {
  public:
    static constexpr double kLate_s = 0.3;
    static constexpr double kTremor_px =
        12.0;  ///< standard deviation in each direction, of a picture 720 px high

    ClumsyHand(std::uint64_t seed, const PictureSize& picture) : chance_(seed), picture_(picture) {}

    /// Where it is `dt_s` after the last call, of whom the lesson wants to be at `meant`. Whole pixels, within the picture.
    [[nodiscard]] MousePlace step(double now_s, double dt_s, const MousePlace& meant);

  private:
    struct Meant {
        double at_s = 0.0;
        MousePlace place{};
    };
    [[nodiscard]] double draw(double low, double high) {
        return low + (high - low) * chance_.draw_chance();
    }
    [[nodiscard]] double draw_normal();
    void wander(double now_s);
    void slip(double now_s);

    SplitMix chance_;
    PictureSize picture_;
    std::deque<Meant> meant_{};  // the oldest first, one of them older than kLate_s
    Vector2 tremor_px_{Vector2::Zero()};
    Vector2 elsewhere_px_{Vector2::Zero()};
    double strays_s_ = 0.0;  // when it next goes elsewhere
    double back_s_ = 0.0;    // until when it is there
    double slips_s_ = 0.0;
    double slipped_s_ = 0.0;
};

}  // namespace fulcrum::runtime
