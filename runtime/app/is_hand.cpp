// fulcrum-is-hand FOLDER: ends with 0 where the hidraw device in that folder of /sys can be a hand, else with 1. udev asks for each that is
// plugged in, whatever its bus (packaging/fulcrum.rules.in), so that who sits at the screen may open those and no others.
#include "haptics/device/hid/hid_ability.h"

#include <array>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <grp.h>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <unistd.h>
#include <vector>

namespace {

constexpr std::size_t kMostDescriptorBytes = 4096;  // HID_MAX_DESCRIPTOR_SIZE of linux/hid.h
constexpr unsigned kNobody = 65534;

// What a device says of itself needs no rights to be read, and gets none.
bool give_up_rights() {
    return geteuid() != 0 ||
           (setgroups(0, nullptr) == 0 && setresgid(kNobody, kNobody, kNobody) == 0 &&
            setresuid(kNobody, kNobody, kNobody) == 0);
}

std::optional<std::uint16_t> read_number(std::string_view text) {
    std::uint32_t number = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), number, 16);
    if (read.ec != std::errc{} || read.ptr != text.data() + text.size() || number > 0xFFFF) {
        return std::nullopt;
    }
    return static_cast<std::uint16_t>(number);
}

// Of the line "HID_ID=0003:0000046D:0000C626": bus, vendor, product.
void read_ids(const std::filesystem::path& file, fulcrum::hid::HidNode& node) {
    constexpr std::string_view kIds = "HID_ID=";
    std::ifstream lines(file);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t vendor = line.find(':');
        const std::size_t product = line.rfind(':');
        if (line.starts_with(kIds) && vendor < product) {
            const std::string_view text = line;
            node.vendor = read_number(text.substr(vendor + 1, product - vendor - 1)).value_or(0);
            node.product = read_number(text.substr(product + 1)).value_or(0);
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2 || !give_up_rights()) {
        return 2;
    }
    const std::filesystem::path device = std::filesystem::path(argv[1]) / "device";
    fulcrum::hid::HidNode node;
    read_ids(device / "uevent", node);
    std::ifstream file(device / "report_descriptor", std::ios::binary);
    std::array<char, kMostDescriptorBytes> bytes{};
    file.read(bytes.data(), bytes.size());
    node.descriptor.assign(bytes.begin(), bytes.begin() + file.gcount());
    return fulcrum::hid::find_ability(node).form == fulcrum::hid::HandForm::none ? 1 : 0;
}
