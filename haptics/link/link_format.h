// The bytes of the arm link, version 2, as PROTOCOL.md beside this file describes them for whoever builds an arm.
//
//   head 56 | what its kind has | CRC-32 of all before, 4 | tag of all before, 32         little-endian, IEEE 754 doubles
// The CRC tells a packet that was damaged on its way from one that a stranger made; the tag keeps strangers out. Sizes are
// fixed by the kind. Anything else is refused: nothing is read before it is known to be there, whole and authentic, and every
// number must be finite and sane.
//
// Thread: any. Cost: about a microsecond a packet, nearly all of it the tag.
#pragma once

#include "haptics/base/fault.h"
#include "haptics/handover/messages.h"
#include "haptics/link/seal.h"
#include "haptics/math/spatial.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <string_view>

namespace fulcrum {

inline constexpr std::uint16_t kLinkVersion = 2;
inline constexpr std::size_t kLargestPacket = 512;  ///< bytes; no kind is larger
inline constexpr double kFastestTold =
    1000.0;  ///< of a twist, m/s and rad/s; a faster one is refused
inline constexpr double kLeastSlew_N_per_s =
    10.0;  ///< of a command's limit: a force must be able to go; a slower one is refused
inline constexpr std::size_t kLinkNameBytes = 32;

enum class PacketKind : std::uint8_t {
    hello = 1,    ///< program -> arm: who is there?
    welcome = 2,  ///< arm -> program: what it is, and under which number it speaks now
    state = 3,    ///< arm -> program: where the hand is
    command = 4,  ///< program -> arm: what it shall feel
    bye = 5,      ///< either: the link ends in good order
};

/// Before every packet.
struct PacketHead {
    PacketKind kind = PacketKind::hello;
    std::uint64_t sender = 0;    ///< session: drawn at random by each side, never twice the same
    std::uint64_t receiver = 0;  ///< the other's, 0 while it is not known
    std::uint64_t sequence = 0;  ///< of the sender's packets in this session, from 1
    std::int64_t sent_ns = 0;    ///< sender's monotonic clock, any zero
    std::int64_t echoed_ns =
        0;                     ///< `sent_ns` of the newest packet that came from the other; 0: none
    std::int64_t held_ns = 0;  ///< from its arrival until this was sent
};

/// What an arm tells of itself. All of it is about the handle, frame D (device base).
struct LinkTraits {
    std::array<char, kLinkNameBytes> name{};  ///< UTF-8, padded with zeros
    double rate_Hz = 0.0;                     ///< of its states
    double max_force_N = 0.0;                 ///< what it can give continuously
    double max_torque_Nm = 0.0;               ///< 0: it gives none
    double damping_Ns_per_m = 0.0;            ///< its own, the least there is; 0 for unknown
    double mass_kg = 0.0;                     ///< felt at the handle; 0 for unknown
    double position_resolution_m = 0.0;
    Vector3 reach_m{
        Vector3::Zero()};     ///< half extents of a box about the origin that the handle can reach
    std::uint32_t taken = 0;  ///< 1: another program holds the arm
};

/// Energy that one side has put into the link since the session began: joules, growing only.
struct LinkEnergy {
    double force_J = 0.0;   ///< by force and motion
    double torque_J = 0.0;  ///< by torque and turning
};

struct LinkState {
    std::int64_t measured_ns = 0;  ///< when the pose was read, arm's clock
    Pose pose_D{};
    Twist twist_D{};     ///< as the arm knows it; for show, forces are computed from poses
    Wrench applied_D{};  ///< what acts on the hand
    LinkEnergy given{};  ///< by the hand
    std::uint32_t buttons = 0;
    Fault faults = Fault::none;  ///< of the arm
    GatePhase gate = GatePhase::waiting;
};

struct LinkCommand {
    Wrench wrench_D{};
    double max_force_N = 0.0;  ///< the arm takes the smaller of these and its own
    double max_torque_Nm = 0.0;
    double max_slew_N_per_s = 0.0;  ///< likewise; of the torque times max_torque / max_force
    LinkEnergy given{};             ///< by the scene
};

/// One packet; of the four parts the one that its kind names means something.
struct LinkPacket {
    PacketHead head{};
    LinkTraits traits{};
    LinkState state{};
    LinkCommand command{};
};

/// Why a packet was not taken.
enum class Refusal : std::uint8_t {
    none,
    foreign,   ///< not of this protocol: size, first bytes or kind
    version,   ///< of another version of it
    damaged,   ///< the checksum does not hold
    forged,    ///< the tag does not hold: another key, or none
    absurd,    ///< authentic, and says what cannot be
    stranger,  ///< authentic, and of another session or from elsewhere
    replayed,  ///< authentic, and was there before or is too old
};
inline constexpr std::size_t kRefusals = static_cast<std::size_t>(Refusal::replayed) + 1;
[[nodiscard]] constexpr const char* name_of(Refusal refusal) noexcept {
    constexpr const char* kNames[] = {"taken",  "foreign", "another version", "damaged",
                                      "forged", "absurd",  "of a stranger",   "replayed"};
    static_assert(std::size(kNames) == kRefusals);
    return kNames[static_cast<std::size_t>(refusal)];
}

using PacketBytes = std::array<std::byte, kLargestPacket>;

/// Size of a whole packet of this kind; 0 for a kind that there is not.
[[nodiscard]] std::size_t packet_size(PacketKind kind) noexcept;

/// The packet's bytes with checksum and tag, at the beginning of `bytes`; how many there are.
[[nodiscard]] std::size_t write_packet(const LinkPacket& packet, const Seal& seal,
                                       PacketBytes& bytes) noexcept;
/// Reads and checks all that one packet alone can tell, in this order: foreign, version, damaged, forged, absurd. `packet` is
/// changed only by one that passes.
[[nodiscard]] Refusal read_packet(std::span<const std::byte> bytes, const Seal& seal,
                                  LinkPacket& packet) noexcept;

/// `text` as a name, cut between characters.
[[nodiscard]] std::array<char, kLinkNameBytes> make_link_name(std::string_view text) noexcept;
/// And back.
[[nodiscard]] std::string_view link_name(const LinkTraits& traits) noexcept;

}  // namespace fulcrum
