// SHA-256: 32 bytes that stand for any number of bytes; nobody can make other bytes that have the same.
//
// Thread: any; load path. Cost: 4 ns a byte.
// Source: NIST 2015, Secure Hash Standard, FIPS PUB 180-4, sections 4.1.2 (functions), 4.2.2 (constants), 5.3.3 (start), 6.2.2.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace fulcrum {

using Digest = std::array<std::byte, 32>;

class Sha256 {
  public:
    void add(std::span<const std::byte> bytes) noexcept;
    /// Of all that was added; nothing may be added afterwards.
    [[nodiscard]] Digest finish() noexcept;

  private:
    void take_block(const std::byte* block) noexcept;

    static constexpr std::size_t kBlockBytes = 64;
    std::array<std::uint32_t, 8> state_{0x6a09e667U, 0xbb67ae85U, 0x3c6ef372U, 0xa54ff53aU,
                                        0x510e527fU, 0x9b05688cU, 0x1f83d9abU, 0x5be0cd19U};
    std::array<std::byte, kBlockBytes> pending_{};
    std::uint64_t n_bytes_ = 0;
};

[[nodiscard]] inline Digest compute_sha256(std::span<const std::byte> bytes) noexcept {
    Sha256 hash;
    hash.add(bytes);
    return hash.finish();
}

/// 64 small letters and figures.
[[nodiscard]] std::string to_hex(const Digest& digest);

}  // namespace fulcrum
