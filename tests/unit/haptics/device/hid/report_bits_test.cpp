#include "haptics/device/hid/report_bits.h"

#include <catch2/catch.hpp>

#include <array>
#include <limits>
#include <rapidcheck.h>

using namespace fulcrum::hid;

namespace {

ReportField field_of(std::uint32_t offset, std::uint8_t size, std::int64_t low, std::int64_t high) {
    ReportField field;
    field.bit_offset = offset;
    field.bit_size = size;
    field.logical_min = low;
    field.logical_max = high;
    return field;
}

}  // namespace

TEST_CASE(
    "report bits: fields of any size at any bit are read as they were written, and nothing else "
    "changes") {
    const bool holds = rc::check("write, then read", [] {
        const auto size = static_cast<std::uint8_t>(*rc::gen::inRange(1, 33));
        const auto offset = static_cast<std::uint32_t>(*rc::gen::inRange(0, 64 - size + 1));
        const bool is_signed = *rc::gen::arbitrary<bool>() && size > 1;
        const std::int64_t low = is_signed ? -(std::int64_t{1} << (size - 1)) : 0;
        const std::int64_t high = low + (std::int64_t{1} << size) - 1;
        const ReportField field = field_of(offset, size, low, high);
        const std::int64_t value = *rc::gen::inRange(low, high);
        const auto before =
            *rc::gen::container<std::array<std::uint8_t, 8>>(rc::gen::arbitrary<std::uint8_t>());
        auto after = before;
        write_value(field, value, after);
        RC_ASSERT(read_value(field, after) == value);
        for (std::uint32_t bit = 0; bit < 64; ++bit) {
            const bool is_inside = bit >= offset && bit < offset + size;
            const auto at = [&](const auto& bytes) { return bytes[bit / 8] >> (bit % 8) & 1; };
            RC_ASSERT(is_inside || at(before) == at(after));
        }
    });
    CHECK(holds);
}

TEST_CASE("report bits: little-endian, two's complement") {
    const std::array<std::uint8_t, 3> data{0xA2, 0xFE, 0x01};
    CHECK(read_value(field_of(0, 16, -350, 350), data) == -350);
    CHECK(read_value(field_of(0, 16, 0, 0xFFFF), data) == 0xFEA2);
    CHECK(read_value(field_of(4, 8, 0, 255), data) == 0xEA);
    CHECK(read_value(field_of(16, 1, 0, 1), data) == 1);
}

TEST_CASE("report bits: what is out of range says nothing, and what is not there neither") {
    const std::array<std::uint8_t, 2> data{0xFF, 0x7F};
    CHECK_FALSE(read_value(field_of(0, 16, -350, 350), data));
    CHECK_FALSE(read_value(field_of(8, 16, 0, 0xFFFF), data));
    CHECK_FALSE(read_value(field_of(0xFFFFFFFF, 8, 0, 255), data));
    std::array<std::uint8_t, 2> written{};
    write_value(field_of(9, 8, 0, 255), 255, written);
    CHECK(written == std::array<std::uint8_t, 2>{});
}

TEST_CASE(
    "report bits: writing holds values within the range, and within what the field can hold") {
    std::array<std::uint8_t, 1> data{};
    write_value(field_of(0, 8, 0, 100), 500, data);
    CHECK(data[0] == 100);
    write_value(field_of(0, 8, -100, 100), -500, data);
    CHECK(static_cast<std::int8_t>(data[0]) == -100);
    write_value(field_of(0, 8, 0, 10000), 300, data);
    CHECK(data[0] == 255);
    write_value(field_of(0, 8, -10000, 10000), -10000, data);
    CHECK(static_cast<std::int8_t>(data[0]) == -128);
    write_value(field_of(0, 8, 3, 7), 0, data);
    CHECK(data[0] == 3);
}

TEST_CASE(
    "report bits: units run from -1 to 1, shares from 0 to 1, physical values by their extents") {
    const ReportField axis = field_of(0, 16, -512, 511);
    CHECK(to_unit(axis, -512) == -1.0);
    CHECK(to_unit(axis, 511) == 1.0);
    CHECK(to_unit(field_of(0, 8, 4, 4), 4) == 0.0);
    const ReportField gain = field_of(0, 8, 0, 255);
    CHECK(from_share(gain, 0.0) == 0);
    CHECK(from_share(gain, 1.0) == 255);
    CHECK(from_share(gain, 7.0) == 255);
    CHECK(from_share(gain, -1.0) == 0);
    CHECK(from_share(gain, std::numeric_limits<double>::quiet_NaN()) == 0);

    // Hundredths of a degree.
    ReportField bearing = field_of(0, 16, 0, 35999);
    bearing.physical_max = 35999;
    bearing.unit_exponent = -2;
    CHECK(from_physical(bearing, 90.0) == 9000);
    // 360 degrees over a byte.
    ReportField coarse = field_of(0, 8, 0, 255);
    coarse.physical_max = 360;
    CHECK(from_physical(coarse, 90.0) == 64);
    CHECK(from_physical(coarse, 1000.0) == 255);
    // Without extents they are the logical ones.
    CHECK(from_physical(field_of(0, 16, 0, 1000), 250.0) == 250);
}
