// The bytes of a record's parts, shared by writer and reader: each field once, in the order of the
// file.
//
// A `Sink` puts little-endian fields at the end of a vector, a `Source` takes them off a span;
// `visit_fields` walks over a sample for either, so that the two cannot disagree. Private to
// haptics/record.
#pragma once

#include "haptics/base/little_endian.h"
#include "haptics/record/record.h"

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::record_layout {

inline constexpr std::array<std::uint8_t, 8> kMagic = {0x89, 0x46, 0x4C, 0x43,
                                                       0x52, 0x0D, 0x0A, 0x1A};
inline constexpr std::uint32_t kBlockMagic = 0x314B4C42;  // "BLK1"
inline constexpr std::size_t kBlockHeadBytes = 16;
inline constexpr std::size_t kOldEndBytes = 16;  // of versions 1 to 4, as are the next two
inline constexpr std::size_t kOldLessonBytes = 60;
inline constexpr std::size_t kOldTextBytes = 48;
inline constexpr std::size_t kEndBytesOfOneHand = 24;  // of version 5
inline constexpr std::size_t kEndBytesUntold = 32;     // of versions 6 and 7
inline constexpr std::size_t kEndBytes = 40;
inline constexpr std::size_t kMostHeaderBytes = std::size_t{1} << 24;
enum class BlockKind : std::uint32_t {
    samples = 1,
    events = 2,
    end = 3,
    bodies = 4,
    hand = 5,
    told = 6
};

/// Appends fields to a vector.
class Sink {
  public:
    explicit Sink(std::vector<std::byte>& bytes) : bytes_(bytes) {}

    template <std::unsigned_integral T>
    void field(const T& value) {
        const std::size_t at = bytes_.size();
        bytes_.resize(at + sizeof(T));
        put_little_endian(value, bytes_.data() + at);
    }
    void field(const double& value) { field(std::bit_cast<std::uint64_t>(value)); }
    void field(const std::int32_t& value) { field(static_cast<std::uint32_t>(value)); }
    /// `text` cut to kRecordTextBytes at a character's border, behind its length; what cannot stand on a line becomes a blank.
    void text(std::string_view text);

  private:
    std::vector<std::byte>& bytes_;
};

/// Takes fields off a span whose length the caller has checked.
class Source {
  public:
    explicit Source(std::span<const std::byte> bytes) : bytes_(bytes) {}

    template <std::unsigned_integral T>
    void field(T& value) {
        value = get_little_endian<T>(bytes_.data());
        bytes_ = bytes_.subspan(sizeof(T));
    }
    void field(double& value) {
        std::uint64_t bits = 0;
        field(bits);
        value = std::bit_cast<double>(bits);
    }
    void field(std::int32_t& value) {
        std::uint32_t bits = 0;
        field(bits);
        value = static_cast<std::int32_t>(bits);
    }
    /// The `size` bytes up to the first zero.
    [[nodiscard]] std::string padded_text(std::size_t size);
    /// The bytes behind their length; false where they are too many or not there.
    [[nodiscard]] bool text(std::string& text);
    /// Leaves so many bytes out; they are there.
    void skip(std::size_t n) { bytes_ = bytes_.subspan(n); }
    /// Whether so many bytes are left.
    [[nodiscard]] bool has(std::size_t n) const { return bytes_.size() >= n; }

  private:
    std::span<const std::byte> bytes_;
};

template <class Visitor, class Vector>
void visit_vector(Visitor& visitor, Vector& v) {
    visitor.field(v.x());
    visitor.field(v.y());
    visitor.field(v.z());
}

template <class Visitor, class Pose>
void visit_pose(Visitor& visitor, Pose& pose) {
    visit_vector(visitor, pose.position);
    visitor.field(pose.orientation.w());
    visitor.field(pose.orientation.x());
    visitor.field(pose.orientation.y());
    visitor.field(pose.orientation.z());
}

template <class Visitor, class Wrench>
void visit_wrench(Visitor& visitor, Wrench& wrench) {
    visit_vector(visitor, wrench.force);
    visit_vector(visitor, wrench.torque);
}

/// Every field of a sample in the order of the file, but for its shares; `Sample` is RecordSample, const for writing.
template <class Visitor, class Sample>
void visit_fields(Visitor& visitor, Sample& sample, std::uint32_t& faults, std::uint32_t& gate) {
    visitor.field(sample.tick);
    visitor.field(sample.time_s);
    visitor.field(sample.stamp_s);
    visit_pose(visitor, sample.pose_D);
    visit_vector(visitor, sample.twist_W.linear);
    visit_vector(visitor, sample.twist_W.angular);
    visit_wrench(visitor, sample.commanded_W);
    visit_wrench(visitor, sample.applied_W);
    visitor.field(sample.buttons);
    visitor.field(faults);
    visitor.field(gate);
    visitor.field(sample.touched_body);
}

/// Likewise of where a body was.
template <class Visitor, class Body>
void visit_fields(Visitor& visitor, Body& body, std::uint32_t& where) {
    visitor.field(body.time_s);
    visitor.field(body.body);
    visitor.field(where);
    visit_pose(visitor, body.state.pose_W);
    visit_vector(visitor, body.state.velocity_W);
}

/// Whether a text can be shown on a line: no control characters.
[[nodiscard]] bool is_printable(const std::string& text);

}  // namespace fulcrum::record_layout
