// The arm inside a library that stands in for a maker's: a simulated one that a simulated fingertip holds, in real time, with what a
// test tells it to do wrong and counts of what it was told.
//
// Thread: any; one lock. It is compiled into such libraries alone, so that each copy of one has an arm of its own.
#pragma once

#include "haptics/base/clock.h"
#include "haptics/device/simulated/simulated_arm.h"

#include <chrono>
#include <map>
#include <mutex>
#include <string>
#include <thread>

namespace fulcrum::test_support {

class HeldArm {
  public:
    HeldArm() : arm_(make_settings(), target_) { publish_target(); }

    /// What a test sets, by name; what nobody set is 0. "x", "y", "z": where the fingertip wants to be, frame D, metres.
    void set(const std::string& what, double value) {
        const std::scoped_lock lock(mutex_);
        values_[what] = value;
        publish_target();
    }
    [[nodiscard]] double get(const std::string& what) {
        const std::scoped_lock lock(mutex_);
        const auto found = values_.find(what);
        return found != values_.end() ? found->second : 0.0;
    }
    void count(const std::string& what) {
        const std::scoped_lock lock(mutex_);
        values_[what] += 1.0;
    }

    /// Where the handle is, frame D; the arm goes on to now.
    [[nodiscard]] Vector3 read() {
        const std::scoped_lock lock(mutex_);
        DeviceReading reading;
        (void)arm_.read(monotonic_now_s(), reading);
        values_["at x"] = reading.pose_D.position.x();
        values_["at y"] = reading.pose_D.position.y();
        values_["at z"] = reading.pose_D.position.z();
        return reading.pose_D.position;
    }
    /// What the motors give from now on, frame D. "pushes": how often that was something.
    void feel(const Vector3& force_D) {
        const std::scoped_lock lock(mutex_);
        (void)arm_.write(monotonic_now_s(), {.force = force_D});
        values_["force x"] = force_D.x();
        values_["force y"] = force_D.y();
        values_["force z"] = force_D.z();
        values_["pushes"] += force_D != Vector3::Zero() ? 1.0 : 0.0;
        values_["orders"] += 1.0;
    }
    /// As long as a test set under this name, once; whatever else is asked meanwhile is answered.
    void hang(const std::string& what) {
        double seconds = 0.0;
        {
            const std::scoped_lock lock(mutex_);
            seconds = std::exchange(values_[what], 0.0);
        }
        if (seconds > 0.0) {
            std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
        }
    }

  private:
    static SimulatedArmSettings make_settings() {
        SimulatedArmSettings settings;
        settings.damping_Ns_per_m = 2.0;
        settings.human = kFingertip;
        return settings;
    }
    void publish_target() {
        HandTarget target;
        target.pose_D.position = {values_["x"], values_["y"], values_["z"]};
        target_.publish(target);
    }

    std::mutex mutex_;
    std::map<std::string, double> values_;
    LatestValue<HandTarget> target_;
    SimulatedArm arm_;
};

}  // namespace fulcrum::test_support
