#include "haptics/base/clock.h"
#include "haptics/device/hid/hid_ability.h"
#include "haptics/device/hid/hid_port.h"
#include "tests/support/eventually.h"
#include "tests/support/told.h"
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

HidNode space_mouse(const std::string& path) {
    return make_hid_node(path, space_mouse_descriptor(false), 0x046d, 0xc626, "SpaceNavigator");
}
HidNode force_stick(const std::string& path) {
    return make_hid_node(path, force_stick_descriptor({}), 0x1234, 0xbeef, "Force stick");
}
HidNode plain_stick(const std::string& path) {
    return make_hid_node(path, plain_stick_descriptor(), 1, 2, "Stick");
}
HidNode keyboard(const std::string& path) {
    DescriptorBuilder d;
    d.page(1).usage(6).open(1).page(7).usages(0, 255).logical(0, 255).fields(8, 6).input(0);
    return make_hid_node(path, d.close().bytes(), 3, 4, "Keyboard");
}

void plug(MemoryBus& bus, const HidNode& node) {
    bus.plug(node, std::make_shared<QuietHid>());
}

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

TEST_CASE("HID ability: what each kind can do") {
    const HidAbility cap = find_ability(space_mouse("a"));
    CHECK(cap.form == HandForm::space_mouse);
    CHECK(cap.n_axes == 6);
    CHECK(cap.n_buttons == 2);
    CHECK(cap.n_force_axes == 0);
    CHECK(cap.cap);
    CHECK(cap.missing.empty());

    const HidAbility force = find_ability(force_stick("a"));
    CHECK(force.form == HandForm::stick);
    CHECK(force.n_axes == 3);
    CHECK(force.n_buttons == 8);
    CHECK(force.n_force_axes == 2);
    CHECK(force.force);

    const HidAbility plain = find_ability(plain_stick("a"));
    CHECK(plain.form == HandForm::stick);
    CHECK(plain.n_force_axes == 0);
    CHECK(plain.missing.empty());

    CHECK(find_ability(keyboard("a")).form == HandForm::none);
    CHECK(find_ability(keyboard("a")).missing.empty());
}

TEST_CASE("HID ability: interfaces that are none, forces and descriptors of no use are told of") {
    HidNode other = keyboard("a");
    other.vendor = 0x256f;
    other.product = 0xc652;
    CHECK(find_ability(other).form == HandForm::none);
    // A multi-axis controller of an unknown maker says as well what its numbers mean.
    HidNode unknown = space_mouse("a");
    unknown.vendor = 0x9999;
    CHECK(find_ability(unknown).form == HandForm::space_mouse);
    const HidAbility half = find_ability(
        make_hid_node("a", DescriptorBuilder().page(1).usage(8).open(1).close().bytes(), 1, 2, ""));
    CHECK(half.form == HandForm::none);
    CHECK(half.missing == "it calls itself a Multi-axis Controller, and does not tell X, Y and Z");
    Bytes broken = force_stick_descriptor({});
    for (std::size_t i = 0; i + 1 < broken.size(); ++i) {
        if (broken[i] == 0x09 && broken[i + 1] == 0x50) {
            broken[i + 1] = 0xEE;
        }
    }
    const HidAbility ability = find_ability(make_hid_node("a", broken, 1, 2, "Stick"));
    CHECK(ability.form == HandForm::stick);
    CHECK(ability.n_force_axes == 0);
    CHECK(ability.missing.find("its force cannot be used") == 0);
    const HidAbility wrong = find_ability(make_hid_node("a", {0xC0}, 1, 2, "Broken"));
    CHECK(wrong.form == HandForm::none);
    CHECK(wrong.missing.find("byte 0: the report descriptor is wrong") == 0);
    const HidAbility hidden = find_ability(make_hid_node("a", {}, 1, 2, "Hidden"));
    CHECK(hidden.missing == "its report descriptor cannot be read");
}

TEST_CASE("HID ability: the best that may be opened is chosen") {
    MemoryBus bus;
    plug(bus, keyboard("/dev/hidraw0"));
    CHECK(refusal_of(choose_hand(bus, "")) ==
          "no SpaceMouse and no joystick is plugged in; plug one in; fulcrum devices lists what "
          "is there.");
    plug(bus, plain_stick("/dev/hidraw1"));
    CHECK(choose_hand(bus, "")->path == "/dev/hidraw1");
    plug(bus, space_mouse("/dev/hidraw2"));
    CHECK(choose_hand(bus, "")->path == "/dev/hidraw2");
    plug(bus, force_stick("/dev/hidraw3"));
    CHECK(choose_hand(bus, "")->path == "/dev/hidraw3");
    CHECK(choose_hand(bus, "/dev/hidraw1")->path == "/dev/hidraw1");
    CHECK_FALSE(choose_hand(bus, "/dev/hidraw9"));
    CHECK(refusal_of(choose_hand(bus, "/dev/hidraw0")) ==
          "/dev/hidraw0: Keyboard is no hand; fulcrum devices lists what can be used.");
}

TEST_CASE("HID ability: without permission the rule is named, without a name the numbers are") {
    MemoryBus bus;
    HidNode closed = space_mouse("/dev/hidraw4");
    closed.may_open = false;
    plug(bus, closed);
    for (const char* const path : {"", "/dev/hidraw4"}) {
        CHECK(refusal_of(choose_hand(bus, path)) ==
              "/dev/hidraw4: SpaceNavigator is there, but this user may not open it; add the line "
              "KERNEL==\"hidraw*\", KERNELS==\"*:046D:C626.*\", "
              "TAG+=\"uaccess\" to /etc/udev/rules.d/70-fulcrum.rules, then unplug it and plug it "
              "in again.");
    }
    // What may be opened goes before what is better and may not.
    plug(bus, plain_stick("/dev/hidraw5"));
    CHECK(choose_hand(bus, "")->path == "/dev/hidraw5");
    CHECK(call(make_hid_node("a", {}, 0x46d, 0xc626, "")) == "the device 046d:c626");
    CHECK(call(make_hid_node("a", {}, 1, 2, "Stick")) == "Stick");
}

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

TEST_CASE("HID port: garbage changes nothing, a force is felt, fades when old, and ends") {
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
    rig = Rig(true);
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

TEST_CASE("HID port: neither another of the kind nor one with other reports is taken for it") {
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
    rig = Rig(true);
    rig.start();
    rig.bus->unplug(rig.node.path);
    CHECK(eventually([&] { return rig.port->counts().losses == 1; }));
    other = rig.node;
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
