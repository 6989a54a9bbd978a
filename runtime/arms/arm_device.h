// A maker's arm as the device that a loop reads and writes.
//
// Thread: `read` and `write` by the loop; made and destroyed by who serves the arm. Cost: two hand-overs.
#pragma once

#include "runtime/arms/arm_port.h"

#include <limits>
#include <memory>

namespace fulcrum::runtime {

class ArmDevice final : public Device {
  public:
    explicit ArmDevice(std::unique_ptr<ArmPort> port) : port_(std::move(port)) {}
    ~ArmDevice() override { port_->stop(); }

    [[nodiscard]] const DeviceTraits& traits() const noexcept override { return port_->traits(); }
    /// False while the arm is not there. The stamp is on the clock of `now_s`.
    [[nodiscard]] bool read(double now_s, DeviceReading& reading) noexcept override;
    /// False while the arm is not there: then nothing is felt.
    [[nodiscard]] bool write(double now_s, const Wrench& wrench_D) noexcept override;

    [[nodiscard]] ArmPort& port() noexcept { return *port_; }

  private:
    std::unique_ptr<ArmPort> port_;
    // The loop's clock before the machine's: the most that was seen, for a round begins before it reads.
    double clock_ahead_s_ = -std::numeric_limits<double>::infinity();
    double read_s_ = -std::numeric_limits<double>::infinity();
};

}  // namespace fulcrum::runtime
