// Stands in for Force Dimension's libdrd in tests: the functions that the port calls, and no more, in front of a simulated arm.
//
// Written from what dhdc.h and drdc.h of SDK 3.17.5 say of each function (results below 0 are errors; a matrix row after row; status
// fields 5 force, 6 brake, 9 error, 14 cause; a watchdog in steps of 125 us that takes the force away and brakes, cause 3). Frame A: +X to
// the person, +Y right, +Z up, as two clients have it. What is wrong here would be wrong in the port too: no arm was ever asked.
#include "tests/support/maker_libraries/held_arm.h"

#include <limits>

using fulcrum::monotonic_now_s;
using fulcrum::Vector3;
using fulcrum::test_support::HeldArm;

namespace {

constexpr int kUsualType = 33;  // omega.3
constexpr int kUsualSerial = 4711;
constexpr int kNoDevice = 5;          // as dhdErrorGetLast says it
constexpr double kTick_s = 125.0e-6;  // of the watchdog

HeldArm& arm() {
    // Never destroyed: a thread of the port may be in here when the program ends.
    static auto* const kArm = new HeldArm;
    return *kArm;
}

double value_or(const char* what, double usual) {
    const double value = arm().get(what);
    return value != 0.0 ? value : usual;
}

// The force goes off for this reason.
void brake(int cause) {
    arm().feel(Vector3::Zero());
    arm().set("force on", 0.0);
    arm().set("brake", 1.0);
    arm().set("cause", cause);
}

void watch() {
    const double watchdog_s = kTick_s * arm().get("watchdog");
    if (arm().get("force on") != 0.0 && watchdog_s > 0.0 &&
        monotonic_now_s() - arm().get("ordered at") > watchdog_s) {
        brake(3);
    }
}

// True where the arm cannot be reached.
bool is_away() {
    return arm().get("unplugged") != 0.0 || arm().get("open") == 0.0;
}

}  // namespace

extern "C" {

#pragma GCC visibility push(default)

// For tests.
void stand_in_set(const char* what, double value) {
    if (std::string(what) == "brake for") {
        brake(static_cast<int>(value));
        return;
    }
    arm().set(what, value);
}
double stand_in_get(const char* what) {
    return arm().get(what);
}

void dhdGetSDKVersion(int* major, int* minor, int* release, int* revision) {
    *major = 3;
    *minor = static_cast<int>(value_or("minor", 17));
    *release = 5;
    *revision = 0;
}
int dhdErrorGetLast() {
    return kNoDevice;
}
const char* dhdErrorGetLastStr() {
    return "no device found";
}
int drdOpen() {
    if (arm().get("unplugged") != 0.0) {
        return -1;
    }
    arm().set("open", 1.0);
    arm().set("force on", 0.0);
    arm().count("opened");
    return 0;
}
int dhdClose(char /*id*/) {
    arm().set("open", 0.0);
    arm().count("closed");
    return 0;
}
int dhdGetSystemType(char /*id*/) {
    return static_cast<int>(value_or("type", kUsualType));
}
const char* dhdGetSystemName(char /*id*/) {
    return "omega.3";
}
int dhdGetSerialNumber(unsigned short* number, char /*id*/) {
    *number = static_cast<unsigned short>(value_or("serial", kUsualSerial));
    return is_away() || arm().get("tells no number") != 0.0 ? -1 : 0;
}
bool dhdHasActiveWrist(char /*id*/) {
    return arm().get("active wrist") != 0.0;
}
bool dhdIsLeftHanded(char /*id*/) {
    return false;
}
int dhdGetEffectorMass(double* kg, char /*id*/) {
    *kg = 0.19;
    return 0;
}
#ifndef STAND_IN_LACKS_A_FUNCTION
bool drdIsInitialized(char /*id*/) {
    return arm().get("knows no zero") == 0.0;
}
int dhdSetMaxForce(double most_N, char /*id*/) {
    arm().set("most force", most_N);
    return 0;
}
#endif
int drdAutoInit(char /*id*/) {
    arm().count("moved by itself");
    arm().set("knows no zero", arm().get("finds no zero"));
    return arm().get("finds no zero") != 0.0 ? -1 : 0;
}
int drdStop(bool on, char /*id*/) {
    arm().set("regulation stopped", on ? 1.0 : -1.0);
    return 0;
}
int dhdEnableExpertMode() {
    return 0;
}
int dhdSetWatchdog(unsigned char ticks, char /*id*/) {
    arm().set("watchdog", ticks);
    return 0;
}
int dhdSetGravityCompensation(int on, char /*id*/) {
    arm().set("carried", on);
    return 0;
}
int dhdEnableForce(unsigned char on, char /*id*/) {
    arm().set("ordered at", monotonic_now_s());
    // Its own reasons come before an order, as long as a test lets them stay.
    if (arm().get("stays braked") == 0.0) {
        arm().set("force on", on);
        arm().set("brake", 0.0);
        arm().set("cause", on != 0 ? 0.0 : 4.0);
    }
    arm().count(on != 0 ? "switched on" : "switched off");
    return is_away() ? -1 : 0;
}
int dhdGetStatus(int* status, char /*id*/) {
    constexpr int kFields = 17;
    watch();
    for (int i = 0; i < kFields; ++i) {
        status[i] = 0;
    }
    status[5] = static_cast<int>(arm().get("force on"));
    status[6] = static_cast<int>(arm().get("brake"));
    status[9] = static_cast<int>(arm().get("error"));
    status[14] = static_cast<int>(arm().get("cause"));
    return is_away() ? -1 : 0;
}
int dhdGetPositionAndOrientationFrame(double* x, double* y, double* z, double turn[3][3],
                                      char /*id*/) {
    arm().hang("hang s");
    watch();
    const Vector3 position_D = arm().read();
    *x = position_D.z();
    *y = position_D.x();
    *z = position_D.y();
    if (arm().get("no number") != 0.0) {
        *y = std::numeric_limits<double>::quiet_NaN();
    }
    if (arm().get("far away") != 0.0) {
        *z = 1.5;
    }
    // Turned by "turn" about A's own +Z, up, and as skew as "skew" says.
    const double angle = arm().get("turn");
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const double rows[3][3] = {{c, -s, arm().get("skew")}, {s, c, 0.0}, {0.0, 0.0, 1.0}};
    for (int i = 0; i < 9; ++i) {
        turn[i / 3][i % 3] = rows[i / 3][i % 3];
    }
    return is_away() ? -1 : static_cast<int>(arm().get("paced"));
}
unsigned dhdGetButtonMask(char /*id*/) {
    return static_cast<unsigned>(arm().get("buttons"));
}
int dhdSetForceAndTorqueAndGripperForce(double fx, double fy, double fz, double tx, double ty,
                                        double tz, double gripper_N, char /*id*/) {
    watch();
    if (is_away()) {
        return -1;
    }
    arm().set("ordered at", monotonic_now_s());
    arm().set("torque", std::abs(tx) + std::abs(ty) + std::abs(tz) + std::abs(gripper_N));
    arm().feel(arm().get("force on") != 0.0 ? Vector3{fy, fz, fx} : Vector3{0.0, 0.0, 0.0});
    // Also what was ordered while the arm gives none counts.
    if (fx != 0.0 || fy != 0.0 || fz != 0.0) {
        arm().count("asked");
    }
    return arm().get("deaf") != 0.0 ? -1 : 0;
}

#pragma GCC visibility pop

}  // extern "C"
