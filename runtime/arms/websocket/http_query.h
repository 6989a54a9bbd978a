// A question by HTTP to a service at this computer, step by step, so that a thread that must not wait can ask.
//
// Thread: its owner's. Cost: a few system calls a step; none waits.
#pragma once

#include "haptics/base/error.h"
#include "runtime/arms/websocket/http.h"
#include "runtime/arms/websocket/loopback_socket.h"

namespace fulcrum::runtime {

struct HttpAnswer {
    int status = 0;
    std::string body;
};

class HttpQuery {
  public:
    enum class State : std::uint8_t { idle, waits, done, failed };

    /// Asks anew, from here until the deadline (seconds of the monotonic clock); what was asked before is forgotten.
    void begin(std::string_view path, std::uint16_t port, double deadline_s);
    /// Goes on with it as far as it goes without waiting. Done and failed stay until the next `begin`.
    State step();
    [[nodiscard]] State state() const noexcept { return state_; }
    /// Of one that is done.
    [[nodiscard]] HttpAnswer answer() const { return {reader_.status(), reader_.body()}; }

  private:
    friend Expected<HttpAnswer> ask_http(std::string_view, std::uint16_t, double);
    State go_on(double until_s);

    LoopbackSocket line_;
    std::string unsent_;
    HttpReader reader_;
    double deadline_s_ = 0.0;
    State state_ = State::idle;
};

/// The same, waiting until the deadline. Refuses where nobody answers by then.
[[nodiscard]] Expected<HttpAnswer> ask_http(std::string_view path, std::uint16_t port,
                                            double deadline_s);

}  // namespace fulcrum::runtime
