#include "runtime/app/device_list.h"

#include "tests/support/virtual_hid.h"
#include "tests/unit/runtime/rig.h"

#include <nlohmann/json.hpp>

using namespace fulcrum::runtime::test;
using namespace fulcrum::test_support;

namespace {

hid::HidNode force_stick() {
    return make_hid_node("/dev/hidraw2", force_stick_descriptor({}), 0x45e, 0x1b, "Force stick");
}

}  // namespace

TEST_CASE("device list: with nothing plugged in, the mouse and the simulated hand are there") {
    const auto entries = list_devices({}, true);
    CHECK(devices_text(entries) ==
          "mouse: 3 axes, 3 buttons, no force: it is shown and heard.  --hand mouse\n"
          "simulated hand: 6 axes, force along 6 axes.  --hand FILE.lua\n"
          "No SpaceMouse and no joystick is plugged in.\n");
    check_says(devices_text(list_devices({}, false)), {"    there is no display; start the program "
                                                       "where there is a screen.\n"});
}

TEST_CASE("device list: what each can do, and how to play with it") {
    const std::string text = devices_text(list_devices(
        {force_stick(), make_hid_node("/dev/hidraw3", plain_stick_descriptor(), 1, 2, ""),
         make_hid_node("/dev/hidraw4", space_mouse_descriptor(true), 0x256f, 0xc635, "SpaceMouse")},
        true));
    check_says(text,
               {"Force stick (045e:001b): 3 axes, 8 buttons, force along 2 axes.  --hand "
                "hid:/dev/hidraw2\n",
                "the device 0001:0002 (0001:0002): 3 axes, 4 buttons, no force",
                "SpaceMouse (256f:c635): 6 axes, 2 buttons, no force: it is shown and heard.  "
                "--hand hid:/dev/hidraw4\n"});
    check_lacks(text, {"No SpaceMouse"});
}

TEST_CASE("device list: without permission the line for udev and its place are told") {
    hid::HidNode closed = force_stick();
    closed.may_open = false;
    const auto entries = list_devices({closed}, true);
    REQUIRE(entries.size() == 3);
    CHECK_FALSE(entries[2].usable);
    CHECK(devices_text({entries[2]}) ==
          "Force stick (045e:001b): 3 axes, 8 buttons, force along 2 axes.\n"
          "    /dev/hidraw2: this user may not open it; add the line below to "
          "/etc/udev/rules.d/70-fulcrum.rules, then unplug it and plug it in again.\n"
          "    KERNEL==\"hidraw*\", KERNELS==\"*:045E:001B.*\", "
          "TAG+=\"uaccess\"\n");
}

TEST_CASE("device list: a keyboard is none, a broken device is told of with what is wrong") {
    DescriptorBuilder keys;
    keys.page(1).usage(6).open(1).close();
    const auto entries =
        list_devices({make_hid_node("/dev/hidraw0", keys.bytes(), 1, 1, "Keyboard"),
                      make_hid_node("/dev/hidraw1", {0xC0}, 1, 2, "Broken")},
                     true);
    REQUIRE(entries.size() == 3);
    CHECK(entries[2].name == "Broken");
    CHECK(entries[2].kind == "unknown");
    CHECK_FALSE(entries[2].usable);
    check_says(devices_text(entries), {"/dev/hidraw1: byte 0: the report descriptor is wrong"});
}

TEST_CASE("device list: programs read the same") {
    hid::HidNode closed = force_stick();
    closed.may_open = false;
    closed.name = "Quote \" and \xff";
    const auto json = nlohmann::json::parse(devices_json(list_devices({closed}, false)));
    CHECK(json["udev_file"] == "/etc/udev/rules.d/70-fulcrum.rules");
    REQUIRE(json["devices"].size() == 3);
    CHECK(json["devices"][0]["hand"] == "mouse");
    CHECK(json["devices"][0]["usable"] == false);
    const auto& stick = json["devices"][2];
    CHECK(stick["kind"] == "joystick");
    CHECK(stick["ids"] == "045e:001b");
    CHECK(stick["force_axes"] == 2);
    CHECK(stick["path"] == "/dev/hidraw2");
    check_says(stick["udev_rule"].get<std::string>(), {"KERNELS==\"*:045E:001B.*\""});
}
