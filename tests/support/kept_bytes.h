// Bytes of kept shapes that somebody cut, lengthened or changed: what a decoder must refuse (shape_bytes.h).
#pragma once

#include "haptics/voxel/shape_bytes.h"

#include <catch2/catch.hpp>

#include <cstring>
#include <span>
#include <utility>

namespace fulcrum::test {

/// Where the payload begins.
inline constexpr std::size_t kPayloadAt = 56;

/// Changed, and its checksum put right.
template <class T>
Bytes with_mended(const Bytes& bytes, std::size_t at, T value) {
    Bytes changed = bytes;
    std::memcpy(changed.data() + at, &value, sizeof value);
    const std::size_t end = changed.size() - sizeof(Digest);
    const Digest checksum = compute_sha256(std::span(changed).first(end));
    std::memcpy(changed.data() + end, checksum.data(), sizeof checksum);
    return changed;
}

template <class T>
T number_at(const Bytes& bytes, std::size_t at) {
    T number{};
    std::memcpy(&number, bytes.data() + at, sizeof number);
    return number;
}

/// Cut off anywhere, longer, or changed in any byte it is refused.
template <class Takes>
void check_sealed(const Bytes& bytes, Takes takes) {
    REQUIRE(takes(bytes));
    for (std::size_t n = 0; n < bytes.size(); ++n) {
        REQUIRE_FALSE(takes(std::span(bytes).first(n)));
        Bytes flipped = bytes;
        flipped[n] ^= std::byte{16};
        REQUIRE_FALSE(takes(flipped));
    }
    Bytes longer = bytes;
    longer.push_back(std::byte{0});
    CHECK_FALSE(takes(longer));
}

/// Numbers of a payload that somebody changed, the checksum put right each time.
template <class Takes>
class Mended {
  public:
    Mended(Bytes bytes, Takes takes) : bytes_(std::move(bytes)), takes_(takes) {
        REQUIRE(takes_(bytes_));
    }
    /// Counted from the payload's beginning.
    template <class T>
    [[nodiscard]] bool takes_at(std::size_t at, T value) const {
        return takes_(with_mended(bytes_, kPayloadAt + at, value));
    }
    /// Each of them alone is refused there.
    template <class... T>
    void check_refused_at(std::size_t at, T... values) const {
        const auto check = [&](auto value) {
            CAPTURE(at, +value);
            CHECK_FALSE(takes_at(at, value));
        };
        (check(values), ...);
    }

  private:
    Bytes bytes_;
    Takes takes_;
};

}  // namespace fulcrum::test
