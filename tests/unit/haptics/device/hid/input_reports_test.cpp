#include "haptics/device/hid/report_bits.h"
#include "haptics/device/hid/report_descriptor.h"
#include "tests/support/hid_descriptors.h"

#include <catch2/catch.hpp>

#include <array>
#include <limits>
#include <rapidcheck.h>
#include <string>

using namespace fulcrum::hid;
using namespace fulcrum;
using test_support::Bytes;
using test_support::DescriptorBuilder;

namespace {

ReportField field_of(std::uint32_t offset, std::uint8_t size, std::int64_t low, std::int64_t high) {
    ReportField field;
    field.bit_offset = offset;
    field.bit_size = size;
    field.logical_min = low;
    field.logical_max = high;
    return field;
}

constexpr std::int64_t kData = 2;      // data, variable, absolute
constexpr std::int64_t kRelative = 6;  // data, variable, relative

ReportDescriptor parsed(const Bytes& bytes) {
    const auto descriptor = ReportDescriptor::parse(bytes);
    INFO((descriptor ? std::string() : to_sentence(descriptor.error())));
    REQUIRE(descriptor);
    return *descriptor;
}

std::string refusal(const Bytes& bytes) {
    const auto descriptor = ReportDescriptor::parse(bytes);
    REQUIRE_FALSE(descriptor);
    return to_sentence(descriptor.error());
}

DescriptorBuilder in_application() {
    DescriptorBuilder d;
    d.page(1).usage(4).open(1);
    return d;
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

TEST_CASE("report descriptor: the mouse of HID 1.11, appendix E.10, bit for bit") {
    // Boot mouse: 3 buttons, 5 bits of padding, X and Y relative.
    const Bytes mouse{0x05, 0x01, 0x09, 0x02, 0xA1, 0x01, 0x09, 0x01, 0xA1, 0x00, 0x05, 0x09, 0x19,
                      0x01, 0x29, 0x03, 0x15, 0x00, 0x25, 0x01, 0x95, 0x03, 0x75, 0x01, 0x81, 0x02,
                      0x95, 0x01, 0x75, 0x05, 0x81, 0x01, 0x05, 0x01, 0x09, 0x30, 0x09, 0x31, 0x15,
                      0x81, 0x25, 0x7F, 0x75, 0x08, 0x95, 0x02, 0x81, 0x06, 0xC0, 0xC0};
    const ReportDescriptor d = parsed(mouse);
    REQUIRE(d.fields().size() == 5);
    CHECK_FALSE(d.numbers_reports());
    CHECK(d.report_bytes(ReportType::input, 0) == 3);
    CHECK(d.report_bytes(ReportType::output, 0) == 0);
    for (std::uint32_t i = 0; i < 3; ++i) {
        CHECK(d.fields()[i].usage == usage_of(9, static_cast<std::uint16_t>(i + 1)));
        CHECK(d.fields()[i].bit_offset == i);
        CHECK(d.fields()[i].bit_size == 1);
        CHECK_FALSE(d.fields()[i].is_relative);
    }
    const ReportField& y = d.fields()[4];
    CHECK(y.usage == usage_of(1, 0x31));
    CHECK(y.bit_offset == 16);
    CHECK(y.is_relative);
    CHECK(y.is_signed());
    CHECK(y.logical_min == -127);
    CHECK(y.logical_max == 127);
    CHECK(d.application_of(y) == usage_of(1, 2));
    CHECK(d.is_within(y, usage_of(1, 1)));
    CHECK_FALSE(d.is_within(y, usage_of(9, 1)));
    REQUIRE(d.collections().size() == 2);
    CHECK(d.collections()[1].parent == 0);
}

TEST_CASE(
    "report descriptor: Push keeps all globals and Pop restores them; locals end at each main "
    "item") {
    auto d = in_application();
    d.logical(-5, 5).fields(8, 1).bare(0xA4);  // Push
    d.page(9).logical(0, 1).fields(1, 8).item(0x64, 0x14).item(0x54, -2).usages(1, 8).input(kData);
    d.bare(0xB4).usage(0x30).input(kData);  // Pop
    d.input(kData).close();                 // no usage: no name
    const ReportDescriptor made = parsed(d.bytes());
    REQUIRE(made.fields().size() == 9);
    CHECK(made.fields()[0].unit == 0x14);
    CHECK(made.fields()[0].unit_exponent == -2);
    const ReportField& x = made.fields()[8];
    CHECK(x.usage == usage_of(1, 0x30));
    CHECK(x.logical_min == -5);
    CHECK(x.bit_size == 8);
    CHECK(x.unit == 0);
    CHECK(x.unit_exponent == 0);
    CHECK(made.report_bytes(ReportType::input, 0) == 3);
}

TEST_CASE(
    "report descriptor: reports of one number follow each other by type, whatever stands between") {
    auto d = in_application();
    d.logical(0, 255).fields(8, 1);
    d.number(1).usage(0x30).input(kData).number(2).usage(0x31).input(kData);
    d.number(1).usage(0x32).output(kData).usage(0x33).input(kData).close();
    const ReportDescriptor made = parsed(d.bytes());
    REQUIRE(made.fields().size() == 4);
    CHECK(made.numbers_reports());
    CHECK(made.fields()[1].bit_offset == 0);
    CHECK(made.fields()[2].bit_offset == 0);
    CHECK(made.fields()[3].bit_offset == 8);
    CHECK(made.fields()[3].report_id == 1);
    CHECK(made.report_bytes(ReportType::input, 1) == 3);
    CHECK(made.report_bytes(ReportType::output, 1) == 2);
    CHECK(made.report_bytes(ReportType::input, 2) == 2);
}

TEST_CASE(
    "report descriptor: the last usage holds for all controls that remain, and a usage with a page "
    "brings its own") {
    auto d = in_application();
    d.logical(0, 1).fields(1, 4).usage(0x30).usage(0x0900AB).input(kData).close();
    const ReportDescriptor made = parsed(d.bytes());
    REQUIRE(made.fields().size() == 4);
    CHECK(made.fields()[0].usage == usage_of(1, 0x30));
    CHECK(made.fields()[1].usage == usage_of(9, 0xAB));
    CHECK(made.fields()[3].usage == usage_of(9, 0xAB));
}

TEST_CASE("report descriptor: an array's value names one of its usages, over several ranges") {
    auto d = in_application();
    d.page(0x0F).logical(1, 5).fields(8, 2).usage(0x26).usages(0x30, 0x32).usage(0x40).output(0);
    const ReportDescriptor made = parsed(d.close().bytes());
    REQUIRE(made.fields().size() == 2);
    const ReportField& array = made.fields()[1];
    CHECK(array.is_array);
    CHECK(array.bit_offset == 8);
    CHECK(made.value_of(array, usage_of(0x0F, 0x26)) == 1);
    CHECK(made.value_of(array, usage_of(0x0F, 0x32)) == 4);
    CHECK(made.value_of(array, usage_of(0x0F, 0x40)) == 5);
    CHECK(made.value_of(array, usage_of(0x0F, 0x27)) == -1);
    CHECK(made.value_of(array, usage_of(1, 0x26)) == -1);
}

TEST_CASE("report descriptor: long items and reserved ones are passed over") {
    auto d = in_application();
    Bytes bytes = d.bytes();
    const Bytes long_item{0xFE, 3, 0xF0, 0x81, 0x02, 0xC0};
    bytes.insert(bytes.end(), long_item.begin(), long_item.end());
    bytes.push_back(0x0C);  // type 3, no data
    DescriptorBuilder rest;
    rest.logical(0, 1).fields(1, 8).usage(0x30).input(kData).close();
    bytes.insert(bytes.end(), rest.bytes().begin(), rest.bytes().end());
    CHECK(parsed(bytes).fields().size() == 8);
}

TEST_CASE("report descriptor: of the names between delimiters the first counts") {
    auto d = in_application();
    d.logical(0, 1).fields(1, 2).item(0xA8, 1).usage(0x30).usage(0x31).item(0xA8, 0).usage(0x32);
    const ReportDescriptor made = parsed(d.input(kData).close().bytes());
    REQUIRE(made.fields().size() == 2);
    CHECK(made.fields()[0].usage == usage_of(1, 0x30));
    CHECK(made.fields()[1].usage == usage_of(1, 0x32));
}

TEST_CASE("report descriptor: a maximum is unsigned unless the minimum lies below zero") {
    auto d = in_application();
    Bytes bytes = d.bytes();
    // Logical Minimum 0, Logical Maximum 0xFF in one byte: 255, as many devices write it.
    const Bytes range{0x15, 0x00, 0x25, 0xFF, 0x75, 0x08, 0x95, 0x01, 0x09, 0x30, 0x81, 0x02, 0xC0};
    bytes.insert(bytes.end(), range.begin(), range.end());
    const ReportField positive = parsed(bytes).fields().at(0);
    CHECK(positive.logical_max == 255);
    CHECK_FALSE(positive.is_signed());

    auto e = in_application();
    e.logical(-128, -1).fields(8, 1).usage(0x30).input(kData).close();
    CHECK(parsed(e.bytes()).fields().at(0).logical_max == -1);
}

TEST_CASE(
    "report descriptor: numbers wider than 32 bits and constants take room and are not kept") {
    auto d = in_application();
    d.logical(0, 1).fields(40, 1).usage(0x30).input(kData).fields(3, 1).usage(0x30).input(3);
    d.fields(5, 1).usage(0x31).input(kData).fields(0, 9).usage(0x31).input(kData).close();
    const ReportDescriptor made = parsed(d.bytes());
    REQUIRE(made.fields().size() == 1);
    CHECK(made.fields()[0].bit_offset == 43);
    CHECK(made.report_bytes(ReportType::input, 0) == 6);
    CHECK_FALSE(made.fields()[0].is_relative);
    auto e = in_application();
    e.logical(0, 1).fields(1, 1).usage(0x30).input(kRelative).close();
    CHECK(parsed(e.bytes()).fields()[0].is_relative);
}

TEST_CASE("report descriptor: what cannot be right is refused, with its place") {
    CHECK(refusal({}).find("it has 0 bytes") != std::string::npos);
    CHECK(refusal(Bytes(kMostDescriptorBytes + 1, 0)).find("4097 bytes") != std::string::npos);
    CHECK(refusal({0xC0}) ==
          "byte 0: the report descriptor is wrong: a collection ends that has not begun; update "
          "the device's firmware, or use another device.");
    CHECK(refusal({0x05, 0x01, 0x26, 0x01}).find("byte 2: ") == 0);
    CHECK(refusal({0xFE, 9, 0, 1}).find("long item") != std::string::npos);
    CHECK(refusal({0xFE}).find("long item") != std::string::npos);
    CHECK(refusal({0xA1, 0x01}).find("not closed") != std::string::npos);
    CHECK(refusal({0xB4}).find("Pop without Push") != std::string::npos);
    CHECK(refusal({0x85, 0x00}).find("number 0") != std::string::npos);
    CHECK(refusal({0x86, 0x00, 0x01}).find("number 256") != std::string::npos);
    CHECK(refusal({0x29, 0x03}).find("without Usage Minimum") != std::string::npos);
    CHECK(refusal({0x19, 0x03, 0x29, 0x01}).find("backwards") != std::string::npos);
    CHECK(refusal({0x1B, 0, 0, 1, 0, 0x2B, 0, 0, 2, 0}).find("two pages") != std::string::npos);

    auto deep = in_application();
    auto pushed = in_application();
    for (std::size_t i = 0; i < kMostDepth; ++i) {
        deep.open(2);
        pushed.bare(0xA4);
    }
    CHECK(refusal(deep.bytes()).find("deep") != std::string::npos);
    CHECK(refusal(pushed.bare(0xA4).bytes()).find("Push more") != std::string::npos);

    auto backwards = in_application();
    backwards.logical(5, 4).fields(8, 1).usage(0x30).input(kData);
    CHECK(refusal(backwards.bytes()).find("maximum 4 lies below the minimum 5") !=
          std::string::npos);
}

TEST_CASE("report descriptor: no few bytes make it large") {
    // 4e9 numbers of 4e9 bits; as many as fit, again and again; all usages there are.
    auto huge = in_application();
    huge.logical(0, 1).fields(0x7FFFFFFF, 0x7FFFFFFF).usage(0x30).input(kData);
    CHECK(refusal(huge.bytes()).find("longer than 4096 bytes") != std::string::npos);

    auto many = in_application();
    many.logical(0, 1).fields(1, 4000);
    for (int i = 0; i < 4; ++i) {
        many.usage(0x30).input(kData);
    }
    CHECK(refusal(many.bytes()).find("more than 4096 numbers") != std::string::npos);

    auto wide = in_application();
    wide.logical(0, 1).fields(1, 8).item(0x18, 0);
    wide.item(0x28, 0xFFFF).input(0).close();
    CHECK(parsed(wide.bytes()).fields().size() == 8);

    auto named = in_application();
    for (std::size_t i = 0; i <= kMostUsageRanges; ++i) {
        named.usage(1);
    }
    CHECK(refusal(named.bytes()).find("more than 1024 usages at once") != std::string::npos);
}

TEST_CASE("report descriptor: every cut of a good one is refused or read, never half read") {
    const Bytes whole = test_support::force_stick_descriptor({});
    REQUIRE(ReportDescriptor::parse(whole));
    for (std::size_t n = 0; n < whole.size(); ++n) {
        // Before its collection begins there is nothing to be wrong.
        const auto cut = ReportDescriptor::parse(std::span(whole).first(n));
        REQUIRE((!cut || (n <= 4 && cut->fields().empty())));
    }
}
