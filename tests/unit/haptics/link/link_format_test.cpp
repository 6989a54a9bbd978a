#include "haptics/link/link_format.h"

#include "haptics/math/rotation.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/link.h"

#include <catch2/catch.hpp>

#include <rapidcheck.h>

using namespace fulcrum;
using test_link::HmacSeal;

namespace {

constexpr PacketKind kKinds[] = {PacketKind::hello, PacketKind::welcome, PacketKind::state,
                                 PacketKind::command, PacketKind::bye};

LinkPacket make_packet(PacketKind kind) {
    LinkPacket packet;
    packet.head = {kind, 11, 12, 13, 14, 15, 16};
    packet.traits.name = make_link_name("an arm");
    packet.traits.rate_Hz = 1000.0;
    packet.traits.max_force_N = 8.0;
    packet.traits.max_torque_Nm = 0.5;
    packet.traits.damping_Ns_per_m = 0.5;
    packet.traits.mass_kg = 1.25;
    packet.traits.position_resolution_m = 1e-5;
    packet.traits.reach_m = {0.1, 0.2, 0.3};
    packet.traits.taken = 1;
    packet.state.measured_ns = 17;
    packet.state.pose_D = {{0.1, -0.2, 0.3}, compute_exp({0.3, 0.2, 0.1})};
    packet.state.twist_D = {{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}};
    packet.state.applied_D = {{-1.0, 0.5, 0.25}, {0.1, 0.2, 0.3}};
    packet.state.given = {1.5, 0.125};
    packet.state.buttons = 5;
    packet.state.faults = Fault::device_stale | Fault::too_much_energy;
    packet.state.gate = GatePhase::rising;
    packet.command.wrench_D = {{1.0, 2.0, -3.0}, {0.1, -0.2, 0.3}};
    packet.command.max_force_N = 5.0;
    packet.command.max_torque_Nm = 0.3;
    packet.command.max_slew_N_per_s = 400.0;
    packet.command.given = {2.5, 0.25};
    return packet;
}

std::vector<std::byte> bytes_of(const LinkPacket& packet, const Seal& seal) {
    PacketBytes bytes{};
    const std::size_t size = write_packet(packet, seal, bytes);
    return {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)};
}

bool same(const Wrench& a, const Wrench& b) {
    return a.force == b.force && a.torque == b.torque;
}

}  // namespace

TEST_CASE("link format: sizes are those of the description") {
    CHECK(packet_size(PacketKind::hello) == 92);
    CHECK(packet_size(PacketKind::welcome) == 200);
    CHECK(packet_size(PacketKind::state) == 280);
    CHECK(packet_size(PacketKind::command) == 180);
    CHECK(packet_size(PacketKind::bye) == 92);
    CHECK(packet_size(static_cast<PacketKind>(0)) == 0);
    CHECK(packet_size(static_cast<PacketKind>(6)) == 0);
    const HmacSeal seal;
    for (const PacketKind kind : kKinds) {
        CHECK(bytes_of(make_packet(kind), seal).size() == packet_size(kind));
    }
}

TEST_CASE("link format: what is written is read") {
    const HmacSeal seal;
    for (const PacketKind kind : kKinds) {
        const LinkPacket sent = make_packet(kind);
        LinkPacket read;
        REQUIRE(read_packet(bytes_of(sent, seal), seal, read) == Refusal::none);
        CHECK(read.head.kind == kind);
        CHECK(read.head.sender == 11);
        CHECK(read.head.receiver == 12);
        CHECK(read.head.sequence == 13);
        CHECK(read.head.sent_ns == 14);
        CHECK(read.head.echoed_ns == 15);
        CHECK(read.head.held_ns == 16);
        if (kind == PacketKind::welcome) {
            CHECK(link_name(read.traits) == "an arm");
            CHECK(read.traits.rate_Hz == 1000.0);
            CHECK(read.traits.max_force_N == 8.0);
            CHECK(read.traits.max_torque_Nm == 0.5);
            CHECK(read.traits.damping_Ns_per_m == 0.5);
            CHECK(read.traits.mass_kg == 1.25);
            CHECK(read.traits.position_resolution_m == 1e-5);
            CHECK(read.traits.reach_m == Vector3(0.1, 0.2, 0.3));
            CHECK(read.traits.taken == 1);
        }
        if (kind == PacketKind::state) {
            CHECK(read.state.measured_ns == 17);
            CHECK(read.state.pose_D.position == sent.state.pose_D.position);
            CHECK(read.state.pose_D.orientation.coeffs().isApprox(
                sent.state.pose_D.orientation.coeffs(), 1e-15));
            CHECK(read.state.twist_D.linear == sent.state.twist_D.linear);
            CHECK(read.state.twist_D.angular == sent.state.twist_D.angular);
            CHECK(same(read.state.applied_D, sent.state.applied_D));
            CHECK(read.state.given.force_J == 1.5);
            CHECK(read.state.given.torque_J == 0.125);
            CHECK(read.state.buttons == 5);
            CHECK(read.state.faults == sent.state.faults);
            CHECK(read.state.gate == GatePhase::rising);
        }
        if (kind == PacketKind::command) {
            CHECK(same(read.command.wrench_D, sent.command.wrench_D));
            CHECK(read.command.max_force_N == 5.0);
            CHECK(read.command.max_torque_Nm == 0.3);
            CHECK(read.command.max_slew_N_per_s == 400.0);
            CHECK(read.command.given.force_J == 2.5);
            CHECK(read.command.given.torque_J == 0.25);
        }
    }
}

TEST_CASE("link format: the bytes are where the description says, little-endian") {
    // An arm's maker tests against these.
    const std::vector<std::byte> bytes = bytes_of(make_packet(PacketKind::command), HmacSeal());
    // The first number of the command is 1.0: 3FF0 0000 0000 0000.
    const std::pair<std::size_t, int> told[] = {
        {0, 'F'}, {3, 'K'}, {4, 2},   {5, 0},   {6, 4},  {7, 0},     {8, 11},   {16, 12},
        {24, 13}, {32, 14}, {40, 15}, {48, 16}, {61, 0}, {62, 0xF0}, {63, 0x3F}};
    for (const auto& [place, byte] : told) {
        CAPTURE(place);
        CHECK(std::to_integer<int>(bytes[place]) == byte);
    }
}

TEST_CASE("link format: not one bit may be another") {
    const HmacSeal seal;
    for (const PacketKind kind : kKinds) {
        const std::vector<std::byte> good = bytes_of(make_packet(kind), seal);
        for (std::size_t bit = 0; bit < good.size() * 8; ++bit) {
            std::vector<std::byte> bad = good;
            bad[bit / 8] ^= std::byte{1} << (bit % 8);
            LinkPacket read;
            INFO("bit " << bit);
            REQUIRE(read_packet(bad, seal, read) != Refusal::none);
            REQUIRE(read.head.sender == 0);  // untouched
        }
        for (std::size_t size = 0; size < good.size(); ++size) {
            LinkPacket read;
            REQUIRE(read_packet(std::span(good).first(size), seal, read) != Refusal::none);
        }
    }
}

TEST_CASE("link format: each refusal says why") {
    const HmacSeal seal;
    const std::vector<std::byte> good = bytes_of(make_packet(PacketKind::state), seal);
    LinkPacket read;
    const auto why = [&](std::vector<std::byte> bytes) { return read_packet(bytes, seal, read); };
    const auto changed = [&](std::size_t at) {
        std::vector<std::byte> bytes = good;
        bytes[at] ^= std::byte{0x10};
        return bytes;
    };
    CHECK(why({}) == Refusal::foreign);
    CHECK(why(changed(0)) == Refusal::foreign);
    CHECK(why(changed(4)) == Refusal::version);
    CHECK(why(changed(6)) == Refusal::foreign);
    CHECK(why(changed(7)) == Refusal::foreign);
    CHECK(why(changed(100)) == Refusal::damaged);
    CHECK(why(changed(good.size() - 1)) == Refusal::forged);
    CHECK(read_packet(good, HmacSeal(8), read) == Refusal::forged);
    std::vector<std::byte> longer = good;
    longer.push_back(std::byte{0});
    CHECK(why(longer) == Refusal::foreign);
}

TEST_CASE("link format: who has the key may not say what cannot be") {
    const HmacSeal seal;
    const auto why = [&](PacketKind kind, auto&& spoil) {
        LinkPacket packet = make_packet(kind);
        spoil(packet);
        LinkPacket read;
        return read_packet(bytes_of(packet, seal), seal, read);
    };
    using P = LinkPacket&;
    const Refusal absurd = Refusal::absurd;
    CHECK(why(PacketKind::hello, [](P p) { p.head.sender = 0; }) == absurd);
    CHECK(why(PacketKind::hello, [](P p) { p.head.sequence = 0; }) == absurd);
    CHECK(why(PacketKind::hello, [](P p) { p.head.sent_ns = -1; }) == absurd);
    CHECK(why(PacketKind::hello, [](P p) { p.head.sent_ns = INT64_MAX; }) == absurd);
    CHECK(why(PacketKind::hello, [](P p) { p.head.echoed_ns = -1; }) == absurd);
    CHECK(why(PacketKind::hello, [](P p) { p.head.held_ns = -1; }) == absurd);
    for (const double bad : {kNan, kInfinity, -kInfinity, 1e300}) {
        CHECK(why(PacketKind::state, [&](P p) { p.state.pose_D.position.y() = bad; }) == absurd);
        CHECK(why(PacketKind::state, [&](P p) { p.state.pose_D.orientation.w() = bad; }) == absurd);
        CHECK(why(PacketKind::state, [&](P p) { p.state.twist_D.linear.x() = bad; }) == absurd);
        CHECK(why(PacketKind::state, [&](P p) { p.state.twist_D.angular.z() = bad; }) == absurd);
        CHECK(why(PacketKind::state, [&](P p) { p.state.applied_D.force.x() = bad; }) == absurd);
        CHECK(why(PacketKind::state, [&](P p) { p.state.given.force_J = bad; }) == absurd);
        CHECK(why(PacketKind::command, [&](P p) { p.command.wrench_D.force.z() = bad; }) == absurd);
        CHECK(why(PacketKind::command, [&](P p) { p.command.wrench_D.torque.x() = bad; }) ==
              absurd);
        CHECK(why(PacketKind::command, [&](P p) { p.command.max_force_N = bad; }) == absurd);
        CHECK(why(PacketKind::command, [&](P p) { p.command.max_slew_N_per_s = bad; }) == absurd);
        CHECK(why(PacketKind::command, [&](P p) { p.command.given.torque_J = bad; }) == absurd);
        CHECK(why(PacketKind::welcome, [&](P p) { p.traits.max_force_N = bad; }) == absurd);
        CHECK(why(PacketKind::welcome, [&](P p) { p.traits.reach_m.z() = bad; }) == absurd);
    }
    // A force that may not change could not go.
    CHECK(why(PacketKind::command, [](P p) { p.command.max_slew_N_per_s = 0.0; }) == absurd);
    CHECK(why(PacketKind::command, [](P p) { p.command.max_slew_N_per_s = kLeastSlew_N_per_s; }) ==
          Refusal::none);
    CHECK(why(PacketKind::state, [](P p) { p.state.pose_D.orientation.coeffs() *= 1.01; }) ==
          absurd);
    CHECK(why(PacketKind::state, [](P p) { p.state.gate = static_cast<GatePhase>(5); }) == absurd);
    CHECK(why(PacketKind::welcome, [](P p) { p.traits.taken = 2; }) == absurd);
    // Of the parts that are not in a packet nothing is asked.
    CHECK(why(PacketKind::state, [&](P p) { p.command.max_force_N = kNan; }) == Refusal::none);
}

TEST_CASE("link format: names are cut between characters; any bytes are refused or read, no more") {
    const auto read_back = [](std::string_view text) {
        LinkTraits traits;
        traits.name = make_link_name(text);
        return std::string(link_name(traits));
    };
    CHECK(read_back("") == "");
    CHECK(read_back("arm") == "arm");
    CHECK(read_back(std::string(40, 'a')) == std::string(32, 'a'));
    CHECK(read_back(std::string(31, 'a') + "é") == std::string(31, 'a'));
    CHECK(read_back(std::string(30, 'a') + "éb") == std::string(30, 'a') + "é");
    const HmacSeal seal;
    CHECK(rc::check("link format: random bytes", [&] {
        const auto bytes =
            *rc::gen::container<std::vector<std::uint8_t>>(rc::gen::arbitrary<std::uint8_t>());
        LinkPacket read;
        RC_ASSERT(read_packet(std::as_bytes(std::span(bytes)), seal, read) != Refusal::none);
    }));
}
