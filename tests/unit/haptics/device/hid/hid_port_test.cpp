#include "haptics/device/hid/hid_port.h"

#include "haptics/base/clock.h"
#include "tests/support/eventually.h"
#include "tests/support/virtual_hid.h"

#include <catch2/catch.hpp>

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <thread>

using namespace fulcrum;
using namespace fulcrum::hid;
using namespace fulcrum::test_support;

namespace {

struct Rig {
    explicit Rig(bool with_force) {
        node = with_force
                   ? make_hid_node("/dev/hidraw7", force_stick_descriptor(shape), 1, 2, "Stick")
                   : make_hid_node("/dev/hidraw7", space_mouse_descriptor(false), 0x046d, 0xc626,
                                   "Cap");
        plug(node.path, with_force);
    }
    ~Rig() {
        if (port) {
            port->stop();
        }
    }
    void plug(const std::string& path, bool with_force) {
        HidNode here = node;
        here.path = path;
        bus->plug(here, with_force ? std::static_pointer_cast<VirtualHid>(stick)
                                   : std::make_shared<QuietHid>());
    }
    void start() {
        auto started = HidPort::start(bus, node, {});
        INFO((started ? std::string() : to_sentence(started.error())));
        REQUIRE(started);
        port = *started;
    }
    const HidSample& newest() {
        port->sample.take();
        return port->sample.value();
    }
    void push(double x, double y) { port->force.publish({monotonic_now_s(), x, y}); }
    // Until this is felt, while somebody keeps asking for a force.
    bool felt_while_pushed(double x, const std::function<bool(double)>& holds) {
        return eventually([&] {
            push(x, 0.0);
            return holds(stick->felt().right);
        });
    }

    ForceStickShape shape;
    std::shared_ptr<ForceStick> stick = std::make_shared<ForceStick>(shape);
    std::shared_ptr<MemoryBus> bus = std::make_shared<MemoryBus>();
    HidNode node;
    std::shared_ptr<HidPort> port;
};

}  // namespace

TEST_CASE("HID port: reports arrive, and the device is known to be there though it says nothing") {
    Rig rig(false);
    rig.start();
    rig.bus->report(rig.node.path, cap_report(1, {350, 0, 0}));
    CHECK(eventually([&] { return rig.newest().cap.push_D.x() == 1.0; }));
    const double before_s = rig.newest().stamp_s;
    CHECK(eventually([&] { return rig.newest().stamp_s > before_s + 0.02; }));
    CHECK(rig.newest().is_there);
    CHECK(rig.newest().cap.push_D.x() == 1.0);
    CHECK(rig.newest().reported_s < rig.newest().stamp_s);
}

TEST_CASE("HID port: garbage is counted and changes nothing") {
    Rig rig(false);
    rig.start();
    rig.bus->report(rig.node.path, cap_report(1, {70, 0, 0}));
    for (int i = 0; i < 200; ++i) {
        rig.bus->report(rig.node.path, Bytes(static_cast<std::size_t>(i) + 1, 0xFF));
    }
    CHECK(eventually([&] { return rig.port->counts().garbage >= 200; }));
    CHECK(rig.newest().cap.push_D == Vector3(0.2, 0.0, 0.0));
    CHECK(rig.newest().is_there);
    CHECK(rig.port->counts().reports == 1);
}

TEST_CASE("HID port: a force is felt, one that grows old fades, and nothing is left at the end") {
    Rig rig(true);
    rig.start();
    CHECK(rig.felt_while_pushed(0.5, [](double felt) { return felt > 0.49; }));
    // Nobody speaks any more, as when the haptic loop hangs.
    CHECK(eventually([&] { return rig.stick->felt().right == 0.0; }));
    CHECK(rig.port->takes_force());
    CHECK(rig.felt_while_pushed(-1.0, [](double felt) { return felt < -0.99; }));
    rig.port->stop();
    CHECK(rig.stick->felt().right == 0.0);
    CHECK(rig.stick->n_effects() == 0);
    CHECK(rig.bus->links(rig.node.path) == 0);
}

TEST_CASE(
    "HID port: unplugged it is told of and leaves; at another place it is found again and pushes "
    "again") {
    for (const bool with_force : {false, true}) {
        Rig rig(with_force);
        rig.start();
        CHECK(rig.port->take_notice().empty());
        if (!with_force) {
            rig.bus->report(rig.node.path, cap_report(1, {350, 0, 0}));
            CHECK(eventually([&] { return rig.newest().cap.push_D.x() == 1.0; }));
        }
        rig.bus->unplug(rig.node.path);
        CHECK(eventually([&] { return !rig.newest().is_there; }));
        CHECK(eventually([&] { return rig.port->counts().losses == 1; }));
        CHECK(eventually([&] {
            return rig.port->take_notice() ==
                   call(rig.node) + " has gone; plug it in again, and the lesson goes on with it.";
        }));
        CHECK(eventually([&] { return rig.port->takes_force() == !with_force; }));

        // Something else now stands where it was.
        rig.bus->plug(make_hid_node(rig.node.path, plain_stick_descriptor(), 8, 9, "Other"),
                      std::make_shared<QuietHid>());
        rig.plug("/dev/hidraw11", with_force);
        CHECK(eventually([&] { return rig.newest().is_there && rig.port->takes_force(); }));
        CHECK(eventually([&] { return rig.port->take_notice() == call(rig.node) + " is back."; }));
        CHECK(rig.bus->links(rig.node.path) == 0);
        // Where the cap was before it went means nothing now.
        CHECK(rig.newest().cap.push_D == Vector3::Zero());
        if (with_force) {
            CHECK(rig.felt_while_pushed(1.0, [](double felt) { return felt > 0.99; }));
        }
    }
}

TEST_CASE(
    "HID port: the same said after a pause, or before it was unplugged, is not said again and "
    "again") {
    Rig rig(false);
    rig.start();
    std::uint64_t said = 0;
    const auto say = [&](int n) {
        said += static_cast<std::uint64_t>(n);
        for (int i = 0; i < n; ++i) {
            rig.bus->report(rig.node.path, cap_report(1, {70, 0, 0}));
        }
        CHECK(eventually([&] { return rig.port->counts().reports == said; }));
        // What was counted is handed over a moment later.
        const double then_s = rig.newest().stamp_s;
        CHECK(eventually([&] { return rig.newest().stamp_s > then_s; }));
    };
    say(40);
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
    say(40);
    CHECK_FALSE(rig.newest().repeats_itself);
    CHECK(eventually([&] {
        say(60);
        return rig.newest().repeats_itself;
    }));
    rig.bus->unplug(rig.node.path);
    CHECK(eventually([&] { return !rig.newest().is_there; }));
    rig.plug(rig.node.path, false);
    CHECK(eventually([&] { return rig.newest().is_there; }));
    CHECK_FALSE(rig.newest().repeats_itself);
    // The first after that repeats nothing.
    say(50);
    CHECK_FALSE(rig.newest().repeats_itself);
}

TEST_CASE("HID port: another of the same kind, with another serial number, is not taken for it") {
    Rig rig(true);
    rig.node.serial = "one";
    rig.plug(rig.node.path, true);
    rig.start();
    rig.bus->unplug(rig.node.path);
    CHECK(eventually([&] { return rig.port->counts().losses == 1; }));
    HidNode other = rig.node;
    other.serial = "two";
    rig.bus->plug(other, std::make_shared<QuietHid>());
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    CHECK_FALSE(rig.newest().is_there);
    CHECK(rig.bus->links(rig.node.path) == 0);
    rig.plug("/dev/hidraw11", true);
    CHECK(eventually([&] { return rig.newest().is_there && rig.port->takes_force(); }));
    CHECK(rig.bus->links("/dev/hidraw11") == 2);
}

TEST_CASE("HID port: one that comes back with other reports is not taken") {
    Rig rig(true);
    rig.start();
    rig.bus->unplug(rig.node.path);
    CHECK(eventually([&] { return rig.port->counts().losses == 1; }));
    HidNode other = rig.node;
    other.descriptor = force_stick_descriptor({.first_report = 9});
    rig.bus->plug(other, rig.stick);
    CHECK(eventually([&] {
        return rig.port->take_notice() ==
               "/dev/hidraw7: Stick came back with other reports; begin the lesson again.";
    }));
    CHECK_FALSE(rig.newest().is_there);
}

TEST_CASE(
    "HID port: a device that stalls is told of, holds up its own thread alone, and ends its force "
    "by itself") {
    Rig rig(true);
    rig.start();
    CHECK(rig.felt_while_pushed(1.0, [](double felt) { return felt > 0.99; }));
    rig.bus->stall(rig.node.path, true);
    CHECK(eventually([&] {
        rig.push(0.5, 0.0);
        return rig.port->overdue_s(monotonic_now_s()) > 0.1;
    }));
    CHECK(eventually([&] { return rig.stick->felt().right == 0.0; }));
    // Poses go on.
    rig.bus->report(rig.node.path, stick_report(rig.shape, 511, 0, 0, 0));
    CHECK(eventually([&] { return rig.newest().stick.place.x() == 1.0; }));
    // So does whoever leaves.
    const double before_s = monotonic_now_s();
    rig.port->stop();
    CHECK(monotonic_now_s() - before_s < kFarewell_s + 2.0);
    rig.bus->stall(rig.node.path, false);
    CHECK(eventually([&] { return rig.stick->n_effects() == 0; }));
    CHECK(eventually([&] { return rig.bus->links(rig.node.path) == 0; }));
}

TEST_CASE(
    "HID port: a device that does not take its effects is refused at the start, in a sentence") {
    Rig rig(true);
    rig.stick->make_room(1);
    const auto refused = HidPort::start(rig.bus, rig.node, {});
    REQUIRE_FALSE(refused);
    CHECK(to_sentence(refused.error())
              .find("/dev/hidraw7: Stick does not answer: the device did not have room") == 0);
    CHECK(eventually([&] { return rig.bus->links(rig.node.path) == 0; }));
}
