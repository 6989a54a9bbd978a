#include "runtime/arms/dhd/dhd_library.h"

#include "runtime/arms/maker_library.h"

#include <vector>

namespace fulcrum::runtime {
namespace {

// The oldest whose signatures were read.
constexpr int kOldestDhdMajor = 3;
constexpr int kOldestDhdMinor = 14;
constexpr const char* kGetDhd =
    "install Force Dimension's SDK 3.14 or later (and libusb-1.0), or say with --library where its "
    "libdrd lies";

std::vector<MakerFunction> make_dhd_table(DhdFunctions& use) {
    return {
        required("dhdGetSDKVersion", use.get_sdk_version),
        required("dhdErrorGetLast", use.error_get_last),
        required("dhdErrorGetLastStr", use.error_get_last_str),
        required("drdOpen", use.open),
        required("dhdClose", use.close),
        required("dhdGetSystemType", use.get_system_type),
        required("dhdGetSystemName", use.get_system_name),
        required("dhdGetSerialNumber", use.get_serial_number),
        required("dhdHasActiveWrist", use.has_active_wrist),
        required("dhdIsLeftHanded", use.is_left_handed),
        if_there("dhdGetEffectorMass", use.get_effector_mass),
        required("drdIsInitialized", use.is_initialized),
        required("drdAutoInit", use.auto_init),
        required("drdStop", use.stop_regulation),
        required("dhdEnableExpertMode", use.enable_expert_mode),
        if_there("dhdSetWatchdog", use.set_watchdog),
        required("dhdSetGravityCompensation", use.set_gravity_compensation),
        if_there("dhdSetMaxForce", use.set_max_force),
        if_there("dhdSetMaxTorque", use.set_max_torque),
        required("dhdEnableForce", use.enable_force),
        required("dhdGetStatus", use.get_status),
        required("dhdGetPositionAndOrientationFrame", use.get_position_and_orientation),
        required("dhdGetButtonMask", use.get_button_mask),
        required("dhdSetForceAndTorqueAndGripperForce", use.set_force),
    };
}

}  // namespace

unsigned short ask_dhd_serial(const DhdFunctions& use, char id) noexcept {
    unsigned short serial = 0;
    return use.get_serial_number(&serial, id) >= 0 ? serial : static_cast<unsigned short>(0);
}

Expected<DhdLibrary> load_dhd(const std::string& path) {
    DhdLibrary library;
    const std::vector<MakerFunction> table = make_dhd_table(library.use);
    const auto found = open_maker_library({.called = "Force Dimension's library (libdrd)",
                                           .names = {"libdrd.so.3", "libdrd.so"},
                                           .path = path,
                                           .how_to_get = kGetDhd,
                                           .before = {}},
                                          table);
    if (!found) {
        return tl::unexpected(found.error());
    }
    int major = 0;
    int minor = 0;
    int release = 0;
    int revision = 0;
    library.use.get_sdk_version(&major, &minor, &release, &revision);
    library.found_as = *found;
    library.version =
        std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(release);
    if (major < kOldestDhdMajor || (major == kOldestDhdMajor && minor < kOldestDhdMinor)) {
        return fail(
            "Force Dimension's library is of version " + library.version + ", which is too old",
            library.found_as, kGetDhd);
    }
    return library;
}

}  // namespace fulcrum::runtime
