#include "tests/support/hid_descriptors.h"

namespace fulcrum::test_support {
namespace {

constexpr std::int64_t kApplication = 1;
constexpr std::int64_t kLogical = 2;
constexpr std::int64_t kPhysicalKind = 0;
constexpr std::int64_t kVariable = 2;  // data, variable, absolute
constexpr std::int64_t kArray = 0;
constexpr std::int64_t kConstant = 3;

// Numbers of one size that PID reports are made of.
void index_of(DescriptorBuilder& d) {
    d.usage(0x22).logical(1, 40).physical(1, 40).fields(8, 1).output(kVariable);
}

void array_of(DescriptorBuilder& d, std::int64_t collection, std::int64_t first, std::int64_t last,
              bool feature) {
    d.usage(collection).open(kLogical);
    for (std::int64_t u = first; u <= last; ++u) {
        d.usage(u);
    }
    d.logical(1, last - first + 1).physical(1, last - first + 1).fields(8, 1);
    feature ? d.feature(kArray) : d.output(kArray);
    d.close();
}

void set_effect(DescriptorBuilder& d, const ForceStickShape& shape, std::int64_t id) {
    d.usage(0x21).open(kLogical).number(id);
    index_of(d);
    array_of(d, 0x25, 0x26, 0x2C, false);
    d.usage(0x50).usage(0x54).usage(0x51).logical(0, 0x7FFF).physical(0, 0x7FFF);
    if (shape.has_units) {
        d.item(0x64, 0x1003).item(0x54, -3);  // seconds, thousandths
    }
    d.fields(16, 3).output(kVariable).item(0x54, 0).item(0x64, 0);
    d.usage(0x52).logical(0, 255).physical(0, 255).fields(8, 1).output(kVariable);
    d.usage(0x53).logical(1, 8).physical(1, 8).fields(8, 1).output(kVariable);
    d.usage(0x55).open(kLogical).page(1).usage(0x30);
    if (shape.has_y) {
        d.usage(0x31);
    }
    const int n_axes = shape.has_y ? 2 : 1;
    d.logical(0, 1).physical(0, 1).fields(1, n_axes).output(kVariable).page(0x0F).close();
    const int n_flags = n_axes + (shape.by_axes ? 0 : 1);
    if (!shape.by_axes) {
        d.usage(0x56).fields(1, 1).output(kVariable);
    }
    d.fields(1, 8 - n_flags).output(kConstant);
    d.usage(0x57).open(kLogical).usage(0x0A0001).usage(0x0A0002);
    if (shape.has_units) {
        d.item(0x64, 0x14).item(0x54, -2).logical(0, 35999).physical(0, 35999);
        d.fields(16, 2).output(kVariable).item(0x54, 0).item(0x64, 0);
    } else {
        d.logical(0, 0xFFFF).physical(0, 0xFFFF).fields(16, 2).output(kVariable);
    }
    d.close().close();
}

}  // namespace

DescriptorBuilder& DescriptorBuilder::bare(std::uint8_t prefix) {
    bytes_.push_back(prefix);
    return *this;
}

DescriptorBuilder& DescriptorBuilder::item(std::uint8_t prefix, std::int64_t value) {
    const int size = value >= -128 && value <= 127 ? 1 : value >= -32768 && value <= 32767 ? 2 : 4;
    bytes_.push_back(static_cast<std::uint8_t>(prefix | (size == 4 ? 3 : size)));
    for (int i = 0; i < size; ++i) {
        bytes_.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
    }
    return *this;
}

DescriptorBuilder& DescriptorBuilder::logical(std::int64_t low, std::int64_t high) {
    return item(0x14, low).item(0x24, high);
}

Bytes space_mouse_descriptor(bool one_report) {
    DescriptorBuilder d;
    d.page(1).usage(8).open(kApplication);
    d.usage(1).open(kPhysicalKind).number(1).logical(-350, 350).physical(-1400, 1400);
    d.item(0x54, 12).item(0x64, 0x11);
    if (one_report) {
        d.usage(0x30).usage(0x31).usage(0x32).usage(0x33).usage(0x34).usage(0x35);
        d.fields(16, 6).input(kVariable).close();
    } else {
        d.usage(0x30).usage(0x31).usage(0x32).fields(16, 3).input(kVariable).close();
        d.usage(0).open(kPhysicalKind).number(2).usage(0x33).usage(0x34).usage(0x35);
        d.fields(16, 3).input(kVariable).close();
    }
    d.open(kLogical).number(3).page(1).page(9).usages(1, 2).logical(0, 1).physical(0, 1);
    d.fields(1, 2).input(kVariable).fields(1, 14).input(kConstant).close();
    return d.close().bytes();
}

Bytes plain_stick_descriptor() {
    DescriptorBuilder d;
    d.page(1).usage(4).open(kApplication).usage(1).open(kPhysicalKind);
    d.usage(0x30).usage(0x31).usage(0x36).logical(0, 255).fields(8, 3).input(kVariable).close();
    d.page(9).usages(1, 4).logical(0, 1).fields(1, 4).input(kVariable).input(kConstant);
    return d.close().bytes();
}

Bytes force_stick_descriptor(const ForceStickShape& shape) {
    const std::int64_t id = shape.first_report;
    DescriptorBuilder d;
    d.page(1).usage(4).open(kApplication).number(id);
    // Input: X, Y of 16 bits, a throttle of 8, 8 buttons.
    d.usage(1).open(kPhysicalKind).usage(0x30).usage(0x31).logical(-512, 511).fields(16, 2);
    d.input(kVariable).page(2).usage(0xBB).logical(0, 255).fields(8, 1).input(kVariable);
    d.page(9).usages(1, 8).logical(0, 1).fields(1, 8).input(kVariable).close();

    d.page(0x0F);
    set_effect(d, shape, id + 1);
    d.usage(0x73).open(kLogical).number(id + 2);
    index_of(d);
    d.usage(0x70).logical(-shape.magnitude, shape.magnitude);
    d.physical(-shape.magnitude, shape.magnitude).fields(16, 1).output(kVariable).close();
    d.usage(0x77).open(kLogical).number(id + 3);
    index_of(d);
    array_of(d, 0x78, 0x79, 0x7B, false);
    d.usage(0x7C).logical(0, 255).physical(0, 255).fields(8, 1).output(kVariable).close();
    d.usage(0x95).open(kLogical).number(id + 4);
    array_of(d, 0x96, 0x97, 0x9C, false);
    d.close();
    d.usage(0x7D).open(kLogical).number(id + 5).usage(0x7E).logical(0, 255).physical(0, 10000);
    d.fields(8, 1).output(kVariable).close();
    d.usage(0x90).open(kLogical).number(id + 6);
    index_of(d);
    d.close();

    d.usage(0xAB).open(kLogical).number(id + 7);
    array_of(d, 0x25, 0x26, 0x2C, shape.features_made);
    d.close();
    d.usage(0x89).open(kLogical).number(id + 8).usage(0x22).logical(1, 40).physical(1, 40);
    d.fields(8, 1).feature(kVariable);
    array_of(d, 0x8B, 0x8C, 0x8E, true);
    d.usage(0xAC).logical(0, 0xFFFF).physical(0, 0xFFFF).fields(16, 1).feature(kVariable).close();
    return d.close().bytes();
}

}  // namespace fulcrum::test_support
