#include "runtime/arms/hd/hd_library.h"

#include "runtime/arms/maker_library.h"

#include <array>

namespace fulcrum::runtime {
namespace {

// More than any pile that is ever emptied between two ticks.
constexpr int kMostErrors = 32;

auto make_hd_table(HdFunctions& use) {
    return std::array{
        required("hdInitDevice", use.init_device),
        required("hdDisableDevice", use.disable_device),
        required("hdMakeCurrentDevice", use.make_current_device),
        required("hdBeginFrame", use.begin_frame),
        required("hdEndFrame", use.end_frame),
        required("hdEnable", use.enable),
        required("hdDisable", use.disable),
        required("hdIsEnabled", use.is_enabled),
        required("hdGetDoublev", use.get_doubles),
        required("hdGetIntegerv", use.get_integers),
        required("hdGetString", use.get_string),
        required("hdSetDoublev", use.set_doubles),
        required("hdGetError", use.get_error),
        required("hdGetErrorString", use.get_error_string),
        required("hdCheckCalibration", use.check_calibration),
        required("hdUpdateCalibration", use.update_calibration),
        required("hdStartScheduler", use.start_scheduler),
        required("hdStopScheduler", use.stop_scheduler),
        required("hdSetSchedulerRate", use.set_scheduler_rate),
        required("hdScheduleAsynchronous", use.schedule_asynchronous),
        required("hdUnschedule", use.unschedule),
    };
}

}  // namespace

Expected<HdLibrary> load_hd(const std::string& path) {
    HdLibrary library;
    const auto table = make_hd_table(library.use);
    // Version 3.4 uses ncurses without naming it, and where nothing of it is called it is never missed.
    const auto found = open_maker_library(
        {.called = "OpenHaptics' library (libHD)",
         .names = {"libHD.so.3.4", "libHD.so.3", "libHD.so", "libHD.so.3.0"},
         .path = path,
         .how_to_get = "install OpenHaptics 3.4 for Linux and the driver of the Touch, or say with "
                       "--library where its libHD lies",
         .before = {"libncurses.so.6", "libtinfo.so.6"},
         .is_lazy_and_global = true},
        table);
    if (!found) {
        return tl::unexpected(found.error());
    }
    library.found_as = *found;
    return library;
}

std::uint32_t take_hd_errors(const HdFunctions& use, std::uint32_t passed_over) noexcept {
    std::uint32_t newest = hd_no_error;
    for (int i = 0; i < kMostErrors; ++i) {
        const std::uint32_t code = use.get_error().code;
        if (code == hd_no_error) {
            break;
        }
        if (newest == hd_no_error && code != passed_over) {
            newest = code;
        }
    }
    return newest;
}

}  // namespace fulcrum::runtime
