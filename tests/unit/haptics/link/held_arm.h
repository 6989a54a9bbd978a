// A program that holds an arm over the link and asks for the same wrench in every round.
#pragma once

#include "tests/support/link.h"
#include "tests/support/scripted_device.h"

#include <catch2/catch.hpp>

#include <cstdint>

namespace fulcrum::test_link {

inline constexpr double kStep_s = LinkPair::kStep_s;

inline void send_packet(Datagrams& line, const Seal& seal, const LinkPacket& packet, double now_s) {
    PacketBytes bytes{};
    const std::size_t size = write_packet(packet, seal, bytes);
    line.send(now_s, {}, std::span(bytes).first(size));
}
struct Numbers {
    std::uint64_t sender, receiver, sequence;
};
inline LinkPacket make_numbered(PacketKind kind, const Numbers& numbers, std::int64_t sent_ns = 1) {
    LinkPacket packet;
    packet.head = {kind, numbers.sender, numbers.receiver, numbers.sequence, sent_ns, 0, 0};
    return packet;
}
// The hello of a program that nobody knows.
inline LinkPacket make_hello(std::uint64_t sender = 5, std::int64_t sent_ns = 1) {
    return make_numbered(PacketKind::hello, {sender, 0, 1}, sent_ns);
}

// A program that asks for `wrench` in every round, after a soft start.
struct Held {
    explicit Held(const LinkFaults& faults = {}, const ArmServerSettings& server = {},
                  const LinkDeviceSettings& device = {},
                  const DeviceTraits& arm_traits = ScriptedDevice().traits_)
        : pair(like(arm_traits), faults, server, device) {}
    ScriptedDevice& like(const DeviceTraits& traits) {
        hand.traits_ = traits;
        return hand;
    }

    void run(int n) {
        for (int i = 0; i < n; ++i) {
            pair.now_s += kStep_s;
            if (serves) {
                pair.server.step(pair.now_s);
            }
            gives_pose = pair.device.read(pair.now_s, reading);
            if (commands) {
                takes = pair.device.write(pair.now_s, wrench);
            }
            n_poses += gives_pose ? 1 : 0;
        }
    }
    // Linked, and the arm feels 3 N.
    void engage() {
        REQUIRE(pair.link());
        run(200);
        wrench.force = {3.0, 0.0, 0.0};
        run(3000);
        REQUIRE(hand.written_D.force.x() == Approx(3.0).epsilon(1e-9));
    }
    // The gate's phase so many rounds later.
    GatePhase run_to_gate(int n) {
        run(n);
        return arm().gate;
    }
    [[nodiscard]] double felt_N() const { return hand.written_D.force.x(); }
    // Somebody sends so, sealed with the right key; from the program's end or from the arm's.
    void send(const LinkPacket& packet, int end = 0) {
        send_packet(pair.channel.end(end), pair.seal, packet, pair.now_s);
    }
    [[nodiscard]] ArmServerStatus arm() { return pair.server.status(); }
    [[nodiscard]] std::uint64_t refused(Refusal why) {
        return arm().counts.received[static_cast<std::size_t>(why)];
    }

    ScriptedDevice hand;
    LinkPair pair;
    Wrench wrench{};
    DeviceReading reading{};
    bool serves = true;
    bool commands = true;
    bool gives_pose = false;
    bool takes = false;
    int n_poses = 0;
};

// One that is engaged already.
struct Engaged : Held {
    explicit Engaged(const LinkFaults& faults = {}, const ArmServerSettings& server = {},
                     const LinkDeviceSettings& device = {})
        : Held(faults, server, device) {
        engage();
    }
};

}  // namespace fulcrum::test_link
