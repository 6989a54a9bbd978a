#include "runtime/link/sodium_seal.h"

#include <sodium.h>

namespace fulcrum::runtime {
namespace {

static_assert(kSealBytes == crypto_auth_hmacsha256_BYTES);
static_assert(kArmKeyBytes == crypto_auth_hmacsha256_KEYBYTES);

const unsigned char* raw(std::span<const std::byte> bytes) noexcept {
    return reinterpret_cast<const unsigned char*>(bytes.data());
}

}  // namespace

SodiumSeal::~SodiumSeal() {
    sodium_memzero(key_.data(), key_.size());
}

SealTag SodiumSeal::make(std::span<const std::byte> message) const noexcept {
    SealTag tag;
    crypto_auth_hmacsha256(reinterpret_cast<unsigned char*>(tag.data()), raw(message),
                           message.size(), raw(key_));
    return tag;
}

bool SodiumSeal::holds(std::span<const std::byte> message,
                       std::span<const std::byte, kSealBytes> tag) const noexcept {
    return crypto_auth_hmacsha256_verify(raw(tag), raw(message), message.size(), raw(key_)) == 0;
}

std::uint64_t SodiumNumbers::draw() noexcept {
    std::uint64_t number = 0;
    while (number == 0) {
        randombytes_buf(&number, sizeof number);
    }
    return number;
}

ArmKey draw_arm_key() {
    ArmKey key;
    randombytes_buf(key.data(), key.size());
    return key;
}

}  // namespace fulcrum::runtime
