// A Haply arm behind the stand-in service, held by a loop of its own at about a kilohertz.
#pragma once

#include "haptics/base/clock.h"
#include "runtime/arms/arm_device.h"
#include "runtime/arms/haply/haply_port.h"
#include "tests/support/eventually.h"
#include "tests/support/haply_service.h"

#include <atomic>
#include <functional>
#include <mutex>
#include <sstream>
#include <string>
#include <thread>

namespace fulcrum::runtime {

/// What the loop saw last.
struct RigSeen {
    DeviceReading reading{};
    bool is_there = false;
};

class HaplyRig {
  public:
    using Law = std::function<Vector3(const Vector3& position_D)>;

    explicit HaplyRig(test_support::HaplyOptions options = {}) : service_(std::move(options)) {
        settings_.port = service_.port();
        settings_.centre_A = test_support::HaplyService::centre_A();
    }
    HaplyRig(const HaplyRig&) = delete;
    HaplyRig& operator=(const HaplyRig&) = delete;
    ~HaplyRig() { stop_loop(); }

    [[nodiscard]] test_support::HaplyService& service() { return service_; }
    [[nodiscard]] HaplySettings& settings() { return settings_; }
    [[nodiscard]] ArmPort& port() { return device_->port(); }
    [[nodiscard]] ArmDevice& device() { return *device_; }

    /// Opens the arm and begins the loop, which gives the force of `law`. False where it is refused; `why` then tells.
    bool open(Law law) {
        auto port = open_haply(settings_);
        if (!port) {
            why = to_sentence(port.error());
            return false;
        }
        device_ = std::make_unique<ArmDevice>(std::move(*port));
        push(std::move(law));
        loop_ = std::thread([this] { run(); });
        return true;
    }
    void push(Law law) {
        const std::lock_guard lock(mutex_);
        law_ = std::move(law);
    }
    /// The loop hangs, or goes on.
    void hang_loop(bool hangs) { hangs_.store(hangs); }
    void stop_loop() {
        ends_.store(true);
        if (loop_.joinable()) {
            loop_.join();
        }
    }
    [[nodiscard]] RigSeen seen() {
        const std::lock_guard lock(mutex_);
        return seen_;
    }
    /// All that people were told so far, a line each.
    [[nodiscard]] const std::string& told() {
        if (const std::string notice = port().take_notice(); !notice.empty()) {
            told_ += notice + "\n";
        }
        return told_;
    }
    /// Less that the service was silent for a moment, which a busy machine may bring about.
    [[nodiscard]] std::string told_but_silence() {
        std::istringstream lines(told());
        std::string rest;
        for (std::string line; std::getline(lines, line);) {
            const bool is_of_silence = line.find("does not answer") != std::string::npos ||
                                       line.find("is back") != std::string::npos;
            rest += is_of_silence ? "" : line;
        }
        return rest;
    }
    [[nodiscard]] bool is_told(const std::string& words) {
        return test_support::eventually([&] { return told().find(words) != std::string::npos; });
    }
    /// The force at the handle comes to be this, within 0.1 N.
    [[nodiscard]] bool feels(const Vector3& force_D) {
        return test_support::eventually(
            [&] { return (service_.felt().force_D - force_D).norm() < 0.1; });
    }
    [[nodiscard]] bool feels_nothing() {
        return test_support::eventually([&] { return service_.felt().force_D == Vector3::Zero(); });
    }

    std::string why;

  private:
    void run() {
        while (!ends_.load()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            if (hangs_.load()) {
                continue;
            }
            const double now_s = monotonic_now_s();
            RigSeen now;
            now.is_there = device_->read(now_s, now.reading);
            const std::lock_guard lock(mutex_);
            const bool may_push = now.is_there && !any(now.reading.faults);
            const Vector3 force = may_push ? law_(now.reading.pose_D.position) : Vector3::Zero();
            (void)device_->write(now_s, {.force = force});
            seen_ = now;
        }
    }

    test_support::HaplyService service_;
    HaplySettings settings_;
    std::unique_ptr<ArmDevice> device_;
    std::string told_;
    std::mutex mutex_;  // of the next two
    Law law_;
    RigSeen seen_{};
    std::atomic<bool> hangs_{false};
    std::atomic<bool> ends_{false};
    std::thread loop_;
};

/// The same force everywhere.
[[nodiscard]] inline HaplyRig::Law always(const Vector3& force_D) {
    return [force_D](const Vector3&) { return force_D; };
}

}  // namespace fulcrum::runtime
