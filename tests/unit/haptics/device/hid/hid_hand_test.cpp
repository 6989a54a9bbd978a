#include "haptics/device/hid/hid_hand.h"

#include "haptics/base/clock.h"
#include "tests/support/eventually.h"
#include "tests/support/virtual_hid.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <thread>
#include <vector>

using namespace fulcrum;
using namespace fulcrum::hid;
using namespace fulcrum::test_support;

namespace {

constexpr const char* kPath = "/dev/hidraw5";

// A hand that is read a thousand times a second of its own time.
struct Rig {
    Rig(const HidNode& node, std::shared_ptr<VirtualHid> device, const HidHandSettings& settings) {
        bus->plug(node, std::move(device));
        auto opened = HidHand::open(bus, node, settings);
        INFO((opened ? std::string() : to_sentence(opened.error())));
        REQUIRE(opened);
        hand = std::move(*opened);
    }
    bool read() {
        now_s += 0.001;
        std::this_thread::sleep_for(std::chrono::microseconds(200));
        return hand->read(now_s, reading);
    }
    // For twice as long as a stick may be silent.
    void read_on() {
        const double until_s = monotonic_now_s() + 2.0 * HidHandSettings{}.stick_silence_s;
        while (monotonic_now_s() < until_s) {
            (void)read();
        }
    }
    // `n` reports, one a millisecond.
    template <class Report>
    void say(int n, const Report& report) {
        for (int i = 0; i < n; ++i) {
            bus->report(kPath, report(i));
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }
    std::shared_ptr<MemoryBus> bus = std::make_shared<MemoryBus>();
    std::unique_ptr<HidHand> hand;
    double now_s = 0.0;
    DeviceReading reading;
};

struct CapRig : Rig {
    explicit CapRig(const HidHandSettings& settings = {})
        : Rig(make_hid_node(kPath, space_mouse_descriptor(false), 0x046d, 0xc626, "Cap"),
              std::make_shared<QuietHid>(), settings) {}
};

struct StickRig : Rig {
    explicit StickRig(
        std::shared_ptr<ForceStick> made = std::make_shared<ForceStick>(ForceStickShape{}))
        : Rig(make_hid_node(kPath, force_stick_descriptor({}), 1, 2, "Stick"), made, {}),
          stick(std::move(made)) {}
    std::shared_ptr<ForceStick> stick;
};

// A bus whose links keep who reads from them waiting.
class HeldBus final : public HidBus {
  public:
    std::vector<HidNode> list() override { return memory.list(); }
    Expected<HidNode> look(const std::string& path) override { return memory.look(path); }
    Expected<std::unique_ptr<HidLink>> open(const std::string& path) override {
        return memory.open(path).map([&](auto&& link) {
            return std::unique_ptr<HidLink>(new HeldLink(std::move(link), holds));
        });
    }

    MemoryBus memory;
    std::atomic<bool> holds{false};

  private:
    class HeldLink final : public HidLink {
      public:
        HeldLink(std::unique_ptr<HidLink> link, const std::atomic<bool>& holds)
            : link_(std::move(link)), holds_(holds) {}
        int read(std::span<std::uint8_t> report, int timeout_ms) override {
            while (holds_.load()) {
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
            return link_->read(report, timeout_ms);
        }
        bool write(std::span<const std::uint8_t> report) override { return link_->write(report); }
        bool send_feature(std::span<const std::uint8_t> report) override {
            return link_->send_feature(report);
        }
        int get_feature(std::span<std::uint8_t> report) override {
            return link_->get_feature(report);
        }

      private:
        std::unique_ptr<HidLink> link_;
        const std::atomic<bool>& holds_;
    };
};

Wrench pushing(double x_N, double y_N) {
    Wrench wrench;
    wrench.force = Vector3(x_N, y_N, 0.0);
    return wrench;
}

}  // namespace

TEST_CASE("HID hand: a cap pushed moves the hand on and on, turned it turns, let go it stays") {
    CapRig rig;
    CHECK_FALSE(rig.hand->traits().renders_force);
    CHECK(rig.hand->traits().name == "Cap");
    CHECK(rig.hand->form() == HandForm::space_mouse);
    // A real one says it again and again while it is pushed.
    CHECK(eventually([&] {
        rig.bus->report(kPath, cap_report(1, {350, 0, 0}));
        rig.bus->report(kPath, cap_report(2, {0, 0, -350}));
        return rig.read() && rig.reading.pose_D.position.x() > 0.05;
    }));
    CHECK(rig.reading.pose_D.orientation.y() > 0.01);
    rig.bus->report(kPath, cap_report(1, {0, 0, 0}));
    rig.bus->report(kPath, cap_report(2, {0, 0, 0}));
    // The smoothing comes to rest.
    Vector3 before = Vector3::Zero();
    CHECK(eventually([&] {
        before = rig.reading.pose_D.position;
        return rig.read() && rig.reading.pose_D.position == before;
    }));
    CHECK(before.x() > 0.05);
    CHECK(before.y() == Approx(0.0).margin(1e-12));
}

TEST_CASE("HID hand: a cap that falls silent is as one let go, and buttons are told") {
    HidHandSettings settings;
    settings.cap_silence_s = 0.05;
    CapRig rig(settings);
    rig.bus->report(kPath, cap_report(1, {350, 0, 0}));
    CHECK(eventually([&] { return rig.read() && rig.reading.pose_D.position.x() > 1e-4; }));
    Vector3 before = Vector3::Zero();
    CHECK(eventually([&] {
        before = rig.reading.pose_D.position;
        return rig.read() && rig.reading.pose_D.position == before;
    }));
    CHECK(before.x() < 0.19);
    rig = CapRig();
    rig.bus->report(kPath, Bytes{3, 2, 0});
    CHECK(eventually([&] { return rig.read() && rig.reading.buttons == 2; }));
}

TEST_CASE("HID hand: a hand that feels nothing sees that a weight pulls it down") {
    HidHandSettings settings;
    settings.cap_pointer.sag_m_per_N = 0.004;
    CapRig rig(settings);
    CHECK(eventually([&] { return rig.read(); }));
    CHECK(eventually([&] {
        CHECK(rig.hand->write(rig.now_s, pushing(0.0, -2.0)));
        return rig.read() && rig.reading.pose_D.position.y() < -0.0079;
    }));
}

TEST_CASE("HID hand: a stick's place is the hand's, never faster than a hand") {
    StickRig rig;
    CHECK(rig.hand->traits().renders_force);
    CHECK(rig.hand->traits().max_force_N == HidHandSettings{}.full_force_N);
    const double reach_m = HidHandSettings{}.stick_pointer.half_extent_D.x();
    CHECK(rig.hand->traits().position_resolution_m == Approx(2.0 * reach_m / 1023.0));
    rig.bus->report(kPath, stick_report({}, -512, -512, 0, 4));
    CHECK(eventually([&] { return rig.read() && rig.reading.buttons == 4; }));
    rig.bus->report(kPath, stick_report({}, 511, 511, 255, 0));
    Vector3 before = rig.reading.pose_D.position;
    CHECK(eventually([&] {
        CHECK(rig.read());
        const double speed_m_per_s = (rig.reading.pose_D.position - before).norm() / 0.001;
        CHECK(speed_m_per_s <= HidHandSettings{}.stick_pointer.max_speed_m_per_s * (1.0 + 1e-9));
        before = rig.reading.pose_D.position;
        return before.x() > 0.999 * reach_m && before.y() < -0.999 * reach_m;
    }));
}

TEST_CASE("HID hand: newtons become shares of what the motors can; unplugged there is no pose") {
    StickRig rig;
    const double full_N = rig.hand->traits().max_force_N;
    CHECK(eventually([&] {
        CHECK(rig.hand->write(rig.now_s, pushing(0.5 * full_N, -0.25 * full_N)));
        const ForceStick::Felt felt = rig.stick->felt();
        return std::abs(felt.right - 0.5) < 0.003 && std::abs(felt.away + 0.25) < 0.003;
    }));
    // What is no number is refused and is no force.
    CHECK_FALSE(rig.hand->write(rig.now_s, pushing(std::numeric_limits<double>::quiet_NaN(), 0.0)));
    CHECK(eventually([&] { return rig.stick->felt().right == 0.0; }));
    auto stick = std::make_shared<ForceStick>(ForceStickShape{});
    rig = StickRig(stick);
    CHECK(eventually([&] { return rig.read() && rig.hand->write(rig.now_s, pushing(1, 0)); }));
    rig.bus->unplug(kPath);
    CHECK(eventually([&] { return !rig.read() && !rig.hand->write(rig.now_s, pushing(1, 0)); }));
    CHECK(eventually([&] { return !rig.hand->take_notice().empty(); }));
    rig.bus->plug(make_hid_node(kPath, force_stick_descriptor({}), 1, 2, "Stick"), stick);
    CHECK(eventually([&] { return rig.read() && rig.hand->write(rig.now_s, pushing(1, 0)); }));
}

TEST_CASE(
    "HID hand: poses and stamps go on together, so that no velocity comes of when reports arrive") {
    CapRig rig;
    rig.now_s = 1000.0;
    double fastest_m_per_s = 0.0;
    Vector3 before = Vector3::Zero();
    CHECK(eventually([&] {
        rig.bus->report(kPath, cap_report(1, {350, 0, 0}));
        const double before_s = rig.reading.stamp_s;
        if (!rig.read()) {
            return false;
        }
        CHECK(rig.reading.stamp_s == rig.now_s);
        const double dt_s = rig.reading.stamp_s - before_s;
        fastest_m_per_s =
            std::max(fastest_m_per_s, (rig.reading.pose_D.position - before).norm() / dt_s);
        before = rig.reading.pose_D.position;
        return before.x() > 0.15;
    }));
    CHECK(fastest_m_per_s <= RateSettings{}.max_speed_m_per_s * 1.01);
}

TEST_CASE("HID hand: a reader that is held up counts as a device that has gone, until it goes on") {
    auto held = std::make_shared<HeldBus>();
    const HidNode node = make_hid_node(kPath, space_mouse_descriptor(false), 0x046d, 0xc626, "Cap");
    held->memory.plug(node, std::make_shared<QuietHid>());
    auto hand = HidHand::open(held, node, {});
    REQUIRE(hand);
    DeviceReading reading;
    const auto eventually_read = [&](bool wanted) {
        return eventually([&] { return (*hand)->read(0.0, reading) == wanted; });
    };
    CHECK(eventually_read(true));
    held->holds.store(true);
    CHECK(eventually_read(false));
    held->holds.store(false);
    CHECK(eventually_read(true));
}

TEST_CASE(
    "HID hand: a device that stalls is a fault within a moment, and the haptic thread never "
    "waits") {
    StickRig rig;
    CHECK(eventually([&] { return rig.hand->write(rig.now_s, pushing(1, 0)); }));
    rig.bus->stall(kPath, true);
    double x_N = 0.0;
    double longest_s = 0.0;
    CHECK(eventually([&] {
        x_N = 1.0 - x_N;
        const double before_s = monotonic_now_s();
        const bool taken = rig.hand->write(rig.now_s, pushing(x_N, 0.0));
        const bool is_read = rig.read();
        longest_s = std::max(longest_s, monotonic_now_s() - before_s);
        return !taken && is_read;
    }));
    CHECK(longest_s < 5.0);  // the machine's own pauses; a wait would have no end
    rig.hand.reset();
    rig.bus->stall(kPath, false);
}

TEST_CASE(
    "HID hand: a stick that repeats itself and falls silent gives no pose; one that speaks of "
    "changes alone may be silent") {
    StickRig rig;
    CHECK(eventually([&] { return rig.read(); }));
    // No two reports alike, then none for twice as long as would be a fault.
    rig.say(200, [](int i) { return stick_report({}, i % 2, i, 0, 0); });
    rig.read_on();
    CHECK(eventually([&] { return rig.read(); }));
    // The same again and again, then nothing; and it speaks again.
    const auto same = [](int) { return stick_report({}, 20, 30, 0, 0); };
    for (int round = 0; round < 2; ++round) {
        CHECK(eventually([&] {
            rig.say(100, same);
            rig.read_on();
            return !rig.read();
        }));
        CHECK(eventually([&] {
            rig.say(1, same);
            return rig.read();
        }));
    }
}

TEST_CASE("HID hand: what has no motors may repeat itself and fall silent, and keeps its place") {
    CapRig rig;
    CHECK(eventually([&] {
        rig.say(100, [](int) { return cap_report(1, {0, 0, 0}); });
        return rig.read();
    }));
    rig.read_on();
    CHECK(eventually([&] { return rig.read(); }));
}
