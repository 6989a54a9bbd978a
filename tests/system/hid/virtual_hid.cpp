// virtual_hid cap|stick PATH.hid: a HID device at a socket (tests/support/hid_socket.h), led by words on standard input, one a line:
//
//   push X Y Z    a cap is pushed so far, -350 to 350, until it is pushed otherwise
//   stick X Y     a stick stands there, -512 to 511
//   yield X Y     a stick gives way by so many of these where its motors do all they can, to the right and away; below 0: against them
//   unplug, plug, garbage, stall, go_on
//   felt          answers with the largest force since the last time, parts of the full one: "felt 0.42"
//   still         answers when no force has been felt for half a second
#include "haptics/base/clock.h"
#include "tests/support/hid_socket.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <mutex>
#include <optional>
#include <sstream>
#include <string>
#include <thread>

using namespace fulcrum;
using namespace fulcrum::test_support;

namespace {

class Plug {
  public:
    Plug(bool is_cap, const std::string& path)
        : stick_(std::make_shared<ForceStick>(ForceStickShape{})),
          node_(is_cap ? make_hid_node(path, space_mouse_descriptor(false), 0x046d, 0xc626,
                                       "SpaceNavigator")
                       : make_hid_node(path, force_stick_descriptor({}), 0x1234, 0xbeef,
                                       "Force stick")) {
        is_cap_ = is_cap;
        held_ = is_cap ? cap_report(1, {0, 0, 0}) : stick_report({}, 0, 0, 128, 0);
    }

    void put(bool plugged) {
        const std::lock_guard lock(mutex_);
        socket_.reset();
        if (plugged) {
            socket_ = std::make_unique<HidSocket>(node_, stick_);
        }
    }
    void hold(const Bytes& report) {
        const std::lock_guard lock(mutex_);
        held_ = report;
    }
    void stand(int x, int y) {
        const std::lock_guard lock(mutex_);
        x_ = x;
        y_ = y;
        held_ = stick_report({}, x, y, 128, 0);
    }
    void yield(int right, int away) {
        const std::lock_guard lock(mutex_);
        yield_right_ = right;
        yield_away_ = away;
    }
    void stall(bool stalls) {
        const std::lock_guard lock(mutex_);
        if (socket_) {
            socket_->stall(stalls);
        }
    }
    // Says again what it holds, as devices do, and looks at its motors.
    void turn() {
        const std::lock_guard lock(mutex_);
        const ForceStick::Felt felt = stick_->felt();
        if (yields_right_or_away()) {
            held_ =
                stick_report({}, x_ + static_cast<int>(std::lround(yield_right_ * felt.right)),
                             y_ - static_cast<int>(std::lround(yield_away_ * felt.away)), 128, 0);
        }
        if (socket_) {
            socket_->report(held_);
        }
        const double force = std::hypot(felt.right, felt.away);
        most_ = std::max(most_, force);
        if (force > 0.0) {
            felt_s_ = monotonic_now_s();
        }
    }
    double take_most() {
        const std::lock_guard lock(mutex_);
        return std::exchange(most_, 0.0);
    }
    double still_s() {
        const std::lock_guard lock(mutex_);
        return monotonic_now_s() - felt_s_;
    }

  private:
    [[nodiscard]] bool yields_right_or_away() const {
        return !is_cap_ && (yield_right_ != 0 || yield_away_ != 0);
    }

    std::mutex mutex_;
    std::shared_ptr<ForceStick> stick_;
    hid::HidNode node_;
    std::unique_ptr<HidSocket> socket_;
    Bytes held_;
    bool is_cap_ = false;
    int x_ = 0;
    int y_ = 0;
    int yield_right_ = 0;
    int yield_away_ = 0;
    double most_ = 0.0;
    double felt_s_ = 0.0;
};

void obey(Plug& plug, const std::string& line) {
    std::istringstream words(line);
    std::string word;
    int x = 0;
    int y = 0;
    int z = 0;
    words >> word >> x >> y >> z;
    if (word == "push") {
        plug.hold(cap_report(1, {x, y, z}));
    } else if (word == "stick") {
        plug.stand(x, y);
    } else if (word == "yield") {
        plug.yield(x, y);
    } else if (word == "garbage") {
        plug.hold(Bytes(17, 0xA5));
    } else if (word == "unplug" || word == "plug") {
        plug.put(word == "plug");
    } else if (word == "stall" || word == "go_on") {
        plug.stall(word == "stall");
    } else if (word == "felt") {
        std::printf("felt %.3f\n", plug.take_most());
    } else if (word == "still") {
        while (plug.still_s() < 0.5) {
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        std::printf("still\n");
    }
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        return 2;
    }
    Plug plug(std::string(argv[1]) == "cap", argv[2]);
    plug.put(true);
    std::puts("plugged");
    std::fflush(stdout);
    std::jthread turns([&](const std::stop_token& stop) {
        while (!stop.stop_requested()) {
            plug.turn();
            std::this_thread::sleep_for(std::chrono::milliseconds(8));
        }
    });
    for (std::string line; std::getline(std::cin, line);) {
        obey(plug, line);
    }
    return 0;
}
