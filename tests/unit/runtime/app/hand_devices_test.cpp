#include "haptics/device/hid/hidapi/hidapi_bus.h"
#include "haptics/record/record_writer.h"
#include "runtime/app/device_list.h"
#include "runtime/app/hand_choice.h"
#include "runtime/app/hand_device.h"
#include "runtime/app/hid_hands.h"
#include "tests/support/virtual_hid.h"
#include "tests/unit/runtime/rig.h"

#include <nlohmann/json.hpp>

using namespace fulcrum::runtime::test;
using namespace fulcrum::test_support;

namespace {

LessonDescription lesson_of(std::size_t n_hands, bool needed = false) {
    LessonDescription lesson;
    for (std::size_t i = 1; i < n_hands; ++i) {
        lesson.more_hands.emplace_back();
        lesson.more_hands.back().needed = needed;
        lesson.more_hands.back().line = 6;
    }
    return lesson;
}

HandChoice moved_by(HandKind kind) {
    HandChoice choice;
    choice.hand = kind;
    return choice;
}

// What moves the second hand; none where it is not there.
HandKind settle_second(const LessonDescription& lesson, const HandsOrder& order,
                       std::vector<HandChoice> asked = {}) {
    const auto told = value_of(settle_hands(lesson, order, asked));
    CHECK(told.empty());
    return asked.empty() ? HandKind::none : asked.front().hand;
}

HapticPlan plan_with_workspace() {
    HapticPlan plan;
    plan.workspace.pose_WD = Pose::at({1.0, 2.0, 3.0});
    plan.workspace.scale = 2.0;
    return plan;
}

// Where the device has gone after `seconds` at 1 kHz.
DeviceReading play(Device& device, double seconds) {
    DeviceReading reading;
    for (int tick = 0; tick < static_cast<int>(seconds * 1000.0); ++tick) {
        REQUIRE(device.read(0.001 * tick, reading));
    }
    return reading;
}

hid::HidNode force_stick() {
    return make_hid_node("/dev/hidraw2", force_stick_descriptor({}), 0x45e, 0x1b, "Force stick");
}

}  // namespace

TEST_CASE("hand choice: a word says what moves a hand, and is said back") {
    for (const char* word : {"mouse", "keys", "none", "udp:desk:4701", "left.lua"}) {
        const auto choice = value_of(read_hand(word, true, "k"));
        CHECK(name_of(choice) == word);
    }
    CHECK(read_hand("udp:desk:4701", false, "k")->key_file == "k");
    CHECK(read_hand("keys", true, "")->hand == HandKind::keys);
    CHECK(
        to_sentence(read_hand("mouse", false, "").error()) ==
        "there is no mouse without a window; leave --hand out, give it a hand's file, or add --by "
        "mouse.");
    CHECK(to_sentence(read_hand("keys", false, "").error())
              .starts_with("there are no keys without a window"));
    CHECK(
        to_sentence(read_hand("foot", true, "").error()).starts_with("there is no hand \"foot\""));
    CHECK(to_sentence(read_hand("replay:none.rec", true, "").error())
              .starts_with("none.rec: there is no such record"));
}

TEST_CASE("hand choice: the first hand is always there, and a mouse moves one") {
    CHECK(check_shared(moved_by(HandKind::mouse), {moved_by(HandKind::keys)}));
    CHECK(check_shared(moved_by(HandKind::link), {moved_by(HandKind::link)}));
    CHECK_FALSE(check_shared(moved_by(HandKind::none), {}));
    CHECK_FALSE(check_shared(moved_by(HandKind::mouse), {moved_by(HandKind::mouse)}));
    CHECK_FALSE(check_shared(moved_by(HandKind::keys), {moved_by(HandKind::keys)}));
}

TEST_CASE("hand choice: at a desk the mouse moves the first hand without a device, keys the next") {
    const LessonDescription two = lesson_of(2);
    CHECK(settle_second(two, {moved_by(HandKind::mouse), HandsThere::desk}) == HandKind::keys);
    CHECK(settle_second(two, {moved_by(HandKind::hid), HandsThere::desk}) == HandKind::mouse);
    CHECK(settle_second(two, {moved_by(HandKind::mouse), HandsThere::desk},
                        {moved_by(HandKind::none)}) == HandKind::none);
    CHECK(settle_second(two, {moved_by(HandKind::mouse), HandsThere::desk},
                        {moved_by(HandKind::link)}) == HandKind::link);
    CHECK(settle_second(lesson_of(1), {moved_by(HandKind::mouse), HandsThere::desk}) ==
          HandKind::none);
}

TEST_CASE("hand choice: without a window a second hand is there where the test names one") {
    LessonDescription two = lesson_of(2);
    const HandChoice first = moved_by(HandKind::scripted);
    CHECK(settle_second(two, {first, HandsThere::simulated}) == HandKind::none);
    CHECK(settle_second(two, {first, HandsThere::all}) == HandKind::scripted);
    CHECK(settle_second(two, {first, HandsThere::nobody}) == HandKind::none);
    two.tests.emplace_back();
    two.tests[0].second_hand = "left.lua";
    CHECK(settle_second(two, {first, HandsThere::simulated}) == HandKind::scripted);
    CHECK(settle_second(two, {first, HandsThere::simulated, PlayedBy::mouse}) == HandKind::keys);
    CHECK(settle_second(two, {first, HandsThere::simulated, PlayedBy::keyboard}) == HandKind::none);
    CHECK(settle_second(two, {first, HandsThere::nobody}) == HandKind::none);
}

TEST_CASE("hand choice: what a lesson cannot use is left alone, what it needs is asked for") {
    std::vector<HandChoice> more{moved_by(HandKind::mouse), moved_by(HandKind::none)};
    const HandsOrder order{moved_by(HandKind::link), HandsThere::desk};
    const auto told = value_of(settle_hands(lesson_of(1), order, more));
    CHECK(more.empty());
    CHECK(told == std::vector<std::string>{
                      "This lesson uses one hand: mouse is left alone, without force."});
    more = {moved_by(HandKind::mouse), moved_by(HandKind::keys)};
    const auto third = value_of(settle_hands(lesson_of(2), order, more));
    CHECK(more.size() == 1);
    CHECK(third.at(0) == "This lesson uses two hands: keys is left alone, without force.");
    more = {moved_by(HandKind::none)};
    CHECK(refusal_of(settle_hands(lesson_of(2, true), order, more)) ==
          "lesson.lua:6: this lesson needs two hands at once, and one is there; give --hand twice, "
          "such as --hand hid --hand mouse, or two files of simulated hands.");
}

TEST_CASE("hand device: the simulated hand follows the lesson's target through the workspace") {
    const auto hand = value_of(HandDevice::open({}, plan_with_workspace()));
    CHECK(hand->device().traits().renders_force);
    hand->follow(Pose::at({1.2, 2.0, 3.0}), 1);
    const DeviceReading reading = play(hand->device(), 3.0);
    CHECK((reading.pose_D.position - Vector3(0.1, 0.0, 0.0)).norm() < 1e-4);
    CHECK(reading.buttons == 1);
    // A mouse that somebody moves meanwhile is not this hand's.
    hand->point_at({9.0, 9.0, 9.0}, 0);
    CHECK((play(hand->device(), 0.5).pose_D.position - Vector3(0.1, 0.0, 0.0)).norm() < 1e-3);
}

TEST_CASE("hand device: the mouse points, renders no force and yields to it on the screen") {
    RunRequest request;
    request.hand = HandKind::mouse;
    const auto hand = value_of(HandDevice::open(request, plan_with_workspace()));
    CHECK_FALSE(hand->device().traits().renders_force);
    CHECK(hand->pointer_W().position == Vector3(1.0, 2.0, 3.0));
    hand->point_at({1.0, 2.4, 3.0}, 2);
    CHECK(hand->pointer_W().position == Vector3(1.0, 2.4, 3.0));
    const Vector3 free_D = play(hand->device(), 2.0).pose_D.position;
    CHECK((free_D - Vector3(0.0, 0.2, 0.0)).norm() < 1e-4);
    REQUIRE(hand->device().write(2.0, Wrench{Vector3(0.0, -5.0, 0.0), Vector3::Zero()}));
    CHECK(play(hand->device(), 2.0).pose_D.position.y() < free_D.y() - 0.01);
}

TEST_CASE("hand device: a record plays again, and one that is none is refused in a sentence") {
    const ScratchFolder folder;
    RunRequest request;
    request.hand = HandKind::replay;
    request.hand_file = folder.file("run.rec");
    CHECK_FALSE(HandDevice::open(request, plan_with_workspace()));
    {
        auto writer = value_of(RecordWriter::create(request.hand_file.string(), RecordHeader{}));
        RecordRound round;
        round.sample.pose_D.position = {0.01, 0.02, 0.03};
        REQUIRE(writer.append(round));
        REQUIRE(writer.finish());
    }
    const auto hand = value_of(HandDevice::open(request, plan_with_workspace()));
    DeviceReading reading;
    REQUIRE(hand->device().read(0.0, reading));
    CHECK((reading.pose_D.position - Vector3(0.01, 0.02, 0.03)).norm() < 1e-12);
}

TEST_CASE("hand device: its limit is known before it is opened, and is what the opened one has") {
    const auto hand = HandDevice::open({}, plan_with_workspace());
    REQUIRE(hand);
    CHECK(HandDevice::force_limit_N({}) == (*hand)->device().traits().max_force_N);
    RunRequest request;
    for (const HandKind unlimited : {HandKind::mouse, HandKind::replay, HandKind::hid}) {
        request.hand = unlimited;
        CHECK(HandDevice::force_limit_N(request) > 1e9);
    }
    request.hid.has_force = true;
    CHECK(HandDevice::force_limit_N(request) == hid::HidHandSettings{}.full_force_N);
}

TEST_CASE("HID hands: hid and hid:PATH ask for one, nothing else does") {
    CHECK(asks_for_hid("hid"));
    CHECK(asks_for_hid("hid:/dev/hidraw3"));
    CHECK_FALSE(asks_for_hid("hidden.lua"));
    CHECK_FALSE(asks_for_hid("mouse"));
    CHECK_FALSE(asks_for_hid(""));
}

TEST_CASE("HID hands: what is not there is told") {
    CHECK(refusal_of(choose_hid_hand("hid:")) ==
          "--hand hid: names no device; give --hand hid, or hid: and a path that fulcrum devices "
          "lists.");
    const std::string nowhere = "/nowhere/hidraw0";
    CHECK(refusal_of(choose_hid_hand("hid:" + nowhere)) ==
          refusal_of(hid::make_hidapi_bus()->look(nowhere)));
}

TEST_CASE("HID hands: settings are valid at every scale, and a cap reaches what the mouse does") {
    for (double scale = 0.01; scale <= 100.0; scale *= 1.3) {
        Workspace workspace;
        workspace.scale = scale;
        const hid::HidHandSettings settings = hid_settings(workspace);
        INFO("scale " << scale);
        CHECK(hid::validate(settings));
        if (scale >= 0.3 && scale <= 50.0) {
            CHECK(settings.rate.half_extent_m * scale == Approx(1.0));
            CHECK(settings.rate.max_speed_m_per_s * scale == Approx(0.5));
            CHECK(settings.cap_pointer.half_extent_D.x() * scale == Approx(1.0));
        }
    }
}

TEST_CASE("HID hands: a stick's sensor is watched by what its motors do, a SpaceMouse's is not") {
    const Vector3 reach_D = Vector3::Constant(0.15);
    DeviceTraits traits;
    traits.position_resolution_m = 0.0003;
    const SensorWatch cap = sensor_watch(traits, reach_D);
    CHECK(cap.life.moves_at_N == 0.0);
    CHECK(cap.life.trembles_within_s == 0.0);
    CHECK(cap.life.most_m_per_s2 == 0.0);
    traits.renders_force = true;
    const SensorWatch stick = sensor_watch(traits, reach_D);
    CHECK(validate(stick.life));
    CHECK(stick.life.moves_at_N > 0.0);
    CHECK(stick.life.moves_at_N < hid::HidHandSettings{}.full_force_N);
    // Its motors push to the right and up; the throttle has none.
    CHECK(stick.pushed_D == Vector3(1.0, 1.0, 0.0));
    CHECK(all_below(stick.stop_D, reach_D));
}

TEST_CASE("HID hands: a plan is held to what a stick's motors can do, where there are any") {
    HidChoice choice;
    CHECK(std::isinf(force_limit_N(choice)));
    choice.has_force = true;
    CHECK(force_limit_N(choice) == hid::HidHandSettings{}.full_force_N);
}

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
