// How much may be pushed while it is not sure that the service understands the word for a force, and whether it goes on to.
//
//   not proven   what is wanted, shortened to kTrial_N; where at least kAsked_N was sent and the state's echo is that force, about, it is
//                proven; after kMostStates states without it the other word is tried, once; then refused: nothing is pushed
//   proven       the limit grows from kTrial_N by kRise_N_per_s up to the arm's: the hand is not thrown by the proof itself
//   stuck        what was sent has changed by kMoved_N within kStuck_s, and the states are the same to the bit all along
// The echo may be of an order or two ago: any of the last kRemembered counts, where it has its direction and half to twice its length,
// for filters may stand between.
//
// Thread: the port's. Cost: nanoseconds; allocates nothing.
// Source: ours. That `current_cursor_force` tells the force: docs.haply.co/inverseSDK/service/realtime/websocket-protocol.
#pragma once

#include "haptics/math/spatial.h"
#include "runtime/arms/haply/haply_command.h"

#include <array>

namespace fulcrum::runtime {

class ForceProof {
  public:
    static constexpr double kTrial_N = 0.2;
    static constexpr double kAsked_N = 0.15;
    static constexpr int kMostStates = 300;  ///< 0.3 s at 1 kHz
    static constexpr double kRise_N_per_s = 12.0;
    static constexpr double kMoved_N = 0.5;
    static constexpr double kStuck_s = 0.03;
    static constexpr std::size_t kRemembered = 4;
    static constexpr int kMostMore = 30;  ///< states, 30 ms at 1 kHz

    enum class Verdict : unsigned char { open, proven, refused };

    /// `limit_N` is the most that is ever let through.
    ForceProof(ForceWord first, double limit_N) noexcept : word_(first), most_N_(limit_N) {}

    /// What of a force may be sent at `now_s`; zero for one that is not finite.
    [[nodiscard]] Vector3 allow(const Vector3& wanted_N, double now_s) noexcept;
    /// That has been sent.
    void note_sent(const Vector3& force_N, double now_s) noexcept;
    /// What a state tells.
    void note_state(const Vector3& position_m, const Vector3& velocity_m_per_s,
                    const Vector3& echo_N, double now_s) noexcept;

    [[nodiscard]] ForceWord word() const noexcept { return word_; }
    [[nodiscard]] Verdict verdict() const noexcept { return verdict_; }
    /// The states repeat though the force changes; until one is another.
    [[nodiscard]] bool is_stuck() const noexcept { return is_stuck_; }

    /// For kMostMore states more was given than is asked for here; until one says less.
    [[nodiscard]] bool is_pushed_more() const noexcept { return n_more_ >= kMostMore; }

  private:
    void note_more(const Vector3& echo_N) noexcept;
    [[nodiscard]] bool is_echo(const Vector3& echo_N) const noexcept;
    void judge(const Vector3& echo_N, double now_s) noexcept;
    void watch(const Vector3& position_m, const Vector3& velocity_m_per_s, const Vector3& echo_N,
               double now_s) noexcept;

    ForceWord word_;
    double most_N_;
    Verdict verdict_ = Verdict::open;
    bool has_switched_ = false;
    int n_waited_ = 0;  // states since enough was asked by this word
    double proven_s_ = 0.0;
    std::array<Vector3, kRemembered> sent_{Vector3::Zero(), Vector3::Zero(), Vector3::Zero(),
                                           Vector3::Zero()};
    std::size_t next_ = 0;
    int n_more_ = 0;
    // Stuck.
    bool has_state_ = false;
    bool is_stuck_ = false;
    Vector3 position_{Vector3::Zero()};
    Vector3 velocity_{Vector3::Zero()};
    Vector3 echo_{Vector3::Zero()};
    Vector3 sent_then_{Vector3::Zero()};  // when the state was first as it is
    double moved_s_ = -1.0;               // when what is sent first differed from that enough
};

}  // namespace fulcrum::runtime
