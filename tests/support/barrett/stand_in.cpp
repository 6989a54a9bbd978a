// The arm of the stand-in for libbarrett: a simulated one that a simulated fingertip holds still.
#include "haptics/base/clock.h"
#include "haptics/device/simulated/simulated_arm.h"

#include <barrett/systems.h>

namespace barrett::stand_in {

using namespace fulcrum;

struct Arm::Parts {
    LatestValue<HandTarget> target;
    SimulatedArm arm{make_desktop_arm(), target};
    double began_s = monotonic_now_s();
};

// Where the handle of a WAM is that stands before somebody, in its base's frame.
constexpr double kAhead_m = 0.5;
constexpr double kUp_m = 0.3;

Arm::Arm() : parts_(new Parts) {
    parts_->target.publish({});
}

Arm::~Arm() = default;

void Arm::read(double (&position_m)[3], double (&turn_wxyz)[4]) {
    DeviceReading reading;
    (void)parts_->arm.read(monotonic_now_s() - parts_->began_s, reading);
    const Vector3& at_D = reading.pose_D.position;
    position_m[0] = kAhead_m + at_D.z();
    position_m[1] = at_D.x();
    position_m[2] = kUp_m + at_D.y();
    turn_wxyz[0] = 1.0;
    turn_wxyz[1] = turn_wxyz[2] = turn_wxyz[3] = 0.0;
}

void Arm::feel(const double (&force_N)[3]) {
    (void)parts_->arm.write(monotonic_now_s() - parts_->began_s,
                            {.force = {force_N[1], force_N[2], force_N[0]}});
}

}  // namespace barrett::stand_in
