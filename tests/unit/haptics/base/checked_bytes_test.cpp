#include "haptics/base/bounded_list.h"
#include "haptics/base/crc32.h"
#include "haptics/base/error.h"
#include "haptics/base/little_endian.h"
#include "haptics/base/range.h"
#include "haptics/base/sha256.h"
#include "haptics/math/split_mix.h"
#include "tests/support/bad_numbers.h"

#include <catch2/catch.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

using namespace fulcrum;

namespace {

// Bit by bit, as ISO 3309 has it.
std::uint32_t crc32_by_bits(std::span<const std::byte> bytes) {
    std::uint32_t rest = 0xFFFFFFFFU;
    for (const std::byte byte : bytes) {
        rest ^= static_cast<std::uint32_t>(byte);
        for (int bit = 0; bit < 8; ++bit) {
            rest = (rest >> 1U) ^ ((rest & 1U) != 0 ? 0xEDB88320U : 0U);
        }
    }
    return ~rest;
}

std::vector<std::byte> random_bytes(std::size_t n) {
    SplitMix chance(n + 1);
    std::vector<std::byte> bytes(n);
    for (std::byte& byte : bytes) {
        byte = static_cast<std::byte>(chance.draw_chance() * 256.0);
    }
    return bytes;
}

std::string hash(std::string_view text) {
    return to_hex(compute_sha256(std::as_bytes(std::span(text))));
}

}  // namespace

TEST_CASE(
    "crc32: the check value of the standard; of parts, however it is cut, that of the whole") {
    const char* const text = "123456789";
    const auto bytes = std::as_bytes(std::span(text, 9));
    CHECK(compute_crc32(bytes) == 0xCBF43926U);
    CHECK(compute_crc32(bytes.subspan(4), compute_crc32(bytes.first(4))) == 0xCBF43926U);
    CHECK(compute_crc32({}) == 0);
    const std::vector<std::byte> all = random_bytes(257);
    const std::uint32_t right = crc32_by_bits(all);
    for (std::size_t cut = 0; cut <= all.size(); ++cut) {
        const auto both = std::span(all);
        CAPTURE(cut);
        REQUIRE(compute_crc32(both.subspan(cut), compute_crc32(both.first(cut))) == right);
    }
}

TEST_CASE("crc32: by products, by tables and bit by bit it is the same at every length and place") {
    const std::vector<std::byte> all = random_bytes(600);
    for (std::size_t n = 0; n <= 300; ++n) {
        const std::size_t first = n % 19;
        const auto bytes = std::span(all).subspan(first, n);
        const std::uint32_t right = crc32_by_bits(bytes);
        CAPTURE(n);
        REQUIRE(compute_crc32(bytes) == right);
        REQUIRE(compute_crc32_by_tables(bytes) == right);
    }
}

TEST_CASE("crc32: one bit that is turned is told, wherever it stands") {
    std::vector<std::byte> bytes = random_bytes(300);
    const std::uint32_t right = compute_crc32(bytes);
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
        const auto mask = static_cast<std::byte>(1U << (bit % 8));
        bytes[bit / 8] ^= mask;
        REQUIRE(compute_crc32(bytes) != right);
        bytes[bit / 8] ^= mask;
    }
}

// NIST's examples for FIPS 180: one block, two blocks, none at all, and the million letters of its long message.
TEST_CASE("sha256: the standard's examples; in parts of any length it is the same") {
    CHECK(hash("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    CHECK(hash("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
          "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    CHECK(hash("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    const std::string long_one(1'000'000, 'a');
    CHECK(hash(long_one) == "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
    std::vector<std::byte> bytes(300);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        bytes[i] = static_cast<std::byte>(7 * i & 0xFFU);
    }
    for (std::size_t length : {0U, 1U, 55U, 56U, 63U, 64U, 65U, 119U, 128U, 300U}) {
        const std::span<const std::byte> all(bytes.data(), length);
        for (std::size_t part : {1U, 13U, 64U, 65U}) {
            Sha256 parts;
            for (std::size_t at = 0; at < length; at += part) {
                parts.add(all.subspan(at, std::min(part, length - at)));
            }
            CHECK(parts.finish() == compute_sha256(all));
        }
    }
}

TEST_CASE("little endian: the least byte comes first, at any place, and nothing else is written") {
    std::array<std::byte, 11> bytes;
    bytes.fill(std::byte{0xEE});
    put_little_endian(std::uint64_t{0x0807060504030201U}, bytes.data() + 1);
    CHECK(bytes[0] == std::byte{0xEE});
    for (std::size_t i = 1; i <= 8; ++i) {
        CHECK(bytes[i] == static_cast<std::byte>(i));
    }
    CHECK(bytes[9] == std::byte{0xEE});
    CHECK(get_little_endian<std::uint64_t>(bytes.data() + 1) == 0x0807060504030201U);
    CHECK(get_little_endian<std::uint32_t>(bytes.data() + 2) == 0x05040302U);
    CHECK(get_little_endian<std::uint16_t>(bytes.data() + 3) == 0x0403U);
    CHECK(get_little_endian<std::uint8_t>(bytes.data() + 4) == 4U);
}

TEST_CASE("little endian: what was put is what one gets, of every width") {
    std::array<std::byte, 8> bytes{};
    const auto returns = [&bytes](auto value) {
        put_little_endian(value, bytes.data());
        return get_little_endian<decltype(value)>(bytes.data()) == value;
    };
    CHECK(returns(std::uint8_t{0x81}));
    CHECK(returns(std::uint16_t{0x8001}));
    CHECK(returns(std::uint32_t{0x80000001}));
    CHECK(returns(std::numeric_limits<std::uint64_t>::max()));
    CHECK(returns(std::uint64_t{0}));
}

TEST_CASE("bounded list: takes what it has room for, gives it back, and begins anew") {
    BoundedList<int> list(3);
    CHECK(list.count() == 0);
    CHECK(list.add(4));
    CHECK(list.add(5));
    CHECK(list.add(6));
    CHECK_FALSE(list.add(7));
    REQUIRE(list.all().size() == 3);
    CHECK(list.all()[1] == 5);
    CHECK(list.take_last() == 6);
    CHECK(list.count() == 2);
    list.set_count(9);
    CHECK(list.count() == 3);
    list.clear();
    CHECK(list.all().empty());
    CHECK(list.capacity() == 3);
    BoundedList<int> none(-1);
    CHECK_FALSE(none.add(1));
}

TEST_CASE("range: both bounds are inside, the first number that is not is named with its bounds") {
    const auto check = [](double first, double second) {
        const Range ranges[] = {{"length", first, -1.0, 2.0},
                                {"width in metres", second, 0.5, 0.5}};
        return check_ranges("the box's", ranges);
    };
    CHECK(check(-1.0, 0.5));
    CHECK(check(2.0, 0.5));
    CHECK(check_ranges("nobody's", {}));
    const auto refused = check(2.5, 0.6);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().message == "the box's length is 2.5, outside the range -1 to 2");
    CHECK(refused.error().what_to_do == "set it within that range");
    CHECK(check(0.0, 0.4).error().message ==
          "the box's width in metres is 0.4, outside the range 0.5 to 0.5");
    CHECK_FALSE(check(kNan, 0.5));
    CHECK_FALSE(check(-kInfinity, 0.5));
}

TEST_CASE("error: one sentence says where, what and what to do; empty parts leave no trace") {
    CHECK(to_sentence({"the mesh has no triangle", "apple.glb:3", "export it again"}) ==
          "apple.glb:3: the mesh has no triangle; export it again.");
    CHECK(to_sentence({"the mesh has no triangle", "", ""}) == "the mesh has no triangle.");
    CHECK(to_sentence({"there is no mas; did you mean mass?", "a:1", ""}) ==
          "a:1: there is no mas; did you mean mass?");
    CHECK(to_sentence({"stop", "", "let go!"}) == "stop; let go!");
    CHECK(to_sentence({"it ended.", "", ""}) == "it ended.");
    CHECK(to_sentence({}) == ".");
    const Expected<int> failed = fail("a", "b", "c");
    REQUIRE_FALSE(failed);
    CHECK(to_sentence(failed.error()) == "b: a; c.");
}
