// hidapi's own code, on devices that are sockets: see tests/support/hid_shim.
#include "haptics/device/hid/hidapi/hidapi_bus.h"

#include "haptics/base/clock.h"
#include "haptics/device/hid/hid_hand.h"
#include "tests/support/eventually.h"
#include "tests/support/hid_socket.h"
#include "tests/support/refused.h"
#include "tests/support/scratch_folder.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <optional>
#include <string>

using namespace fulcrum;
using namespace fulcrum::hid;
using namespace fulcrum::test_support;

namespace {

struct Desk {
    [[nodiscard]] std::string at(const std::string& name) const { return folder.file(name); }
    HidNode cap() const {
        return make_hid_node(at("cap.hid"), space_mouse_descriptor(true), 0x256f, 0xc635, "Cap");
    }
    HidNode force_stick() const {
        return make_hid_node(at("stick.hid"), force_stick_descriptor(shape), 1, 2, "Stick");
    }

    ScratchFolder folder;
    ForceStickShape shape{.first_report = 3, .magnitude = 1000};
    std::shared_ptr<ForceStick> stick = std::make_shared<ForceStick>(shape);
    std::shared_ptr<HidBus> bus = make_hidapi_bus();
};

}  // namespace

TEST_CASE("hidapi: what stands at a path is told as the kernel tells it") {
    const Desk desk;
    HidNode served = desk.cap();
    served.serial = "A1";
    const HidSocket socket(served, std::make_shared<QuietHid>());
    const auto node = desk.bus->look(served.path);
    REQUIRE(node);
    CHECK(node->vendor == 0x256f);
    CHECK(node->product == 0xc635);
    CHECK(node->name == "Cap");
    CHECK(node->serial == "A1");
    CHECK(node->descriptor == served.descriptor);
    CHECK(node->may_open);
}

TEST_CASE("hidapi: reports arrive, none within the time is none, and the device's end is told") {
    const Desk desk;
    std::optional<HidSocket> socket(std::in_place, desk.cap(), std::make_shared<QuietHid>());
    const auto link = desk.bus->open(desk.at("cap.hid"));
    REQUIRE(link);
    CHECK(eventually([&] { return socket->links() == 1; }));
    std::array<std::uint8_t, 64> report{};
    CHECK((*link)->read(report, 0) == 0);
    CHECK((*link)->read(report, 5) == 0);
    socket->report(cap_report(1, {1, 2, 3, 4, 5, 6}));
    CHECK((*link)->read(report, 1000) == 13);
    CHECK(report[0] == 1);
    CHECK(report[11] == 6);
    // Another who opens it gets the same reports.
    const auto second = desk.bus->open(desk.at("cap.hid"));
    REQUIRE(second);
    CHECK(eventually([&] { return socket->links() == 2; }));
    socket->report(Bytes{3, 1});
    CHECK((*link)->read(report, 1000) == 2);
    CHECK((*second)->read(report, 1000) == 2);
    socket.reset();
    CHECK((*link)->read(report, 1000) == -1);
    CHECK_FALSE((*link)->write(Bytes{0, 1}));
    CHECK_FALSE((*link)->send_feature(Bytes{0, 1}));
    CHECK((*link)->get_feature(report) == -1);
    CHECK_FALSE(desk.bus->look(desk.at("cap.hid")));
    CHECK_FALSE(desk.bus->open(desk.at("cap.hid")));
}

TEST_CASE("hidapi: feature reports go either way, and a refused one is told") {
    const Desk desk;
    const HidSocket socket(desk.force_stick(), desk.stick);
    const auto link = desk.bus->open(desk.at("stick.hid"));
    REQUIRE(link);
    const std::uint8_t create = 10;
    const std::uint8_t load = 11;
    CHECK((*link)->send_feature(Bytes{create, 1}));
    std::array<std::uint8_t, 5> answer{load};
    CHECK((*link)->get_feature(answer) == 5);
    CHECK(answer[1] == 1);
    CHECK(answer[2] == 1);
    CHECK_FALSE((*link)->send_feature(Bytes{99, 1}));
    std::array<std::uint8_t, 5> wrong{77};
    CHECK((*link)->get_feature(wrong) == -1);
}

TEST_CASE("hidapi: a joystick is opened, pushes, is pulled out and pushes again") {
    Desk desk;
    std::optional<HidSocket> socket(std::in_place, desk.force_stick(), desk.stick);
    const auto node = choose_hand(*desk.bus, desk.at("stick.hid"));
    REQUIRE(node);
    auto hand = HidHand::open(desk.bus, *node, {});
    INFO((hand ? std::string() : to_sentence(hand.error())));
    REQUIRE(hand);
    double now_s = 0.0;
    DeviceReading reading;
    Wrench wrench;
    wrench.force = Vector3(-0.5 * (*hand)->traits().max_force_N, 0.0, 0.0);
    const auto is_felt = [&] {
        now_s += 0.001;
        return (*hand)->read(now_s, reading) && (*hand)->write(now_s, wrench) &&
               std::abs(desk.stick->felt().right + 0.5) < 0.002;
    };
    CHECK(eventually(is_felt));
    socket->report(stick_report(desk.shape, 511, -512, 128, 2));
    CHECK(eventually([&] { return is_felt() && reading.pose_D.position.x() > 0.19; }));
    CHECK(reading.pose_D.position.y() > 0.19);
    CHECK(reading.buttons == 2);

    socket.reset();
    CHECK(eventually(
        [&] { return !(*hand)->read(now_s, reading) && !(*hand)->write(now_s, wrench); }));
    CHECK(eventually([&] { return desk.stick->felt().right == 0.0; }));
    socket.emplace(desk.force_stick(), desk.stick);
    CHECK(eventually(is_felt));
    hand->reset();
    CHECK(eventually([&] { return desk.stick->n_effects() == 0; }));
    CHECK(desk.stick->felt().right == 0.0);
}

TEST_CASE("hidapi: a joystick that stalls holds nobody up") {
    Desk desk;
    HidSocket socket(desk.force_stick(), desk.stick);
    auto hand = HidHand::open(desk.bus, *desk.bus->look(desk.at("stick.hid")), {});
    REQUIRE(hand);
    Wrench wrench;
    CHECK(eventually([&] { return (*hand)->write(0.0, wrench); }));
    socket.stall(true);
    double x_N = 0.0;
    CHECK(eventually([&] {
        x_N = x_N > 2.0 ? -2.0 : x_N + 0.01;
        wrench.force.x() = x_N;
        return !(*hand)->write(0.0, wrench);
    }));
    const double before_s = monotonic_now_s();
    hand->reset();
    CHECK(monotonic_now_s() - before_s < kFarewell_s + 2.0);
    // The thread that was held up comes to its end when the device goes.
}

TEST_CASE(
    "hidapi: what is no HID device, what is not there and what may not be opened is told in a "
    "sentence") {
    const Desk desk;
    std::ofstream(desk.at("file")) << "text";
    const auto text = desk.bus->look(desk.at("file"));
    REQUIRE_FALSE(text);
    CHECK(text.error().message == "this is no HID device");
    const auto opened = desk.bus->open(desk.at("file"));
    REQUIRE_FALSE(opened);
    CHECK(opened.error().message == "this is no HID device");
    CHECK(is_refused(desk.bus->look(desk.at("none.hid")), "No such file"));
    const auto nowhere = desk.bus->look("/nowhere/hidraw0");
    REQUIRE_FALSE(nowhere);
    CHECK(to_sentence(nowhere.error()) ==
          "/nowhere/hidraw0: there is no device to be opened: No such file or directory; fulcrum "
          "devices lists what is there.");

    const HidSocket socket(desk.cap(), std::make_shared<QuietHid>());
    setenv("FULCRUM_HID_FORBIDDEN", "cap.hid", 1);
    const auto closed = desk.bus->look(desk.at("cap.hid"));
    unsetenv("FULCRUM_HID_FORBIDDEN");
    REQUIRE_FALSE(closed);
    CHECK(closed.error().message.find("Permission denied") != std::string::npos);
}

TEST_CASE("hidapi: names keep no character that a terminal would obey") {
    const Desk desk;
    HidNode served = desk.cap();
    served.name = "Evil\x1b[2J\n\x07 name \xc3\xa9";
    const HidSocket socket(served, std::make_shared<QuietHid>());
    const auto node = desk.bus->look(served.path);
    REQUIRE(node);
    CHECK(node->name == "Evil[2J name ");
}

TEST_CASE("hidapi: listing what this machine has neither fails nor opens anything") {
    const auto bus = make_hidapi_bus();
    for (const HidNode& node : bus->list()) {
        CHECK_FALSE(node.path.empty());
        CHECK(node.descriptor.size() <= kMostDescriptorBytes);
    }
}
