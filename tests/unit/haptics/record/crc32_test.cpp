#include "haptics/record/record.h"

#include <catch2/catch.hpp>

using namespace fulcrum;

TEST_CASE("record: the checksum is CRC-32, also in parts") {
    const char* const text = "123456789";
    const auto bytes = std::as_bytes(std::span(text, 9));
    CHECK(compute_crc32(bytes) == 0xCBF43926U);
    CHECK(compute_crc32(bytes.subspan(4), compute_crc32(bytes.first(4))) == 0xCBF43926U);
}
