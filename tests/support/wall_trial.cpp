#include "tests/support/wall_trial.h"

#include "haptics/coupling/virtual_coupling.h"
#include "tests/support/linear_wall.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fulcrum::z_width {
namespace {

// The span of a number seen many times, and its mean.
class Span {
  public:
    void take(double value) {
        low_ = std::min(low_, value);
        high_ = std::max(high_, value);
        sum_ += value;
        ++n_;
    }
    [[nodiscard]] double width() const { return n_ > 0 ? high_ - low_ : 0.0; }
    [[nodiscard]] double mean() const { return n_ > 0 ? sum_ / n_ : 0.0; }

  private:
    double low_ = std::numeric_limits<double>::infinity();
    double high_ = -std::numeric_limits<double>::infinity();
    double sum_ = 0.0;
    int n_ = 0;
};

Vector3 compute_wall_force(const WallTrial& trial, const CouplingSettings& coupling,
                           const Vector3& hand, const Vector3& velocity) {
    // The surface is where a proxy would be held.
    const Vector3 proxy(0.0, hand.y(), hand.z());
    if (trial.both_ways) {
        return compute_coupling_force(coupling, proxy, hand, velocity);
    }
    return hand.x() < 0.0
               ? compute_contact_force(coupling, compute_coupling_spring(coupling, proxy, hand),
                                       velocity, Vector3::UnitX())
               : Vector3(Vector3::Zero());
}

}  // namespace

WallCourse run_wall_trial(const WallTrial& trial) {
    SimulatedArmSettings settings = trial.arm;
    settings.start_D = Vector3(trial.start_m, 0.0, 0.0);
    LatestValue<HandTarget> target;
    HandTarget wanted;
    wanted.pose_D.position = Vector3(-trial.press_m, 0.0, 0.0);
    target.publish(wanted);
    SimulatedArm arm(settings, target);
    VelocitySettings velocity = trial.velocity;
    if (settings.position_resolution_m > 0.0) {
        velocity.noise_bound_m = settings.position_resolution_m;
    }
    VelocityEstimator estimator(velocity);
    CouplingSettings coupling;
    coupling.stiffness_N_per_m = trial.stiffness_N_per_m;
    coupling.damping_Ns_per_m = trial.damping_Ns_per_m;

    const int n = static_cast<int>(std::lround(trial.seconds * trial.rate_Hz));
    Span early;
    Span late;
    Span force;
    for (int k = 0; k < n; ++k) {
        const double now_s = k / trial.rate_Hz;
        DeviceReading reading;
        (void)arm.read(now_s, reading);
        const Vector3& v = estimator.step(reading.pose_D.position, now_s);
        const Vector3 f = compute_wall_force(trial, coupling, reading.pose_D.position, v);
        (void)arm.write(now_s, {f, Vector3::Zero()});
        const double x = arm.position_D().x();
        if (4 * k >= 3 * n) {
            late.take(x);
            force.take(f.x());
        } else if (4 * k >= n && 4 * k < 2 * n) {
            early.take(x);
        }
    }
    return {early.width(), late.width(), -late.mean(), force.mean(), force.width()};
}

bool is_stable(const WallCourse& course, double position_resolution_m) {
    // A course that left the numbers is none.
    return course.late_m <=
               std::max(kStillDecays * course.early_m, kCalmSteps * position_resolution_m) &&
           std::isfinite(course.early_m);
}

bool is_stable(const WallTrial& trial) {
    return is_stable(run_wall_trial(trial), trial.arm.position_resolution_m);
}

double find_largest_stiffness(WallTrial trial, double tolerance) {
    const double found = find_largest(
        [&](double stiffness) {
            trial.stiffness_N_per_m = stiffness;
            return is_stable(trial);
        },
        kSoftest_N_per_m, kStiffest_N_per_m, tolerance);
    return found < kSoftest_N_per_m ? 0.0 : found;
}

double find_largest_damping(WallTrial trial, double tolerance) {
    constexpr double kLeast_Ns_per_m = 0.1;
    constexpr double kMost_Ns_per_m = 1000.0;
    const double found = find_largest(
        [&](double damping) {
            trial.damping_Ns_per_m = damping;
            return is_stable(trial);
        },
        kLeast_Ns_per_m, kMost_Ns_per_m, tolerance);
    return found < kLeast_Ns_per_m ? 0.0 : found;
}

}  // namespace fulcrum::z_width
