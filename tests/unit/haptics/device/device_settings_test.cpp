// What no device can be made with: each setting beyond its range, and what is no number, is refused in a sentence that names it.
#include "haptics/device/arm/simulated_wam.h"
#include "haptics/device/fitted/fitted_device.h"
#include "haptics/device/hid/hid_hand.h"
#include "haptics/device/mouse/pointer_device.h"
#include "haptics/device/simulated/simulated_arm.h"
#include "haptics/device/simulated/simulated_hand.h"
#include "haptics/device/watched/sensor_guard.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/refused.h"

#include <catch2/catch.hpp>

#include <functional>
#include <string>
#include <vector>

using namespace fulcrum;
using namespace fulcrum::hid;

namespace {

template <class Settings>
Expected<void> check(const Settings& settings) {
    return validate(settings);
}
// Whether its arm can reach its workspace shows when it is made.
Expected<void> check(const SimulatedWamSettings& settings) {
    LatestValue<HandTarget> target;
    return SimulatedWam::create(settings, target).map([](auto&&) {});
}

struct Refusal {
    const char* told;  // in the sentence
    std::vector<double> bad;
    std::function<Expected<void>(double bad)> check_with;
};

// NaN is bad for every field.
template <class Settings>
Refusal of(double Settings::*field, const char* name, double below, double above) {
    return {name, {below, above, kNan}, [field](double bad) {
                Settings settings;
                settings.*field = bad;
                return check(settings);
            }};
}
template <class Settings>
Refusal of(const char* told, std::vector<double> bad,
           void (*spoil)(Settings& settings, double bad)) {
    return {told, std::move(bad), [spoil](double value) {
                Settings settings;
                spoil(settings, value);
                return check(settings);
            }};
}

using Arm = SimulatedArmSettings;
using Effects = ForceEffectSettings;
using Fit = DeviceFit;
using Hand = SimulatedHandSettings;
using Hid = HidHandSettings;
using Life = SensorLife;
using Pointer = PointerSettings;
using Rate = RateSettings;
using Wam = SimulatedWamSettings;

const std::vector<Refusal>& all_refusals() {
    static const std::vector<Refusal> kAll{
        of(&Arm::mass_kg, "mass_kg", 0.0009, 100.1),
        of(&Arm::dry_friction_N, "dry_friction_N", -0.01, 10.1),
        of(&Arm::damping_Ns_per_m, "damping_Ns_per_m", -0.01, 1001.0),
        of(&Arm::position_resolution_m, "position_resolution_m", -1e-9, 0.011),
        of(&Arm::delay_s, "delay_s", -1e-9, 0.0201),
        of(&Arm::max_force_N, "max_force_N", -0.1, 101.0),
        of<Arm>("", {-0.1, kNan},
                [](Arm& s, double bad) {
                    s.human = {bad, 0.0, 0.0};
                }),
        of<Arm>("", {-0.1},
                [](Arm& s, double bad) {
                    s.human = {0.0, bad, 0.0};
                }),
        // A spring too soft to be one, too.
        of<Arm>("", {-1.0, 0.5, 1.1e8},
                [](Arm& s, double bad) {
                    s.human = {0.0, 0.0, bad};
                }),
        of<Arm>("", {kInfinity}, [](Arm& s, double bad) { s.start_D.y() = bad; }),
        of<Hand>("mass_kg is 0", {0.0}, [](Hand& s, double bad) { s.mass_kg = bad; }),
        of<Hand>("", {kNan}, [](Hand& s, double bad) { s.stiffness_N_per_m = bad; }),
        of<Hand>("", {2.0},
                 [](Hand& s, double bad) { s.start_pose_D.orientation.coeffs() *= bad; }),
        of<Pointer>("natural_rad_per_s is 1", {1.0},
                    [](Pointer& s, double bad) { s.natural_rad_per_s = bad; }),
        of<Pointer>("", {kNan}, [](Pointer& s, double bad) { s.max_speed_m_per_s = bad; }),
        of<Pointer>("", {0.06}, [](Pointer& s, double bad) { s.sag_m_per_N = bad; }),
        of<Pointer>("", {-0.1}, [](Pointer& s, double bad) { s.slow_per_N = bad; }),
        of<Pointer>("", {0.0}, [](Pointer& s, double bad) { s.half_extent_D.z() = bad; }),
        of(&Rate::max_speed_m_per_s, "max_speed_m_per_s", 0.009, 2.1),
        of(&Rate::max_turn_rad_per_s, "max_turn_rad_per_s", -0.1, 10.1),
        of(&Rate::dead_zone, "dead_zone", -0.01, 0.51),
        of(&Rate::exponent, "exponent", 0.99, 4.01),
        of(&Rate::full_push_N, "full_push_N", 0.4, 51.0),
        of(&Rate::half_extent_m, "half_extent_m", 0.0009, 10.1),
        of(&Effects::device_gain, "", 0.04, 1.01),
        of(&Effects::duration_s, "", 0.04, 1.01),
        of(&Effects::load_pause_s, "", 0.04 + 0.1, 1.01 + 0.1),
        of(&Hid::cap_silence_s, "", 0.01, 20.0),
        of(&Hid::stick_silence_s, "", 0.01, 20.0),
        of(&Hid::full_force_N, "", 0.01, 20.0),
        of<Hid>("", {-0.01, 20.0, kNan}, [](Hid& s, double bad) { s.rate.dead_zone = bad; }),
        of<Hid>("", {0.01, 20.0, kNan}, [](Hid& s, double bad) { s.effects.duration_s = bad; }),
        of<Hid>("", {0.0}, [](Hid& s, double bad) { s.cap_pointer.natural_rad_per_s = bad; }),
        of<Hid>("", {0.0}, [](Hid& s, double bad) { s.stick_pointer.half_extent_D.x() = bad; }),
        of<Fit>("", {-1.0, kMostClutchButton + 1.0},
                [](Fit& s, double bad) { s.clutch_button = static_cast<int>(bad); }),
        of<Fit>("", {0.51, -0.51, kNan, kInfinity},
                [](Fit& s, double bad) {
                    s.middle_A = {0.0, bad, 0.0};
                }),
        of(&Life::trembles_within_s, "trembles_within_s", -0.1, 1.1),
        of(&Life::moves_at_N, "moves_at_N", -0.1, 10.1),
        of(&Life::most_m_per_s2, "most_m_per_s2", -1.0, 1.1e4),
        of<Wam>("delay_s", {0.03}, [](Wam& s, double bad) { s.delay_s = bad; }),
        of<Wam>("longest_step_s", {kNan}, [](Wam& s, double bad) { s.longest_step_s = bad; }),
        of<Wam>("posture_per_s", {-1.0}, [](Wam& s, double bad) { s.posture_per_s = bad; }),
        of<Wam>("grip.push.mass_kg", {101.0},
                [](Wam& s, double bad) { s.grip.push.mass_kg = bad; }),
        of<Wam>("strongest_N", {kNan}, [](Wam& s, double bad) { s.grip.strongest_N = bad; }),
        of<Wam>("0 joints", {0.0}, [](Wam& s, double bad) { s.model.n = static_cast<int>(bad); }),
        of<Wam>("cannot reach", {0.5}, [](Wam& s, double bad) { s.workspace.radius_m = bad; }),
    };
    return kAll;
}

}  // namespace

TEST_CASE("device settings: what is out of range or no number is refused, and named") {
    for (std::size_t i = 0; i < all_refusals().size(); ++i) {
        const Refusal& refusal = all_refusals()[i];
        for (const double bad : refusal.bad) {
            CAPTURE(i, refusal.told, bad);
            CHECK(is_refused(refusal.check_with(bad), refusal.told));
        }
    }
}

TEST_CASE("device settings: what devices have where nothing is said is accepted, and all presets") {
    CHECK(validate(Arm{}));
    CHECK(validate(make_desktop_arm()));
    for (const HumanImpedance& preset : {kNobody, kFingertip, kArm, kPosture}) {
        Arm settings;
        settings.human = preset;
        CHECK(validate(settings));
    }
    CHECK(validate(Hand{}));
    CHECK(validate(Pointer{}));
    CHECK(validate(Rate{}));
    CHECK(validate(Effects{}));
    CHECK(validate(Hid{}));
    CHECK(validate(Fit{}));
    CHECK(validate(Life{}));
    CHECK(validate(Life{0.05, 1.5, 300.0}));
    CHECK(check(Wam{}));
}
