// Any bytes at all as packets of the arm link, for program and arm alike: taken or refused, never a crash, and whatever comes, the
// arm's force stays within its limits and a pose that is handed on is a pose. The bytes are cut into packets by lengths in front; each
// is tried as it is and, with its first bytes, checksum and tag put right, as of somebody who has the key.
#include "haptics/base/crc32.h"
#include "tests/fuzz/promise.h"
#include "tests/support/link.h"
#include "tests/support/scripted_device.h"

namespace {

using namespace fulcrum;

// The packet that somebody with the key would make of these bytes; of the size of its kind.
std::vector<std::byte> put_right(std::span<const std::byte> bytes, const Seal& seal,
                                 std::uint64_t receiver) {
    std::vector<std::byte> packet(bytes.begin(), bytes.end());
    const auto kind =
        static_cast<PacketKind>(1 + (packet.empty() ? 0 : std::to_integer<int>(packet[0]) % 5));
    packet.resize(packet_size(kind));
    const std::byte head[] = {std::byte{'F'},
                              std::byte{'L'},
                              std::byte{'N'},
                              std::byte{'K'},
                              std::byte{2},
                              std::byte{0},
                              static_cast<std::byte>(kind),
                              std::byte{0}};
    std::copy(std::begin(head), std::end(head), packet.begin());
    if (packet[8] != std::byte{0}) {
        // Mostly for who it is sent to; else whatever the bytes say.
        for (std::size_t i = 0; i < 8; ++i) {
            packet[16 + i] = static_cast<std::byte>((receiver >> (8 * i)) & 0xFFU);
        }
    }
    const std::size_t sealed = packet.size() - kSealBytes;
    const std::uint32_t checksum = compute_crc32(std::span(packet).first(sealed - 4));
    for (std::size_t i = 0; i < 4; ++i) {
        packet[sealed - 4 + i] = static_cast<std::byte>((checksum >> (8 * i)) & 0xFFU);
    }
    const SealTag tag = seal.make(std::span(packet).first(sealed));
    std::copy(tag.begin(), tag.end(), packet.begin() + static_cast<std::ptrdiff_t>(sealed));
    return packet;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto all = std::as_bytes(std::span(data, size));
    ScriptedDevice hand;
    test_link::LinkPair pair(hand);
    (void)pair.link();
    std::size_t at = 0;
    for (int n = 0; at < all.size() && n < 64; ++n) {
        const std::size_t length =
            std::min<std::size_t>(std::to_integer<std::size_t>(all[at]) * 2, all.size() - at - 1);
        const auto raw = all.subspan(at + 1, length);
        at += 1 + length;
        LinkPacket read;
        (void)read_packet(raw, pair.seal, read);
        // To the arm, and from it to the program.
        if (!raw.empty()) {
            pair.channel.end(0).send(pair.now_s, {}, raw);
            pair.channel.end(1).send(pair.now_s, {}, raw);
        }
        pair.channel.end(0).send(pair.now_s, {}, put_right(raw, pair.seal, 2000));
        pair.channel.end(1).send(pair.now_s, {}, put_right(raw, pair.seal, 1000));
        for (int round = 0; round < 3; ++round) {
            pair.now_s += test_link::LinkPair::kStep_s;
            pair.server.step(pair.now_s);
            DeviceReading reading;
            if (pair.device.read(pair.now_s, reading)) {
                require(is_finite(reading.pose_D) && std::isfinite(reading.stamp_s));
                require(std::abs(reading.pose_D.orientation.norm() - 1.0) < 1e-6);
                require(reading.stamp_s <= pair.now_s);
            }
            (void)pair.device.write(pair.now_s, {{0.1, 0.0, 0.0}, Vector3::Zero()});
            require(hand.written_D.force.norm() <= kHardForceCap_N);
            require(hand.written_D.torque.norm() <= kHardTorqueCap_Nm);
        }
    }
    return 0;
}
