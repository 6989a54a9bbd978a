// Stands in for OpenHaptics' libHD in tests: the functions that the port calls, and no more, in front of a simulated arm.
//
// Written from the API Reference Manual and the Programmer's Guide of OpenHaptics 3.0: a pile of errors, newest first; a frame that
// begins forgets the force; force needs force output enabled and the scheduler running; millimetres; a matrix column after column;
// calibration 0x5000 to 0x5002, of which 0x5001 is what hdUpdateCalibration ends. What is wrong here would be wrong in the port too: no
// arm was ever asked.
#include "tests/support/maker_libraries/held_arm.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <vector>

using fulcrum::Vector3;
using fulcrum::test_support::HeldArm;

namespace {

using Callback = std::uint32_t (*)(void*);

struct ErrorInfo {
    std::uint32_t code = 0;
    std::int32_t internal = 0;
    std::uint32_t arm = 0;
};

constexpr std::uint32_t kNoArm = 0xFFFFFFFF;
constexpr std::uint32_t kArm = 7;
constexpr std::uint32_t kForceOutput = 0x4000;

struct Library {
    HeldArm arm;
    std::mutex mutex;  // of the pile
    std::vector<std::uint32_t> errors;
    std::mutex tick;  // held while the callback runs
    Callback callback = nullptr;
    void* data = nullptr;
    std::atomic<bool> runs{false};
    bool is_in_frame = false;  // the scheduler's thread's, or a test's
    Vector3 frame_force{Vector3::Zero()};
};

Library& library() {
    // Never destroyed: its thread may run when the program ends.
    static auto* const kLibrary = new Library;
    return *kLibrary;
}

HeldArm& arm() {
    return library().arm;
}

double value_or(const char* what, double usual) {
    const double value = arm().get(what);
    return value != 0.0 ? value : usual;
}

void raise(std::uint32_t code) {
    const std::scoped_lock lock(library().mutex);
    library().errors.push_back(code);
    // Of these the manual says that the force stops.
    if (code >= 0x0201 && code <= 0x0203) {
        arm().set("force output", 0.0);
    }
}

void run_scheduler() {
    constexpr auto kTick = std::chrono::milliseconds(1);
    auto next = std::chrono::steady_clock::now();
    while (library().runs) {
        if (arm().get("stalled") == 0.0) {
            const std::scoped_lock lock(library().tick);
            if (library().callback != nullptr && library().callback(library().data) == 0) {
                library().callback = nullptr;
            }
        }
        next = std::max(next + kTick, std::chrono::steady_clock::now());
        std::this_thread::sleep_until(next);
    }
    arm().feel(Vector3::Zero());
    arm().set("ended", 1.0);
}

void write_transform(const Vector3& position_D, double* m) {
    // Turned by "turn" about +Y; column after column, the last the place.
    const double c = std::cos(arm().get("turn"));
    const double s = std::sin(arm().get("turn"));
    const double columns[16] = {c,
                                0.0,
                                -s,
                                0.0,
                                arm().get("skew"),
                                1.0,
                                0.0,
                                0.0,
                                s,
                                0.0,
                                c,
                                0.0,
                                1e3 * position_D.x(),
                                1e3 * position_D.y(),
                                1e3 * position_D.z(),
                                1.0};
    std::memcpy(m, columns, sizeof columns);
}

}  // namespace

extern "C" {

#pragma GCC visibility push(default)

// For tests.
void stand_in_set(const char* what, double value) {
    if (std::string(what) == "raise") {
        raise(static_cast<std::uint32_t>(value));
        return;
    }
    arm().set(what, value);
}
double stand_in_get(const char* what) {
    return arm().get(what);
}

std::uint32_t hdInitDevice(const char* name) {
    arm().count("tries");
    const bool is_refused =
        arm().get("no arm") != 0.0 || (name == nullptr && arm().get("no null name") != 0.0);
    if (is_refused) {
        raise(static_cast<std::uint32_t>(value_or("why no arm", 0x0302)));
        return kNoArm;
    }
    arm().set("open", 1.0);
    return kArm;
}
void hdDisableDevice(std::uint32_t which) {
    if (which == kArm) {
        arm().set("open", 0.0);
    }
}
void hdMakeCurrentDevice(std::uint32_t /*which*/) {}
#ifndef STAND_IN_LACKS_A_FUNCTION
void hdBeginFrame(std::uint32_t /*which*/) {
    library().is_in_frame = true;
    library().frame_force = Vector3::Zero();
}
#endif
void hdEndFrame(std::uint32_t /*which*/) {
    library().is_in_frame = false;
    const bool gives = arm().get("force output") != 0.0 && arm().get("scheduler") != 0.0;
    arm().feel(gives ? library().frame_force : Vector3{0.0, 0.0, 0.0});
}
void hdEnable(std::uint32_t what) {
    if (what == kForceOutput) {
        arm().set("force output", 1.0);
        arm().count("switched on");
    }
}
void hdDisable(std::uint32_t what) {
    if (what == kForceOutput) {
        arm().set("force output", 0.0);
    }
}
std::uint8_t hdIsEnabled(std::uint32_t what) {
    return what == kForceOutput && arm().get("force output") != 0.0 ? 1 : 0;
}
void hdGetDoublev(std::uint32_t what, double* values) {
    if (arm().get("tells nothing") != 0.0) {
        return;
    }
    const double box_mm[6] = {-80.0, -60.0, -35.0, 80.0, 60.0, 35.0};
    switch (what) {
        case 0x2050: {
            arm().hang("hang s");
            const Vector3 position_mm = 1e3 * arm().read();
            const double factor = arm().get("far away") != 0.0 ? 1.0e4 : 1.0;
            for (int i = 0; i < 3; ++i) {
                values[i] = factor * position_mm[i];
            }
            break;
        }
        case 0x2052:
            write_transform({arm().get("at x"), arm().get("at y"), arm().get("at z")}, values);
            break;
        case 0x2551:
            std::memcpy(values, box_mm, sizeof box_mm);
            break;
        case 0x2603:
            *values = value_or("most", 3.3);
            break;
        case 0x2604:
            *values = 0.88;
            break;
        default:
            raise(0x0100);
    }
}
void hdGetIntegerv(std::uint32_t what, std::int32_t* values) {
    *values = what == 0x2000   ? static_cast<std::int32_t>(arm().get("buttons"))
              : what == 0x2555 ? static_cast<std::int32_t>(value_or("styles", 4))
                               : -1;
}
const char* hdGetString(std::uint32_t what) {
    return what == 0x2501   ? "Touch"
           : what == 0x2502 ? "2023.11.15"
           : what == 0x2504 ? "50012345678"
                            : nullptr;
}
void hdSetDoublev(std::uint32_t what, const double* values) {
    if (what != 0x2700 || !library().is_in_frame) {
        raise(0x0102);
        return;
    }
    library().frame_force = {values[0], values[1], values[2]};
    if (library().frame_force != Vector3::Zero()) {
        arm().count("asked");
    }
}
ErrorInfo hdGetError() {
    const std::scoped_lock lock(library().mutex);
    ErrorInfo info;
    if (!library().errors.empty()) {
        info.code = library().errors.back();
        library().errors.pop_back();
    }
    return info;
}
const char* hdGetErrorString(std::uint32_t code) {
    return code == 0x0302 ? "communication error" : "another error";
}
std::uint32_t hdCheckCalibration() {
    return static_cast<std::uint32_t>(value_or("calibration", 0x5000));
}
void hdUpdateCalibration(std::uint32_t style) {
    arm().set("style", style);
    arm().count("updates");
    if (arm().get("calibration") == 0x5001) {
        arm().set("calibration", 0x5000);
    }
}
void hdSetSchedulerRate(unsigned long rate_Hz) {
    arm().set("rate", static_cast<double>(rate_Hz));
}
void hdStartScheduler() {
    raise(0x0304);
    arm().set("ended", 0.0);
    arm().set("scheduler", 1.0);
    library().runs = true;
    std::thread(run_scheduler).detach();
}
void hdStopScheduler() {
    library().runs = false;
    arm().set("scheduler", 0.0);
}
unsigned long hdScheduleAsynchronous(Callback callback, void* data, std::uint16_t priority) {
    arm().set("priority", priority);
    const std::scoped_lock lock(library().tick);
    library().callback = callback;
    library().data = data;
    return 1;
}
void hdUnschedule(unsigned long /*handle*/) {
    arm().count("unscheduled");
    if (arm().get("unschedules at once") != 0.0) {
        return;
    }
    const std::scoped_lock lock(library().tick);
    library().callback = nullptr;
}

#pragma GCC visibility pop

}  // extern "C"
