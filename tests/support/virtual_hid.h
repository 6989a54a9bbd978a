// HID devices that are not there: what a device does with the bytes it is sent, and a bus of them in memory.
#pragma once

#include "haptics/device/hid/hid_link.h"
#include "tests/support/hid_descriptors.h"

#include <condition_variable>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <vector>

namespace fulcrum::test_support {

/// The device's side. All of it under one lock: tests look while threads write.
class VirtualHid {
  public:
    VirtualHid() = default;
    VirtualHid(const VirtualHid&) = delete;
    VirtualHid& operator=(const VirtualHid&) = delete;
    virtual ~VirtualHid() = default;

    /// False when the device refuses.
    virtual bool take_output(const Bytes& report) = 0;
    virtual bool take_feature(const Bytes& report) = 0;
    virtual Bytes give_feature(std::uint8_t number) = 0;
};

/// A device that only reports.
class QuietHid final : public VirtualHid {
  public:
    bool take_output(const Bytes&) override { return false; }
    bool take_feature(const Bytes&) override { return false; }
    Bytes give_feature(std::uint8_t) override { return {}; }
};

/// A force-feedback joystick of `force_stick_descriptor`: keeps effects as PID says and renders what they add up to.
class ForceStick final : public VirtualHid {
  public:
    explicit ForceStick(const ForceStickShape& shape) : shape_(shape) {}

    bool take_output(const Bytes& report) override;
    bool take_feature(const Bytes& report) override;
    Bytes give_feature(std::uint8_t number) override;

    struct Felt {
        double right = 0.0;  ///< shares of the full force
        double away = 0.0;
    };
    /// What a hand on the stick feels now.
    [[nodiscard]] Felt felt() const;
    [[nodiscard]] std::size_t n_effects() const;
    /// How many more effects it makes before it says that it is full; -1: any number.
    void make_room(int n);
    /// The next `n` questions for Block Load are answered with nothing.
    void be_slow(int n);
    [[nodiscard]] double device_gain() const;
    [[nodiscard]] int orders() const;  ///< output and feature reports that it took
    void press_trigger();              ///< what a bound trigger button would set off, is set off

  private:
    struct Effect {
        int kind = 0;
        double duration_s = 0.0;
        int trigger = 0;
        bool enable_x = false;
        bool enable_y = false;
        bool by_direction = false;
        double bearing_deg = 0.0;
        double gain = 0.0;
        double magnitude = 0.0;
        double until_s = -1.0;  // plays until then
    };

    bool take(const Bytes& report, bool is_feature);
    void set_effect(const Bytes& report);
    bool operate(const Bytes& report);
    bool control(int what);
    bool create(int kind);

    mutable std::mutex mutex_;
    ForceStickShape shape_;
    std::map<int, Effect> effects_;
    std::optional<int> loaded_;
    bool full_ = false;
    int room_ = -1;
    int slow_ = 0;
    int orders_ = 0;
    bool actuators_ = false;
    double gain_ = 0.0;
};

/// Devices in memory, which come and go, and stall.
class MemoryBus final : public hid::HidBus {
  public:
    /// Makes a device stand at `node.path`.
    void plug(const hid::HidNode& node, std::shared_ptr<VirtualHid> device);
    /// Takes it away; who waits for it is told.
    void unplug(const std::string& path);
    /// An input report, to each link.
    void report(const std::string& path, const Bytes& report);
    /// While true, writes to it do not come to an end.
    void stall(const std::string& path, bool stalls);
    /// How many links to it are open.
    [[nodiscard]] int links(const std::string& path) const;

    std::vector<hid::HidNode> list() override;
    Expected<hid::HidNode> look(const std::string& path) override;
    Expected<std::unique_ptr<hid::HidLink>> open(const std::string& path) override;

    struct Seat;  ///< one plugged device

  private:
    mutable std::mutex mutex_;
    std::map<std::string, std::shared_ptr<Seat>> seats_;
};

/// A node of this kind, with everything that a bus would tell.
[[nodiscard]] hid::HidNode make_hid_node(const std::string& path, const Bytes& descriptor,
                                         std::uint16_t vendor, std::uint16_t product,
                                         const std::string& name);

/// Report 1 of a SpaceMouse, x y z (and the turns where `one_report`), as its cap gives them.
[[nodiscard]] Bytes cap_report(std::uint8_t number, std::initializer_list<int> values);
/// The input report of `force_stick_descriptor`.
[[nodiscard]] Bytes stick_report(const ForceStickShape& shape, int x, int y, int throttle,
                                 int buttons);

}  // namespace fulcrum::test_support
