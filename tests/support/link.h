// Both sides of the arm link in one program, under one clock.
#pragma once

#include "haptics/base/sha256.h"
#include "haptics/link/arm_server.h"
#include "haptics/link/link_device.h"
#include "haptics/link/link_faults.h"
#include "haptics/link/memory_channel.h"

#include <algorithm>
#include <array>
#include <vector>

namespace fulcrum::test_link {

/// HMAC-SHA-256 (RFC 2104) with a key of 32 bytes.
class HmacSeal final : public Seal {
  public:
    explicit HmacSeal(std::uint8_t first = 7) {
        for (std::size_t i = 0; i < key_.size(); ++i) {
            key_[i] = static_cast<std::byte>(i < 32 ? first + i : 0);
        }
    }
    [[nodiscard]] SealTag make(std::span<const std::byte> message) const noexcept override {
        const Digest inner = hash(std::byte{0x36}, message);
        return hash(std::byte{0x5C}, inner);
    }
    [[nodiscard]] bool holds(std::span<const std::byte> message,
                             std::span<const std::byte, kSealBytes> tag) const noexcept override {
        const SealTag right = make(message);
        return std::equal(right.begin(), right.end(), tag.begin());
    }

  private:
    [[nodiscard]] Digest hash(std::byte pad, std::span<const std::byte> message) const noexcept {
        std::array<std::byte, 64> padded = key_;
        for (std::byte& byte : padded) {
            byte ^= pad;
        }
        Sha256 sha;
        sha.add(padded);
        sha.add(message);
        return sha.finish();
    }
    std::array<std::byte, 64> key_{};
};

class CountedNumbers final : public SessionNumbers {
  public:
    explicit CountedNumbers(std::uint64_t first) : next_(first) {}
    [[nodiscard]] std::uint64_t draw() noexcept override { return next_++; }

  private:
    std::uint64_t next_;
};

/// Passes packets on and keeps a copy of each, as somebody who listens does.
class Tap final : public Datagrams {
  public:
    explicit Tap(Datagrams& inner) : inner_(inner) {}
    bool send(double now_s, const PeerAddress& to,
              std::span<const std::byte> packet) noexcept override {
        if (keeps) {
            sent.emplace_back(packet.begin(), packet.end());
        }
        return !cut && inner_.send(now_s, to, packet);
    }
    [[nodiscard]] std::size_t receive(double now_s, std::span<std::byte> packet,
                                      PeerAddress& from) noexcept override {
        std::size_t size = inner_.receive(now_s, packet, from);
        while (cut && size > 0) {
            size = inner_.receive(now_s, packet, from);
        }
        return size;
    }
    std::vector<std::vector<std::byte>> sent;
    bool keeps = false;
    bool cut = false;  ///< nothing goes through

  private:
    Datagrams& inner_;
};

/// A program's device and an arm that serves `hand`, with faults between them.
struct LinkPair {
    explicit LinkPair(Device& hand, const LinkFaults& faults = {},
                      const ArmServerSettings& server_settings = {},
                      const LinkDeviceSettings& device_settings = {})
        : faulty(faults, channel.end(0)),
          tap(faulty),
          server(server_settings, hand, channel.end(1), seal, arm_numbers),
          device(device_settings, tap, seal, program_numbers) {}

    /// Until the link stands; false when it does not within `within_s`.
    [[nodiscard]] bool link(double within_s = 1.0) {
        for (const double until_s = now_s + within_s; now_s < until_s;) {
            now_s += kStep_s;
            server.step(now_s);
            if (device.greet(now_s) && device.status().linked) {
                return true;
            }
            (void)device.write(now_s, {});
        }
        return false;
    }

    static constexpr double kStep_s = 0.001;
    double now_s = 0.0;
    HmacSeal seal;
    CountedNumbers program_numbers{1000};
    CountedNumbers arm_numbers{2000};
    MemoryChannel channel;
    FaultyDatagrams faulty;
    Tap tap;
    ArmServer server;
    LinkDevice device;
};

}  // namespace fulcrum::test_link
