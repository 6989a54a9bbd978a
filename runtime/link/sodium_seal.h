// The link's seal and its session numbers, by libsodium.
//
// Thread: any. Cost: about a microsecond for a packet.
// Source: HMAC-SHA-256 as in RFC 2104 and RFC 6234 (libsodium's crypto_auth_hmacsha256).
#pragma once

#include "haptics/link/link_post.h"
#include "haptics/link/seal.h"

#include <array>
#include <cstddef>

namespace fulcrum::runtime {

inline constexpr std::size_t kArmKeyBytes = 32;
using ArmKey = std::array<std::byte, kArmKeyBytes>;

class SodiumSeal final : public Seal {
  public:
    explicit SodiumSeal(const ArmKey& key) noexcept : key_(key) {}
    /// Leaves no key in memory.
    ~SodiumSeal() override;
    [[nodiscard]] SealTag make(std::span<const std::byte> message) const noexcept override;
    [[nodiscard]] bool holds(std::span<const std::byte> message,
                             std::span<const std::byte, kSealBytes> tag) const noexcept override;

  private:
    ArmKey key_;
};

/// From the system's source of random numbers.
class SodiumNumbers final : public SessionNumbers {
  public:
    [[nodiscard]] std::uint64_t draw() noexcept override;
};

/// A new key, from the system's source of random numbers.
[[nodiscard]] ArmKey draw_arm_key();

}  // namespace fulcrum::runtime
