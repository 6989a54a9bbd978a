#include "runtime/link/sodium_seal.h"

#include "haptics/base/sha256.h"
#include "tests/support/link.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

std::span<const std::byte> bytes_of(std::string_view text) {
    return std::as_bytes(std::span(text));
}

ArmKey key_of(std::uint8_t first) {
    ArmKey key;
    for (std::size_t i = 0; i < key.size(); ++i) {
        key[i] = static_cast<std::byte>(first + i);
    }
    return key;
}

}  // namespace

TEST_CASE("sodium seal: is HMAC-SHA-256, as RFC 4231 has it") {
    // Test case 1 of RFC 4231: key 20 times 0x0B, which zeros make as long as ours; "Hi There".
    ArmKey key{};
    for (std::size_t i = 0; i < 20; ++i) {
        key[i] = std::byte{0x0B};
    }
    const SodiumSeal seal(key);
    CHECK(to_hex(seal.make(bytes_of("Hi There"))) ==
          "b0344c61d8db38535ca8afceaf0bf12b881dc200c9833da726e9376c2e32cff7");
    // Test case 2: "Jefe".
    ArmKey jefe{};
    std::copy_n(bytes_of("Jefe").begin(), 4, jefe.begin());
    CHECK(to_hex(SodiumSeal(jefe).make(bytes_of("what do ya want for nothing?"))) ==
          "5bdcc146bf60754e6a042426089575c75a003f089d2739839dec58b964ec3843");
}

TEST_CASE("sodium seal: agrees with the tests' own, and holds for nothing else") {
    const SodiumSeal seal(key_of(7));
    const test_link::HmacSeal own(7);
    const std::string_view text =
        "any bytes whatever, longer than one block of sixty-four bytes: yes, they are";
    for (std::size_t size = 0; size <= text.size(); ++size) {
        const auto message = bytes_of(text.substr(0, size));
        const SealTag tag = seal.make(message);
        REQUIRE(tag == own.make(message));
        REQUIRE(seal.holds(message, tag));
        SealTag other = tag;
        other[size % other.size()] ^= std::byte{1};
        REQUIRE_FALSE(seal.holds(message, other));
        REQUIRE_FALSE(SodiumSeal(key_of(8)).holds(message, tag));
    }
}

TEST_CASE("sodium seal: session numbers and keys are not drawn twice") {
    SodiumNumbers numbers;
    std::set<std::uint64_t> seen;
    for (int i = 0; i < 1000; ++i) {
        const std::uint64_t number = numbers.draw();
        REQUIRE(number != 0);
        REQUIRE(seen.insert(number).second);
    }
    CHECK(draw_arm_key() != draw_arm_key());
}
