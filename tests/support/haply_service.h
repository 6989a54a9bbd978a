// A stand-in for Haply's service: HTTP and WebSocket at one port of the system's choosing, with a simulated arm and the hand that holds
// it behind them, so that walls can be felt. What it says: haply_answers.h.
//
// It sends the inventory first, then one state for each message, nothing by itself. A force stays until the next command or until its
// connection ends: for how long a real one goes on is not documented, so for ever. The hand trembles, as hands do.
#pragma once

#include "haptics/device/simulated/simulated_arm.h"
#include "tests/support/haply_answers.h"
#include "tests/support/loopback_listener.h"

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

namespace fulcrum::test_support {

/// Counted and measured since the start, or since `forget_peak`.
struct HaplyFelt {
    Vector3 force_D{Vector3::Zero()};  ///< that acts now, N
    Vector3 position_D{Vector3::Zero()};
    double peak_N = 0.0;
    std::uint64_t messages = 0;
    std::uint64_t pushes = 0;       ///< messages with a force, since the last `change`
    std::uint64_t full_states = 0;  ///< asked for
    std::uint64_t pongs = 0;
    std::uint64_t sessions = 0;  ///< begun
    bool has_session = false;
    bool was_unmasked = false;  ///< a client's frame, once
    bool said_goodbye = false;  ///< the last client that left
};

class HaplyService {
  public:
    /// Runs from here on. The arm's middle lies at `centre_A`.
    explicit HaplyService(HaplyOptions options = {}, const SimulatedArmSettings& arm = make_hand());
    HaplyService(const HaplyService&) = delete;
    HaplyService& operator=(const HaplyService&) = delete;
    ~HaplyService();

    /// An arm on a desk, as strong as Haply's, in a hand.
    [[nodiscard]] static SimulatedArmSettings make_hand();
    /// Where a handle stands in the document's first message, m.
    [[nodiscard]] static Vector3 centre_A() { return {0.0, -0.12, 0.15}; }

    [[nodiscard]] std::uint16_t port() const { return port_; }
    void change(const std::function<void(HaplyOptions&)>& by);
    /// Where the hand wants to be, from the middle, and how it turns the grip; it trembles about it by `tremble_m`.
    void move_hand(const Vector3& to_D, const Quaternion& turn_D = Quaternion::Identity(),
                   double tremble_m = 1.0e-4);
    [[nodiscard]] HaplyFelt felt();
    void forget_peak();
    /// Nobody listens from here on, until it is called again.
    void go_away(bool is_away);

  private:
    struct Guest;
    void serve();
    void look_after(std::vector<std::unique_ptr<Guest>>& guests);
    [[nodiscard]] bool attend(Guest& guest);
    [[nodiscard]] bool greet(Guest& guest);
    [[nodiscard]] bool answer(Guest& guest, const std::string& text);
    void note(const StandInOrder& order);
    void move_arm();

    std::mutex mutex_;  // of the next three
    HaplyOptions options_;
    HandTarget aim_{};
    HaplyFelt felt_{};
    double tremble_m_ = 1.0e-4;
    // The thread's.
    LatestValue<HandTarget> target_;
    SimulatedArm arm_;
    StandInState state_{};
    std::string last_;  // answer
    std::unique_ptr<LoopbackListener> door_ = std::make_unique<LoopbackListener>();
    std::uint16_t port_ = door_->port();
    std::atomic<bool> is_away_{false};
    std::atomic<bool> ends_{false};
    std::thread thread_;
};

}  // namespace fulcrum::test_support
