#include "haptics/link/link_format.h"

#include "haptics/base/crc32.h"
#include "haptics/base/little_endian.h"
#include "haptics/loop/safety.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <concepts>
#include <limits>
#include <type_traits>

namespace fulcrum {
namespace {

constexpr std::array<std::uint8_t, 4> kLinkMagic = {'F', 'L', 'N', 'K'};
constexpr std::size_t kHeadBytes = 56;
constexpr std::size_t kChecksumBytes = 4;
constexpr std::int64_t kLatest_ns = std::int64_t{1}
                                    << 61;  // 73 years; sums of three do not overflow
constexpr std::int64_t kLongestHeld_ns = 60'000'000'000;
constexpr double kFurthest_m = 100.0;
constexpr double kMostEnergy_J = 1.0e12;
constexpr double kLinkUnitTolerance = 1.0e-3;

// Puts fields one after another into bytes that are long enough.
class FieldWriter {
  public:
    explicit FieldWriter(std::span<std::byte> bytes) noexcept : bytes_(bytes) {}

    template <std::unsigned_integral T>
    void field(T value) noexcept {
        put_little_endian(value, bytes_.data() + at_);
        at_ += sizeof(T);
    }
    void field(double value) noexcept { field(std::bit_cast<std::uint64_t>(value)); }
    void field(std::int64_t value) noexcept { field(static_cast<std::uint64_t>(value)); }
    void field(char value) noexcept { field(static_cast<std::uint8_t>(value)); }
    template <class Enum>
    requires std::is_enum_v<Enum>
    void field(Enum value) noexcept { field(static_cast<std::uint32_t>(value)); }
    [[nodiscard]] std::size_t size() const noexcept { return at_; }

  private:
    std::span<std::byte> bytes_;
    std::size_t at_ = 0;
};

// Takes them off again.
class FieldReader {
  public:
    explicit FieldReader(std::span<const std::byte> bytes) noexcept : bytes_(bytes) {}

    template <std::unsigned_integral T>
    void field(T& value) noexcept {
        value = get_little_endian<T>(bytes_.data() + at_);
        at_ += sizeof(T);
    }
    void field(double& value) noexcept {
        std::uint64_t bits = 0;
        field(bits);
        value = std::bit_cast<double>(bits);
    }
    void field(std::int64_t& value) noexcept {
        std::uint64_t bits = 0;
        field(bits);
        value = static_cast<std::int64_t>(bits);
    }
    void field(char& value) noexcept {
        std::uint8_t byte = 0;
        field(byte);
        value = static_cast<char>(byte);
    }
    template <class Enum>
    requires std::is_enum_v<Enum>
    void field(Enum& value) noexcept {
        std::uint32_t bits = 0;
        field(bits);
        // What does not fit is the largest that does, and not something else.
        using Bits = std::underlying_type_t<Enum>;
        value = static_cast<Enum>(
            static_cast<Bits>(std::min<std::uint32_t>(bits, std::numeric_limits<Bits>::max())));
    }

  private:
    std::span<const std::byte> bytes_;
    std::size_t at_ = 0;
};

template <class Visitor, class Vector>
void visit_vector3(Visitor& visitor, Vector& v) noexcept {
    visitor.field(v.x());
    visitor.field(v.y());
    visitor.field(v.z());
}

template <class Visitor, class Head>
void visit_head(Visitor& visitor, Head& head) noexcept {
    visitor.field(head.sender);
    visitor.field(head.receiver);
    visitor.field(head.sequence);
    visitor.field(head.sent_ns);
    visitor.field(head.echoed_ns);
    visitor.field(head.held_ns);
}

template <class Visitor, class Traits>
void visit_traits(Visitor& visitor, Traits& traits) noexcept {
    for (auto& letter : traits.name) {
        visitor.field(letter);
    }
    visitor.field(traits.rate_Hz);
    visitor.field(traits.max_force_N);
    visitor.field(traits.max_torque_Nm);
    visitor.field(traits.damping_Ns_per_m);
    visitor.field(traits.mass_kg);
    visitor.field(traits.position_resolution_m);
    visit_vector3(visitor, traits.reach_m);
    visitor.field(traits.taken);
}

template <class Visitor, class State>
void visit_state(Visitor& visitor, State& state) noexcept {
    visitor.field(state.measured_ns);
    visit_vector3(visitor, state.pose_D.position);
    visitor.field(state.pose_D.orientation.w());
    visitor.field(state.pose_D.orientation.x());
    visitor.field(state.pose_D.orientation.y());
    visitor.field(state.pose_D.orientation.z());
    visit_vector3(visitor, state.twist_D.linear);
    visit_vector3(visitor, state.twist_D.angular);
    visit_vector3(visitor, state.applied_D.force);
    visit_vector3(visitor, state.applied_D.torque);
    visitor.field(state.given.force_J);
    visitor.field(state.given.torque_J);
    visitor.field(state.buttons);
    visitor.field(state.faults);
    visitor.field(state.gate);
}

template <class Visitor, class Command>
void visit_command(Visitor& visitor, Command& command) noexcept {
    visit_vector3(visitor, command.wrench_D.force);
    visit_vector3(visitor, command.wrench_D.torque);
    visitor.field(command.max_force_N);
    visitor.field(command.max_torque_Nm);
    visitor.field(command.max_slew_N_per_s);
    visitor.field(command.given.force_J);
    visitor.field(command.given.torque_J);
}

// The part that the packet's kind names; hello and bye have none.
template <class Visitor, class Packet>
void visit_body(Visitor& visitor, Packet& packet) noexcept {
    switch (packet.head.kind) {
        case PacketKind::hello:
        case PacketKind::bye:
            break;
        case PacketKind::welcome:
            visit_traits(visitor, packet.traits);
            break;
        case PacketKind::state:
            visit_state(visitor, packet.state);
            break;
        case PacketKind::command:
            visit_command(visitor, packet.command);
            break;
    }
}

bool is_within(double value, double low, double high) noexcept {
    return value >= low && value <= high;  // NaN is not
}
bool is_within(const Vector3& v, double most) noexcept {
    return is_finite(v) && v.cwiseAbs().maxCoeff() <= most;
}
bool is_within(const Wrench& wrench, double most) noexcept {
    return is_within(wrench.force, most) && is_within(wrench.torque, most);
}
bool is_sane(const LinkEnergy& energy) noexcept {
    return is_within(energy.force_J, 0.0, kMostEnergy_J) &&
           is_within(energy.torque_J, 0.0, kMostEnergy_J);
}

bool is_sane(const PacketHead& head) noexcept {
    const auto is_time = [](std::int64_t t_ns) { return t_ns >= 0 && t_ns <= kLatest_ns; };
    return head.sender != 0 && head.sequence != 0 && is_time(head.sent_ns) &&
           is_time(head.echoed_ns) && head.held_ns >= 0 && head.held_ns <= kLongestHeld_ns;
}

bool is_sane(const LinkTraits& t) noexcept {
    return is_within(t.rate_Hz, 100.0, kMostRate_Hz) && is_within(t.max_force_N, 0.0, 1000.0) &&
           is_within(t.max_torque_Nm, 0.0, 1000.0) && is_within(t.damping_Ns_per_m, 0.0, 1.0e4) &&
           is_within(t.mass_kg, 0.0, 1000.0) && is_within(t.position_resolution_m, 0.0, 0.1) &&
           is_within(t.reach_m, kFurthest_m) && t.taken <= 1;
}

bool is_sane(const LinkState& s) noexcept {
    const double length = s.pose_D.orientation.coeffs().norm();
    return s.measured_ns >= 0 && s.measured_ns <= kLatest_ns &&
           is_within(s.pose_D.position, kFurthest_m) &&
           is_within(length, 1.0 - kLinkUnitTolerance, 1.0 + kLinkUnitTolerance) &&
           is_within(s.twist_D.linear, kFastestTold) &&
           is_within(s.twist_D.angular, kFastestTold) && is_within(s.applied_D, kInsaneForce_N) &&
           is_sane(s.given) && s.gate <= GatePhase::stopped;
}

bool is_sane(const LinkCommand& c) noexcept {
    return is_within(c.wrench_D, kInsaneForce_N) && is_within(c.max_force_N, 0.0, 1000.0) &&
           is_within(c.max_torque_Nm, 0.0, 1000.0) &&
           is_within(c.max_slew_N_per_s, kLeastSlew_N_per_s, 1.0e6) && is_sane(c.given);
}

bool is_sane(const LinkPacket& packet) noexcept {
    if (!is_sane(packet.head)) {
        return false;
    }
    switch (packet.head.kind) {
        case PacketKind::hello:
        case PacketKind::bye:
            return true;
        case PacketKind::welcome:
            return is_sane(packet.traits);
        case PacketKind::state:
            return is_sane(packet.state);
        case PacketKind::command:
            return is_sane(packet.command);
    }
    return false;
}

}  // namespace

std::size_t packet_size(PacketKind kind) noexcept {
    constexpr std::size_t kNumber = 8;
    constexpr std::size_t kEnds = kHeadBytes + kChecksumBytes + kSealBytes;
    switch (kind) {
        case PacketKind::hello:
        case PacketKind::bye:
            return kEnds;
        case PacketKind::welcome:
            return kEnds + kLinkNameBytes + 9 * kNumber + 4;
        case PacketKind::state:
            // Time, pose, twist, wrench, energy; buttons, faults, gate.
            return kEnds + (1 + 7 + 6 + 6 + 2) * kNumber + 12;
        case PacketKind::command:
            // Wrench, limits, energy.
            return kEnds + (6 + 3 + 2) * kNumber;
    }
    return 0;
}

std::size_t write_packet(const LinkPacket& packet, const Seal& seal, PacketBytes& bytes) noexcept {
    const std::size_t whole = packet_size(packet.head.kind);
    if (whole == 0) {
        return 0;
    }
    FieldWriter writer(bytes);
    for (const std::uint8_t letter : kLinkMagic) {
        writer.field(letter);
    }
    writer.field(kLinkVersion);
    writer.field(static_cast<std::uint8_t>(packet.head.kind));
    writer.field(std::uint8_t{0});
    visit_head(writer, packet.head);
    visit_body(writer, packet);
    writer.field(compute_crc32(std::span(bytes).first(writer.size())));
    const SealTag tag = seal.make(std::span(bytes).first(writer.size()));
    std::copy(tag.begin(), tag.end(), bytes.begin() + static_cast<std::ptrdiff_t>(writer.size()));
    return whole;
}

Refusal read_packet(std::span<const std::byte> bytes, const Seal& seal,
                    LinkPacket& packet) noexcept {
    // Of this protocol, and as long as its kind is?
    if (bytes.size() < kHeadBytes + kChecksumBytes + kSealBytes) {
        return Refusal::foreign;
    }
    FieldReader reader(bytes);
    for (const std::uint8_t letter : kLinkMagic) {
        std::uint8_t byte = 0;
        reader.field(byte);
        if (byte != letter) {
            return Refusal::foreign;
        }
    }
    std::uint16_t version = 0;
    std::uint8_t kind = 0;
    std::uint8_t reserved = 0;
    reader.field(version);
    reader.field(kind);
    reader.field(reserved);
    if (version != kLinkVersion) {
        return Refusal::version;
    }
    LinkPacket read{};
    read.head.kind = static_cast<PacketKind>(kind);
    if (reserved != 0 || packet_size(read.head.kind) != bytes.size()) {
        return Refusal::foreign;
    }
    // Whole, and by who has the key?
    const std::span<const std::byte> sealed = bytes.first(bytes.size() - kSealBytes);
    std::uint32_t checksum = 0;
    FieldReader(sealed.last(kChecksumBytes)).field(checksum);
    if (compute_crc32(sealed.first(sealed.size() - kChecksumBytes)) != checksum) {
        return Refusal::damaged;
    }
    if (!seal.holds(sealed, bytes.last<kSealBytes>())) {
        return Refusal::forged;
    }
    // What it says.
    visit_head(reader, read.head);
    visit_body(reader, read);
    if (!is_sane(read)) {
        return Refusal::absurd;
    }
    read.state.pose_D.orientation.normalize();
    packet = read;
    return Refusal::none;
}

std::array<char, kLinkNameBytes> make_link_name(std::string_view text) noexcept {
    std::array<char, kLinkNameBytes> name{};
    std::size_t size = std::min(text.size(), name.size());
    // Not within a character: its later bytes begin with the bits 10.
    while (size < text.size() && size > 0 &&
           (static_cast<unsigned char>(text[size]) & 0xC0U) == 0x80U) {
        --size;
    }
    std::copy_n(text.begin(), size, name.begin());
    return name;
}

std::string_view link_name(const LinkTraits& traits) noexcept {
    const auto end = std::find(traits.name.begin(), traits.name.end(), '\0');
    return {traits.name.data(), static_cast<std::size_t>(end - traits.name.begin())};
}

}  // namespace fulcrum
