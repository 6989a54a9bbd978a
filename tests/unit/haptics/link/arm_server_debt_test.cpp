// What the arm gives to a hand while nobody has put it in, by commands made by hand: their sums of energy stay zero.
#include "haptics/math/rotation.h"
#include "tests/unit/haptics/link/held_arm.h"

#include <catch2/catch.hpp>

#include <cstdint>

using namespace fulcrum;
using test_link::Held;
using test_link::kStep_s;

namespace {

constexpr double kForce_N = 3.0;
constexpr double kTorque_Nm = 0.1;

ArmServerSettings at_once() {
    ArmServerSettings settings;
    settings.safety.soft_start_s = 0.0;
    settings.safety.max_slew_N_per_s = 5000.0;
    return settings;
}

struct Unpaid {
    Held held{{}, at_once()};
    double given_J = 0.0;  // to the hand
    std::uint64_t sender = 1000;
    std::uint64_t receiver = 2000;
    std::uint64_t sequence = 0;

    Unpaid() {
        REQUIRE(held.pair.link());
        held.run(200);
        held.commands = false;
        // It goes on under the program's numbers.
        sequence = held.pair.device.status().counts.sent;
    }
    void send(PacketKind kind, const Wrench& wrench_D) {
        LinkPacket packet;
        packet.head.kind = kind;
        packet.head.sender = sender;
        packet.head.receiver = receiver;
        packet.head.sequence = ++sequence;
        packet.head.sent_ns = LinkPost::to_ns(held.pair.now_s + kStep_s);
        packet.command.wrench_D = wrench_D;
        packet.command.max_force_N = 10.0;
        packet.command.max_torque_Nm = 1.0;
        PacketBytes bytes{};
        const std::size_t size = write_packet(packet, held.pair.seal, bytes);
        REQUIRE(held.pair.channel.end(0).send(held.pair.now_s, {}, std::span(bytes).first(size)));
    }
    // In each round the hand has gone `way` and turned by `turn` under what was written last.
    void run(int n, const Wrench& wrench_D, const Vector3& way, const Vector3& turn) {
        for (int i = 0; i < n; ++i) {
            send(PacketKind::command, wrench_D);
            held.hand.pose_D.position += way;
            held.hand.pose_D.orientation = compute_exp(turn) * held.hand.pose_D.orientation;
            given_J += held.hand.written_D.force.dot(way) + held.hand.written_D.torque.dot(turn);
            held.run(1);
        }
    }
};

constexpr double kSlow_m = 2.0e-5;
constexpr double kSlow_rad = 1.0e-3;

}  // namespace

TEST_CASE("link: force and torque that nobody has paid for are left out along the way") {
    for (const bool turns : {false, true}) {
        CAPTURE(turns);
        Unpaid arm;
        const Vector3 x = Vector3::UnitX();
        const Wrench wanted = turns ? Wrench{{}, kTorque_Nm * x} : Wrench{kForce_N * x, {}};
        Wrench asked{Vector3::Zero(), Vector3::Zero()};
        (turns ? asked.torque : asked.force) = turns ? wanted.torque : wanted.force;
        const Vector3 way = turns ? Vector3(Vector3::Zero()) : Vector3(kSlow_m * x);
        const Vector3 turn = turns ? Vector3(kSlow_rad * x) : Vector3(Vector3::Zero());
        arm.run(10, {}, Vector3::Zero(), Vector3::Zero());
        arm.run(500, asked, way, turn);
        // Without the balance 30 mJ or 50 mJ. Headroom and what is borne are 1.5 mJ.
        CHECK(arm.given_J > 0.0);
        CHECK(arm.given_J < 2.5e-3);
    }
}

TEST_CASE(
    "link: the brake ends 50 ms after nothing is asked for, and a new holder begins without debt") {
    Unpaid arm;
    const Vector3 x = Vector3::UnitX();
    const Wrench asked{kForce_N * x, Vector3::Zero()};
    arm.run(10, {}, Vector3::Zero(), Vector3::Zero());
    arm.run(100, asked, kSlow_m * x, Vector3::Zero());
    REQUIRE(arm.held.hand.written_D.force.x() < 0.5);  // in debt
    // The hand goes on, and is braked for a while, ever less.
    arm.run(20, {}, kSlow_m * x, Vector3::Zero());
    const double early_N = -arm.held.hand.written_D.force.x();
    CHECK(early_N > 0.02);
    arm.run(20, {}, kSlow_m * x, Vector3::Zero());
    CHECK(-arm.held.hand.written_D.force.x() > 0.0);
    CHECK(-arm.held.hand.written_D.force.x() < early_N);
    for (int i = 0; i < 40; ++i) {
        arm.run(1, {}, kSlow_m * x, Vector3::Zero());
        CHECK((i < 12 || arm.held.hand.written_D.force.norm() == 0.0));
    }
    // Another holds it, and is given what he asks for.
    arm.send(PacketKind::bye, {});
    arm.held.run(1);
    REQUIRE_FALSE(arm.held.arm().held);
    arm.sender = 5000;
    arm.receiver = 2001;
    arm.sequence = 0;
    arm.run(200, {}, Vector3::Zero(), Vector3::Zero());  // the last one's force has faded
    REQUIRE(arm.held.arm().held);
    arm.run(5, asked, kSlow_m * x, Vector3::Zero());
    CHECK(arm.held.hand.written_D.force.x() > 2.7);
}
