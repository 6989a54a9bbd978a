// The functions of Force Dimension's library that the port calls, by their own declarations: nothing of the maker's SDK is needed to build.
//
//   C linkage; `char id` is the arm, as opening it gave; a result below 0 is an error, 0 is good, and 1 (the library paced the call) and
//   2 (a motor is at its limit) are good too; metres, newtons, newton metres, in the arm's own frame A: +X to the person, +Y to the
//   right, +Z up
//   libdrd holds the dhd functions as well. Default arguments of C++ do not exist here: all are passed.
//
// Thread: who opens the arm; the functions are the port's thread's. Cost: loads a library.
// Source: Force Dimension SDK 3.17.5, dhdc.h and drdc.h (functions, results, status fields, types); EmDash00/forcedimension_core-python,
// signatures for 3.14 to 3.16. The frame is as two clients have it; no document of the maker was read for it.
#pragma once

#include "haptics/base/error.h"

#include <array>
#include <string>

namespace fulcrum::runtime {

/// Null where the library lacks an optional one.
struct DhdFunctions {
    void (*get_sdk_version)(int* major, int* minor, int* release, int* revision) = nullptr;
    int (*error_get_last)() = nullptr;
    const char* (*error_get_last_str)() = nullptr;
    int (*open)() = nullptr;  ///< drdOpen: the first arm that is there; its id, or -1
    int (*close)(char id) = nullptr;
    int (*get_system_type)(char id) = nullptr;
    const char* (*get_system_name)(char id) = nullptr;
    int (*get_serial_number)(unsigned short* number, char id) = nullptr;
    bool (*has_active_wrist)(char id) = nullptr;
    bool (*is_left_handed)(char id) = nullptr;
    int (*get_effector_mass)(double* kg, char id) = nullptr;
    bool (*is_initialized)(char id) = nullptr;
    int (*auto_init)(char id) = nullptr;                 ///< moves the arm by itself
    int (*stop_regulation)(bool on, char id) = nullptr;  ///< drdStop; true: forces stay possible
    int (*enable_expert_mode)() = nullptr;
    int (*set_watchdog)(unsigned char ticks, char id) = nullptr;  ///< of kDhdTick_s; optional
    int (*set_gravity_compensation)(int on, char id) = nullptr;
    int (*set_max_force)(double most_N, char id) = nullptr;    ///< optional
    int (*set_max_torque)(double most_Nm, char id) = nullptr;  ///< optional
    int (*enable_force)(unsigned char on, char id) = nullptr;
    int (*get_status)(int* status, char id) = nullptr;  ///< DhdStatus
    int (*get_position_and_orientation)(double* x, double* y, double* z, double turn[3][3],
                                        char id) = nullptr;  ///< turn: row after row
    unsigned (*get_button_mask)(char id) = nullptr;
    int (*set_force)(double fx, double fy, double fz, double tx, double ty, double tz,
                     double gripper_N, char id) = nullptr;
};

/// 3.17 fills 17 fields; a later library may fill more.
using DhdStatus = std::array<int, 32>;
inline constexpr std::size_t kDhdForceOn = 5;
inline constexpr std::size_t kDhdBrake = 6;
inline constexpr std::size_t kDhdError = 9;
inline constexpr std::size_t kDhdOffCause =
    14;  ///< why the force is off: DhdTrouble has the numbers

/// Step of the watchdog: without an order for so many the arm takes its force away itself, and brakes.
inline constexpr double kDhdTick_s = 125.0e-6;

/// A library that is loaded.
struct DhdLibrary {
    DhdFunctions use;
    std::string found_as;
    std::string version;  ///< "3.17.5"
};

/// The arm's number; 0 of one that tells none.
[[nodiscard]] unsigned short ask_dhd_serial(const DhdFunctions& use, char id) noexcept;

/// Opens it at `path`, or where `path` is empty by its usual names. Refuses one that is missing, lacks a function or is older than 3.14.
[[nodiscard]] Expected<DhdLibrary> load_dhd(const std::string& path);

}  // namespace fulcrum::runtime
