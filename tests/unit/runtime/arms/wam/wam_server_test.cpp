#include "runtime/arms/wam/wam_server.h"

#include "haptics/base/clock.h"
#include "haptics/link/link_device.h"
#include "runtime/link/arm_key.h"
#include "runtime/link/udp_socket.h"
#include "tests/support/eventually.h"
#include "tests/support/scratch_folder.h"

#include <catch2/catch.hpp>

#include <array>
#include <string>
#include <thread>

using namespace fulcrum;
using namespace fulcrum::runtime;
using namespace fulcrum::test_support;

namespace {

constexpr WamPose kBegun{{0.5, -0.1, 0.3}, {1.0, 0.0, 0.0, 0.0}};

// A server at a port that is free now, and a program that holds it.
struct Served {
    Served() {
        port = [] { return (*UdpSocket::listen({"127.0.0.1", 0}))->port(); }();
        std::array<std::string, 5> words{"fulcrum-wam", "--port", std::to_string(port), "--key",
                                         key_file};
        std::array<char*, 5> pointers{};
        for (std::size_t i = 0; i < words.size(); ++i) {
            pointers[i] = words[i].data();
        }
        server = WamServer::start(5, pointers.data(), 7);
        REQUIRE(server);
        socket = std::move(*UdpSocket::connect({"127.0.0.1", port}));
        seal.emplace(*load_or_make_arm_key(key_file));
        arm.emplace(LinkDeviceSettings{}, *socket, *seal, numbers);
        REQUIRE(eventually([&] { return arm->greet(now_s()); }));
    }
    [[nodiscard]] double now_s() const { return monotonic_now_s() - began_s; }
    // A round of both threads.
    bool round(const WamPose& pose, const Vector3& force_D) {
        server->tell(pose);
        const bool is_read = arm->read(now_s(), reading);
        (void)arm->write(now_s(), {.force = force_D});
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return is_read;
    }

    ScratchFolder folder;
    std::string key_file = folder.file("arm.key");
    std::uint16_t port = 0;
    std::unique_ptr<WamServer> server;
    std::unique_ptr<UdpSocket> socket;
    std::optional<SodiumSeal> seal;
    SodiumNumbers numbers;
    std::optional<LinkDevice> arm;
    DeviceReading reading;
    double began_s = monotonic_now_s();
};

}  // namespace

TEST_CASE(
    "WAM server: its handle's way and turn come to a program in the frame of the link, from where "
    "it began") {
    Served served;
    CHECK(served.arm->traits().name == "Barrett WAM 7");
    REQUIRE(eventually([&] { return served.round(kBegun, Vector3::Zero()); }));
    // 10 mm ahead of the WAM is to the person, 20 mm to its left to the right, 30 mm up; a quarter about its X is about the person's Z.
    constexpr double kHalf = 0.70710678118654752;
    const WamPose moved{{0.51, -0.08, 0.33}, {kHalf, kHalf, 0.0, 0.0}};
    REQUIRE(eventually([&] {
        return served.round(moved, Vector3::Zero()) &&
               (served.reading.pose_D.position - Vector3(0.02, 0.03, 0.01)).norm() < 1.0e-6;
    }));
    CHECK(std::abs(served.reading.pose_D.orientation.z()) == Approx(kHalf).margin(1.0e-5));
}

TEST_CASE(
    "WAM server: a force comes to the WAM in its own frame, and none of a program that is silent") {
    Served served;
    // Up is the WAM's third axis. The gate opens while nothing is asked for, and rises softly.
    WamForce felt{};
    int rounds = 0;
    REQUIRE(eventually([&] {
        constexpr int kCalm = 600;
        const double asked_N = std::clamp(0.001 * (++rounds - kCalm), 0.0, 0.5);
        (void)served.round(kBegun, {0.0, asked_N, 0.0});
        felt = served.server->wanted();
        return felt.force_N[2] > 0.4;
    }));
    CHECK(std::abs(felt.force_N[0]) < 0.1);
    CHECK(std::abs(felt.force_N[1]) < 0.1);
    REQUIRE(eventually([&] {
        served.server->tell(kBegun);
        felt = served.server->wanted();
        return felt.force_N[2] == 0.0;
    }));
}

TEST_CASE("WAM server: what is no pose is none") {
    Served served;
    REQUIRE(eventually([&] { return served.round(kBegun, Vector3::Zero()); }));
    WamPose broken = kBegun;
    broken.turn_wxyz[0] = 0.0;
    REQUIRE(eventually([&] {
        return !served.round(broken, Vector3::Zero()) || any(served.arm->status().arm_faults);
    }));
}

TEST_CASE("WAM server: wrong words are refused") {
    std::array<std::string, 3> words{"fulcrum-wam", "--port", "many"};
    std::array<char*, 3> pointers{words[0].data(), words[1].data(), words[2].data()};
    CHECK(WamServer::start(3, pointers.data(), 7) == nullptr);
    words[1] = "--prot";
    CHECK(WamServer::start(3, pointers.data(), 7) == nullptr);
}
