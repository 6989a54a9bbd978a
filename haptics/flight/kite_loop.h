// The kite's round: takes the lesson's orders and the hand, flies on, publishes what is seen and what is felt.
//
// A round that comes late is made up for in parts as long as one in time, in which the hand goes evenly to where it is now: a step is
// linearised (line.h), and a stiff line in a long one would be flung by what it bends within it. So a world that is starved to 20 Hz
// flies as at its own rate, and the hand feels it late, by line_feel.h. The line's end follows a hand at most at
// kFastestLineHand_m_per_s: a hand that has been put elsewhere draws it there, and throws nothing.
//
// Thread: `step` on one thread beside the haptic one (or a virtual clock). Cost: that of KiteFlight::step, for each
// period that has passed, and one copy of the frame. No allocation after construction.
#pragma once

#include "haptics/base/periodic_task.h"
#include "haptics/flight/kite_flight.h"
#include "haptics/flight/kite_swap.h"
#include "haptics/flight/line_feel.h"
#include "haptics/handover/latest_value.h"

#include <array>
#include <cstdint>

namespace fulcrum {

/// What a lesson sets. A launch and a cut are made once each time their counts grow; the rest holds on.
struct KiteOrders {
    std::uint32_t n_launches = 0;
    double elevation_rad = 0.7;  ///< of the line at the launch
    double lean_rad = 1.1;       ///< of the spine, into the wind
    double line_m = 20.0;        ///< unstretched; let out or taken in at kReel_m_per_s
    double wind_m_per_s = 6.0;   ///< mean at 10 metres
    std::uint32_t n_cuts = 0;    ///< the line is cut once each time it grows
};

/// How it flies, for the picture and the lesson.
struct KiteFrame {
    double stamp_s = -1.0;
    KiteReport report{};
    std::int32_t n_nodes = 0;
    std::array<Vector3, kMostLineSegments + 1> line_W{};  ///< n_nodes of them, the hand's first
};

/// The one writer and the one reader of each stand behind it.
struct KiteChannels {
    LatestValue<KiteOrders> orders;  ///< lesson loop; kite loop
    KiteSwap built;  ///< lesson loop; kite loop: another kite, launched when it is taken
    LatestValue<Vector3> hand_W;   ///< haptic loop; kite loop: where the line leaves it
    LatestValue<KiteFrame> frame;  ///< kite loop; lesson loop and picture
    LatestValue<LineState> line;   ///< kite loop; haptic loop
};

/// How fast a reel turns.
inline constexpr double kReel_m_per_s = 2.0;
/// Faster no hand draws a line; in the world, where a hand may be drawn larger than it is.
inline constexpr double kFastestLineHand_m_per_s = 10.0;
/// After a longer pause it flies on from where it was instead of leaping.
inline constexpr double kLongestKiteStep_s = 0.05;

class KiteLoop final : public PeriodicTask {
  public:
    /// Takes settings that `validate` accepted and a rate in hertz above 0. The channels outlive the loop. Until the haptic
    /// loop has told of a hand nothing moves.
    KiteLoop(const KiteFlightSettings& settings, double rate_hz, KiteChannels& channels);
    KiteLoop(const KiteLoop&) = delete;
    KiteLoop& operator=(const KiteLoop&) = delete;
    ~KiteLoop() override;

    /// One round at `now_s` of the run's clock; a time that is not finite is none.
    void step(double now_s) noexcept override;
    /// Nothing pulls any more: the haptic loop is told so.
    void silence(double now_s) noexcept override;

    /// For the loop's own thread.
    [[nodiscard]] const KiteFlight& flight() const noexcept { return *flight_; }

  private:
    void launch() noexcept;
    void take_kite() noexcept;
    void take_hand() noexcept;
    void take_orders() noexcept;
    void turn_reel(double dt_s) noexcept;
    void fly(double dt_s) noexcept;
    void publish(double now_s) noexcept;

    KiteFlight* flight_;  // its own; raw, for nothing is freed in a step
    KiteChannels& channels_;
    double period_s_;
    KiteOrders orders_{};
    Vector3 hand_W_{Vector3::Zero()};      // where the line ends
    Vector3 hand_aim_W_{Vector3::Zero()};  // where the hand was last
    std::uint32_t n_launches_ = 0;
    bool has_orders_ = false;
    bool has_hand_ = false;
    bool started_ = false;
    double now_s_ = 0.0;
    KiteFrame frame_{};
};

}  // namespace fulcrum
