// Whether anybody has changed what stands between program and arm since it was opened: Haply Hub, and any program that speaks HTTP, can.
//
//   every kAskAgain_s   the next command asks for the whole state, and the scale of forces is asked for by HTTP
//   no whole state for kUnanswered_s: that counts as a change, for what is not seen cannot be vouched for
//
// Thread: the port's. Cost: nothing but once a second; none of it waits.
// Source: docs.haply.co/inverseSDK/service: session-configuration/sessions, api/http ("Session selector"), api/simulation.
#pragma once

#include "runtime/arms/haply/haply_message.h"
#include "runtime/arms/websocket/http_query.h"

namespace fulcrum::runtime {

class HaplyWatch {
  public:
    static constexpr double kAskAgain_s = 1.0;
    static constexpr double kUnanswered_s = 5.0;

    /// Of the arm as it was when it was opened. `scale_path` is where the service tells the scale; empty: nowhere.
    HaplyWatch(HaplyArm first, std::optional<double> force_scale, std::string_view scale_path,
               std::uint16_t port)
        : first_(std::move(first)),
          force_scale_(force_scale),
          scale_path_(scale_path),
          port_(port) {}

    /// A session begins at `now_s`, with an arm and a scale as it tells them.
    void begin(const HaplyArm& arm, std::optional<double> force_scale, double now_s);
    /// True once every kAskAgain_s: the next command is to ask for everything.
    [[nodiscard]] bool is_due(double now_s);
    /// What a state tells.
    void note(const HaplyArm& arm, double now_s);
    /// Goes on with the question for the scale.
    void step();
    /// What has changed, by name ("the basis"); empty while nothing has. It stays.
    [[nodiscard]] const std::string& change() const noexcept { return change_; }

  private:
    void find(const std::string& change);
    void compare(std::optional<double> force_scale);

    HaplyArm first_;
    std::optional<double> force_scale_;
    std::string scale_path_;
    std::uint16_t port_;
    double asked_s_ = 0.0;
    double answered_s_ = 0.0;
    HttpQuery query_;
    std::string change_;
};

}  // namespace fulcrum::runtime
