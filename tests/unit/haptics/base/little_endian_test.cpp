#include "haptics/base/little_endian.h"

#include <catch2/catch.hpp>

#include <array>
#include <cstdint>
#include <limits>

using namespace fulcrum;

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
