// Keys in the place of a mouse: what they hold down moves the pointer, and the rest of the program sees a pointer that moved.
//
//   w a s d              up, left, down, right: slowly at first, quicker the longer they are held; by their place on the keyboard,
//                        whatever stands on them
//   i j k l              the same, for who has the mouse in the left hand and the right one on the keys
//   page up, page down   as the wheel
//   shift                as the mouse's first button
// v(t) = min(v_slow + a t, v_quick) while any is held, from v_slow again at the next press: a tap is a fine step.
// While letters are typed new presses of them move nothing; whoever moves the mouse has it back.
//
// Thread: that of the window.  Cost: a few comparisons a frame.
#pragma once

#include "haptics/math/matrix.h"
#include "runtime/render/glfw/window.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace fulcrum::runtime {

/// In heights of the picture, per second and per second squared.
struct KeyHandSettings {
    double slow = 0.08;
    double quick = 1.2;
    double growth = 2.0;
};

struct PictureSize {
    int width_px = 0;
    int height_px = 0;
};

class KeyHand {
  public:
    explicit KeyHand(const KeyHandSettings& settings = {}) : settings_(settings) {}

    /// Puts what the keys do into the pointer, wheel and first button of `events`. `types`: letters are an answer's.
    void take(WindowEvents& events, bool types, const PictureSize& size, double dt_s);
    /// Which hand holds the mouse: the other one is on the keys. Lets go of all keys.
    void hold_by(bool left_handed);
    /// Lets go of all keys.
    void release();
    /// How far the pointer goes in the next frame of `dt_s` while a key is held, in pixels.
    [[nodiscard]] double step_px(const PictureSize& size, double dt_s) const;

  private:
    enum Way : std::uint8_t { up, left, down, right, button, n_ways };
    using Keys = std::array<std::string_view, n_ways>;
    static constexpr Keys kOfLeftHand{"w", "a", "s", "d", "shift"};
    static constexpr Keys kOfRightHand{"i", "j", "k", "l", "shift"};

    friend std::string list_hand_keys(bool left_handed);
    void take_keys(WindowEvents& events, bool types);

    KeyHandSettings settings_;
    Keys keys_ = kOfLeftHand;
    std::array<bool, n_ways> held_{};
    double speed_ = 0.0;  // heights a second; 0: at rest
    std::optional<Vector2> pointer_px_;
};

/// What stands on the keys that move, in the user's layout: "W, A, S, D".
[[nodiscard]] std::string list_hand_keys(bool left_handed);

}  // namespace fulcrum::runtime
