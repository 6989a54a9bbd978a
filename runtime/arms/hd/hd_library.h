// The functions and constants of OpenHaptics' device library, HDAPI, that the port uses, by their own declarations: nothing of the maker's
// is needed to build.
//
//   C linkage, x86-64 and arm64 Linux: HHD, HDenum, HDuint and HDerror are 32 bits without sign, HDint 32 bits, HDboolean 8, HDulong and
//   a schedule's handle 64; HDErrorInfo is returned by value; millimetres, newtons; +X right, +Y up, +Z to the person; a matrix column
//   after column
//
// Thread: who opens the arm; hdBeginFrame to hdEndFrame in the library's own thread. Cost: loads a library.
// Source: OpenHaptics 3.0, API Reference Manual (functions, appendix A: constants, errors) and Programmer's Guide, chapter 5 (frames,
// order of calls, axes); its header's sizes. That 3.4 has the same is known only from programs that are built against both.
#pragma once

#include "haptics/base/error.h"

#include <cstdint>
#include <string>

namespace fulcrum::runtime {

struct HdErrorInfo {
    std::uint32_t code = 0;
    std::int32_t internal = 0;
    std::uint32_t arm = 0;
};
static_assert(sizeof(HdErrorInfo) == 12);

using HdCallback = std::uint32_t (*)(void* data);
inline constexpr std::uint32_t kHdDone = 0;   ///< what a callback returns: not again
inline constexpr std::uint32_t kHdAgain = 1;  ///< in the next tick too
inline constexpr std::uint16_t kHdUsualPriority = 32767;
inline constexpr std::uint32_t kHdNoArm = 0xFFFFFFFF;
static_assert(sizeof(unsigned long) == 8);

/// What to ask for, and what to set.
enum HdName : std::uint32_t {
    hd_buttons = 0x2000,
    hd_position = 0x2050,   ///< 3, mm
    hd_transform = 0x2052,  ///< 16, column after column, mm
    hd_model = 0x2501,
    hd_driver = 0x2502,
    hd_serial = 0x2504,
    hd_usable_workspace = 0x2551,  ///< 6: least x, y, z, most x, y, z, mm
    hd_calibration_style = 0x2555,
    hd_max_force = 0x2603,             ///< N, for a while
    hd_max_continuous_force = 0x2604,  ///< N
    hd_force = 0x2700,                 ///< 3, N
    hd_force_output = 0x4000,          ///< can be enabled
};

/// What hdCheckCalibration answers.
enum HdCalibration : std::uint32_t {
    hd_calibrated = 0x5000,
    hd_needs_update = 0x5001,  ///< hdUpdateCalibration can be called now
    hd_needs_person = 0x5002,  ///< a person has to do something first
};

/// What hdGetError answers.
enum HdError : std::uint32_t {
    hd_no_error = 0,
    hd_warm_motors = 0x0200,
    hd_too_much_force = 0x0201,
    hd_too_sudden_force = 0x0202,
    hd_too_fast = 0x0203,
    hd_force_error = 0x0204,
    hd_device_fault = 0x0300,
    hd_already_started = 0x0301,
    hd_no_connection = 0x0302,
    hd_bad_configuration = 0x0303,
    hd_timer = 0x0304,
    hd_scheduler_full = 0x0501,
    hd_no_licence = 0x0600,
};

struct HdFunctions {
    std::uint32_t (*init_device)(const char* name) =
        nullptr;  ///< null: the default; kHdNoArm: none
    void (*disable_device)(std::uint32_t arm) = nullptr;
    void (*make_current_device)(std::uint32_t arm) = nullptr;
    void (*begin_frame)(std::uint32_t arm) = nullptr;  ///< what was set before is forgotten
    void (*end_frame)(std::uint32_t arm) = nullptr;
    void (*enable)(std::uint32_t what) = nullptr;
    void (*disable)(std::uint32_t what) = nullptr;
    std::uint8_t (*is_enabled)(std::uint32_t what) = nullptr;
    void (*get_doubles)(std::uint32_t what, double* values) = nullptr;
    void (*get_integers)(std::uint32_t what, std::int32_t* values) = nullptr;
    const char* (*get_string)(std::uint32_t what) = nullptr;
    void (*set_doubles)(std::uint32_t what, const double* values) = nullptr;
    HdErrorInfo (*get_error)() = nullptr;  ///< the newest, and takes it off the pile
    const char* (*get_error_string)(std::uint32_t code) = nullptr;
    std::uint32_t (*check_calibration)() = nullptr;
    void (*update_calibration)(std::uint32_t style) = nullptr;
    void (*start_scheduler)() = nullptr;
    void (*stop_scheduler)() = nullptr;
    void (*set_scheduler_rate)(unsigned long rate_Hz) = nullptr;
    unsigned long (*schedule_asynchronous)(HdCallback callback, void* data,
                                           std::uint16_t priority) = nullptr;
    void (*unschedule)(unsigned long handle) = nullptr;
};

/// A library that is loaded.
struct HdLibrary {
    HdFunctions use;
    std::string found_as;
};

/// Opens it at `path`, or where `path` is empty by its usual names. Refuses one that is missing or lacks a function.
[[nodiscard]] Expected<HdLibrary> load_hd(const std::string& path);

/// Takes what lies on the library's pile of errors; the newest but for `passed_over`, hd_no_error where there is none.
std::uint32_t take_hd_errors(const HdFunctions& use,
                             std::uint32_t passed_over = hd_no_error) noexcept;

}  // namespace fulcrum::runtime
