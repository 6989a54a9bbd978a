// fulcrum-is-hand FOLDER: ends with 0 where the hidraw device in that folder of /sys can be a hand, else with 1. udev asks for each that is
// plugged in, whatever its bus (packaging/fulcrum.rules.in), so that who sits at the screen may open those and no others.
#include "haptics/device/hid/hid_ability.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <grp.h>
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

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2 || !give_up_rights()) {
        return 2;
    }
    const std::filesystem::path device = std::filesystem::path(argv[1]) / "device";
    fulcrum::hid::HidNode node;
    std::ifstream file(device / "report_descriptor", std::ios::binary);
    std::array<char, kMostDescriptorBytes> bytes{};
    file.read(bytes.data(), bytes.size());
    node.descriptor.assign(bytes.begin(), bytes.begin() + file.gcount());
    return fulcrum::hid::find_ability(node).form == fulcrum::hid::HandForm::none ? 1 : 0;
}
