#include "haptics/device/hid/hid_ability.h"

#include "tests/support/virtual_hid.h"

#include <catch2/catch.hpp>

#include <memory>
#include <string>

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

}  // namespace

TEST_CASE("HID ability: what each kind can do") {
    const HidAbility cap = find_ability(space_mouse("a"));
    CHECK(cap.form == HandForm::space_mouse);
    CHECK(cap.n_axes == 6);
    CHECK(cap.n_buttons == 2);
    CHECK(cap.n_force_axes == 0);
    CHECK(cap.full_cap == 350.0);
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

TEST_CASE("HID ability: a receiver of a SpaceMouse has interfaces that are none") {
    HidNode other = keyboard("a");
    other.vendor = 0x256f;
    other.product = 0xc652;
    CHECK(find_ability(other).form == HandForm::none);
    // A multi-axis controller of an unknown maker may mean anything by its numbers.
    HidNode unknown = space_mouse("a");
    unknown.vendor = 0x9999;
    CHECK(find_ability(unknown).form == HandForm::none);
}

TEST_CASE("HID ability: a force that cannot be used is told of, and the stick works without it") {
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
}

TEST_CASE("HID ability: a descriptor that is wrong or hidden is told of") {
    const HidAbility wrong = find_ability(make_hid_node("a", {0xC0}, 1, 2, "Broken"));
    CHECK(wrong.form == HandForm::none);
    CHECK(wrong.missing.find("byte 0: the report descriptor is wrong") == 0);
    const HidAbility hidden = find_ability(make_hid_node("a", {}, 1, 2, "Hidden"));
    CHECK(hidden.missing == "its report descriptor cannot be read");
    // What is known by its numbers is known all the same.
    CHECK(find_ability(make_hid_node("a", {}, 0x046d, 0xc626, "")).form == HandForm::space_mouse);
}

TEST_CASE("HID ability: the best that may be opened is chosen") {
    MemoryBus bus;
    plug(bus, keyboard("/dev/hidraw0"));
    const auto none = choose_hand(bus, "");
    REQUIRE_FALSE(none);
    CHECK(to_sentence(none.error()) ==
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
    const auto keys = choose_hand(bus, "/dev/hidraw0");
    REQUIRE_FALSE(keys);
    CHECK(to_sentence(keys.error()) ==
          "/dev/hidraw0: Keyboard is no hand; fulcrum devices lists what can be used.");
}

TEST_CASE("HID ability: without permission the sentence names the rule and its place") {
    MemoryBus bus;
    HidNode closed = space_mouse("/dev/hidraw4");
    closed.may_open = false;
    plug(bus, closed);
    for (const char* const path : {"", "/dev/hidraw4"}) {
        const auto refused = choose_hand(bus, path);
        REQUIRE_FALSE(refused);
        CHECK(to_sentence(refused.error()) ==
              "/dev/hidraw4: SpaceNavigator is there, but this user may not open it; add the line "
              "KERNEL==\"hidraw*\", KERNELS==\"*:046D:C626.*\", "
              "TAG+=\"uaccess\" to /etc/udev/rules.d/70-fulcrum.rules, then unplug it and plug it "
              "in again.");
    }
    // What may be opened goes before what is better and may not.
    plug(bus, plain_stick("/dev/hidraw5"));
    CHECK(choose_hand(bus, "")->path == "/dev/hidraw5");
}

TEST_CASE("HID ability: without a name it is called by its numbers") {
    CHECK(call(make_hid_node("a", {}, 0x46d, 0xc626, "")) == "the device 046d:c626");
    CHECK(call(make_hid_node("a", {}, 1, 2, "Stick")) == "Stick");
}
