#include "tests/support/wall_trial.h"

#include "haptics/coupling/virtual_coupling.h"
#include "haptics/loop/contact_damper.h"
#include "tests/support/linear_wall.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
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
    // No number when one of them was none.
    [[nodiscard]] double width() const { return high_ - low_ + 0.0 * sum_; }
    [[nodiscard]] double mean() const { return sum_ / n_; }

  private:
    double low_ = std::numeric_limits<double>::infinity();
    double high_ = -std::numeric_limits<double>::infinity();
    double sum_ = 0.0;
    int n_ = 0;
};

Vector3 compute_wall_force(const WallTrial& trial, const CouplingSettings& coupling,
                           const Vector3& hand, const Vector3& velocity) {
    // The surface is where a proxy would be held.
    const Vector3 spring = compute_coupling_spring(coupling, {0.0, hand.y(), hand.z()}, hand);
    if (trial.both_ways) {
        return spring - coupling.damping_Ns_per_m * velocity;
    }
    if (!(hand.x() < 0.0)) {
        return Vector3::Zero();
    }
    const DampedPlane plane{.normal_W = Vector3::UnitX(),
                            .push_N = spring.x(),
                            .velocity_W = velocity,
                            .damping_Ns_per_m = coupling.damping_Ns_per_m};
    return spring + compute_contact_damping({&plane, 1}).force_W;
}

bool is_linear_wall(const WallTrial& trial) {
    return trial.arm.position_resolution_m == 0.0 && trial.arm.dry_friction_N == 0.0 &&
           (trial.damping_Ns_per_m == 0.0 ||
            trial.velocity.method != VelocityMethod::adaptive_window);
}

// The arm, the estimator and the wall, one round after the other.
class Rig {
  public:
    explicit Rig(const WallTrial& trial)
        : trial_(trial), arm_(settings_of(trial), target_), estimator_(velocity_of(trial)) {
        HandTarget wanted;
        wanted.pose_D.position = Vector3(-trial.press_m, 0.0, 0.0);
        target_.publish(wanted);
        coupling_.stiffness_N_per_m = trial.stiffness_N_per_m;
        coupling_.damping_Ns_per_m = trial.damping_Ns_per_m;
    }

    WallWindow run_window() {
        Span position;
        Span force;
        bool is_linear = is_linear_wall(trial_);
        const int n = static_cast<int>(std::lround(kWindow_s * trial_.rate_Hz));
        for (int k = 0; k < n; ++k, ++round_) {
            const double now_s = round_ / trial_.rate_Hz;
            DeviceReading reading;
            (void)arm_.read(now_s, reading);
            const Vector3& hand = reading.pose_D.position;
            const Vector3 f =
                compute_wall_force(trial_, coupling_, hand, estimator_.step(hand, now_s));
            (void)arm_.write(now_s, {f, Vector3::Zero()});
            position.take(arm_.position_D().x());
            force.take(f.x());
            const bool touches = trial_.both_ways || f.x() > 0.0;
            is_linear = is_linear && touches && std::abs(f.x()) < trial_.arm.max_force_N;
        }
        return {position.width(), force.width(), -position.mean(), force.mean(), is_linear};
    }
    [[nodiscard]] double time_s() const { return round_ / trial_.rate_Hz; }

  private:
    static SimulatedArmSettings settings_of(const WallTrial& trial) {
        SimulatedArmSettings settings = trial.arm;
        settings.start_D = Vector3(trial.start_m, 0.0, 0.0);
        return settings;
    }
    static VelocitySettings velocity_of(const WallTrial& trial) {
        VelocitySettings velocity = trial.velocity;
        if (trial.arm.position_resolution_m > 0.0) {
            velocity.noise_bound_m = trial.arm.position_resolution_m;
        }
        return velocity;
    }

    const WallTrial& trial_;
    LatestValue<HandTarget> target_;
    SimulatedArm arm_;
    VelocityEstimator estimator_;
    CouplingSettings coupling_;
    int round_ = 0;
};

// Nothing where the search ended at either of its ends: neither is a boundary.
std::optional<double> find_inside(const std::function<bool(double)>& holds, double low, double high,
                                  double tolerance) {
    const double found = find_largest(holds, low, high, tolerance);
    return found < low || found >= high ? std::nullopt : std::optional(found);
}

}  // namespace

WallTrial make_tap(const HumanImpedance& human) {
    WallTrial trial;
    trial.arm = make_desktop_arm();
    trial.arm.human = human;
    trial.arm.dry_friction_N = 0.0;
    trial.arm.max_force_N = 10.0;
    trial.start_m = 0.01;
    trial.press_m = 0.004;
    return trial;
}

WallJudge::WallJudge(const WallTrial& trial)
    : WallJudge(std::max(kCalmSteps * trial.arm.position_resolution_m, kCalmAtLeast_m),
                std::min(trial.arm.position_resolution_m * trial.stiffness_N_per_m + kCalmRipple_N,
                         trial.arm.max_force_N)) {}

WallVerdict WallJudge::take(const WallWindow& window) {
    constexpr std::size_t kTwoSeconds = 4;  // windows
    if (!std::isfinite(window.swing_m) || !std::isfinite(window.ripple_N)) {
        return WallVerdict::unstable;
    }
    windows_.push_back(window);
    const std::size_t n = windows_.size();
    const auto is_calm = [&](const WallWindow& one) {
        return one.swing_m <= calm_m_ && one.ripple_N <= calm_N_;
    };
    if (n > 2 && is_calm(windows_[n - 1]) && is_calm(windows_[n - 2])) {
        return WallVerdict::stable;
    }
    if (n < kTwoSeconds + 2) {
        return WallVerdict::undecided;
    }
    // The least swing up to two seconds ago; the window in which the hand arrives is left out.
    const auto last_old = windows_.end() - static_cast<std::ptrdiff_t>(kTwoSeconds);
    const double least_m =
        std::min_element(windows_.begin() + 1, last_old, [](const auto& a, const auto& b) {
            return a.swing_m < b.swing_m;
        })->swing_m;
    if (window.swing_m > kStillDecays * least_m) {
        return WallVerdict::unstable;
    }
    const bool was_linear = std::all_of(last_old - 1, windows_.end(),
                                        [](const WallWindow& one) { return one.is_linear; });
    return was_linear ? WallVerdict::stable : WallVerdict::undecided;
}

WallCourse run_wall_trial(const WallTrial& trial) {
    Rig rig(trial);
    WallJudge judge(trial);
    WallCourse course;
    while (course.verdict == WallVerdict::undecided) {
        course.last = rig.run_window();
        course.verdict = judge.take(course.last);
        if (course.verdict == WallVerdict::undecided && rig.time_s() >= trial.longest_s) {
            course.verdict = WallVerdict::unstable;
        }
    }
    course.lasted_s = rig.time_s();
    return course;
}

std::optional<double> find_largest_stiffness(WallTrial trial, double tolerance) {
    return find_inside(
        [&](double stiffness) {
            trial.stiffness_N_per_m = stiffness;
            return run_wall_trial(trial).is_stable();
        },
        kSoftest_N_per_m, kStiffest_N_per_m, tolerance);
}

std::optional<double> find_largest_damping(WallTrial trial, double tolerance) {
    constexpr double kLeast_Ns_per_m = 0.1;
    constexpr double kMost_Ns_per_m = 1000.0;
    return find_inside(
        [&](double damping) {
            trial.damping_Ns_per_m = damping;
            return run_wall_trial(trial).is_stable();
        },
        kLeast_Ns_per_m, kMost_Ns_per_m, tolerance);
}

}  // namespace fulcrum::z_width
