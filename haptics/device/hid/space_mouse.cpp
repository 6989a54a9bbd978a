#include "haptics/device/hid/space_mouse.h"

#include <algorithm>
#include <array>

namespace fulcrum::hid {
namespace {

struct Id {
    std::uint16_t vendor;
    std::uint16_t product;
};

constexpr std::array<Id, 11> kSpaceMice{{{0x046d, 0xc626},
                                         {0x046d, 0xc627},
                                         {0x046d, 0xc62b},
                                         {0x256f, 0xc62e},
                                         {0x256f, 0xc632},
                                         {0x256f, 0xc633},
                                         {0x256f, 0xc635},
                                         {0x256f, 0xc638},
                                         {0x256f, 0xc63a},
                                         {0x256f, 0xc641},
                                         {0x256f, 0xc652}}};

constexpr std::size_t kThree = 6;  // bytes of three numbers
constexpr std::size_t kMostButtonBytes = 4;

// Three numbers of the device's frame, in ours.
Vector3 read_three(std::span<const std::uint8_t> bytes, double full) noexcept {
    const auto number = [&](std::size_t i) {
        const auto word = static_cast<std::uint16_t>(bytes[2 * i] | bytes[2 * i + 1] << 8U);
        return std::clamp(static_cast<std::int16_t>(word) / full, -1.0, 1.0);
    };
    return {number(0), -number(2), number(1)};
}

}  // namespace

bool is_space_mouse(std::uint16_t vendor, std::uint16_t product) noexcept {
    return std::any_of(kSpaceMice.begin(), kSpaceMice.end(),
                       [&](const Id& id) { return id.vendor == vendor && id.product == product; });
}

bool take_cap_report(std::span<const std::uint8_t> report, double full, CapState& cap) noexcept {
    if (report.empty()) {
        return false;
    }
    const std::span<const std::uint8_t> data = report.subspan(1);
    switch (report[0]) {
        case 1:
            // Neither kind gives anything between, nor less.
            if (data.size() != kThree && data.size() < 2 * kThree) {
                return false;
            }
            cap.push_D = read_three(data, full);
            if (data.size() >= 2 * kThree) {
                cap.turn_D = read_three(data.subspan(kThree), full);
            }
            return true;
        case 2:
            if (data.size() != kThree) {
                return false;
            }
            cap.turn_D = read_three(data, full);
            return true;
        case 3:
            if (data.empty()) {
                return false;
            }
            cap.buttons = 0;
            for (std::size_t i = 0; i < std::min(data.size(), kMostButtonBytes); ++i) {
                cap.buttons |= std::uint32_t{data[i]} << (8 * i);
            }
            return true;
        default:
            return false;
    }
}

}  // namespace fulcrum::hid
