// What all kept shapes have in common: head, payload, checksum, and the numbers that may stand in them. For shape_bytes.cpp and
// distance_field_bytes.cpp.
//
// A payload is walked by a function of a walker: once to be counted, once to be written (byte_walk.h).
//
// Thread: load.
#pragma once

#include "haptics/voxel/byte_walk.h"
#include "haptics/voxel/shape_key.h"
#include "haptics/voxel/voxel_frame.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <type_traits>

namespace fulcrum::shape_seal {

static_assert(std::endian::native == std::endian::little, "bytes are kept as they lie in memory");

inline constexpr std::array<unsigned char, 8> kMark{0x89, 'F', 'L', 'C', 'S', '\r', '\n', 0x1A};
inline constexpr std::size_t kDigestBytes = sizeof(Digest);
inline constexpr std::size_t kHeadBytes = 8 + 4 + 4 + kDigestBytes + 8;
inline constexpr double kLargest_m = TriangleMesh::kLargestCoordinate_m;

[[nodiscard]] inline tl::unexpected<Error> refuse(const char* why) {
    return fail(why, {}, "it is made again");
}

template <class Walker, class V>
void walk_vector(Walker& walker, V& vector) {
    for (Index axis = 0; axis < 3; ++axis) {
        walker.field(vector[axis]);
    }
}

template <class Walker, class F>
void walk_frame(Walker& walker, F& frame) {
    walk_vector(walker, frame.lower_O);
    walker.field(frame.voxel_m);
    for (auto& n : frame.n_cells) {
        walker.field(n);
    }
}

[[nodiscard]] inline bool is_length(double length_m) noexcept {
    return length_m > 0.0 && length_m <= kLargest_m;
}

[[nodiscard]] inline bool is_place(const Vector3& p) noexcept {
    return p.allFinite() && p.cwiseAbs().maxCoeff() <= kLargest_m;
}

[[nodiscard]] inline bool is_frame(const VoxelFrame& frame, std::int32_t least,
                                   std::int32_t most) noexcept {
    return is_place(frame.lower_O) && is_length(frame.voxel_m) &&
           std::all_of(frame.n_cells.begin(), frame.n_cells.end(),
                       [=](std::int32_t n) { return n >= least && n <= most; });
}

/// How many bytes `seal` makes of it.
template <class Walk>
[[nodiscard]] std::size_t count_sealed(const Walk& walk) {
    ByteCounter counter;
    walk(counter);
    return kHeadBytes + counter.n_bytes() + kDigestBytes;
}

/// The head, the payload and the checksum.
template <class Walk>
[[nodiscard]] Bytes seal(ShapeKind kind, const Digest& key, const Walk& walk) {
    Bytes bytes;
    bytes.reserve(count_sealed(walk));
    ByteWriter writer(bytes);
    writer.field(kMark);
    writer.field(kShapeVersion);
    writer.field(kind);
    writer.field(key);
    writer.field(std::uint64_t{0});
    walk(writer);
    const std::uint64_t length = bytes.size() - kHeadBytes;
    std::memcpy(bytes.data() + kHeadBytes - sizeof length, &length, sizeof length);
    writer.field(compute_sha256(bytes));
    return bytes;
}

/// The payload of bytes that are what they should be.
[[nodiscard]] inline Expected<std::span<const std::byte>> unseal(std::span<const std::byte> bytes,
                                                                 ShapeKind kind,
                                                                 const Digest& key) {
    if (bytes.size() < kHeadBytes + kDigestBytes) {
        return refuse("the kept shape is cut off");
    }
    ByteReader reader(bytes);
    std::remove_const_t<decltype(kMark)> mark{};
    std::uint32_t version = 0;
    auto found_kind = std::uint32_t{0};
    Digest found_key{};
    std::uint64_t length = 0;
    reader.field(mark);
    reader.field(version);
    reader.field(found_kind);
    reader.field(found_key);
    reader.field(length);
    if (mark != kMark || version != kShapeVersion ||
        found_kind != static_cast<std::uint32_t>(kind)) {
        return refuse("the kept shape is of another kind or version");
    }
    if (length != bytes.size() - kHeadBytes - kDigestBytes) {
        return refuse("the kept shape is cut off or too long");
    }
    if (found_key != key) {
        return refuse("the kept shape is that of another mesh");
    }
    Digest checksum{};
    std::memcpy(checksum.data(), bytes.data() + bytes.size() - kDigestBytes, kDigestBytes);
    if (compute_sha256(bytes.first(bytes.size() - kDigestBytes)) != checksum) {
        return refuse("the kept shape has changed");
    }
    return bytes.subspan(kHeadBytes, static_cast<std::size_t>(length));
}

}  // namespace fulcrum::shape_seal
