#include "haptics/geometry/shape.h"
#include "haptics/loop/haptic_loop.h"
#include "tests/stability/cases/held_arm.h"
#include "tests/stability/cases/stability_case.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/box_place.h"
#include "tests/support/scripted_device.h"
#include "tests/support/touchable.h"
#include "tests/support/wall_press.h"
#include "tests/support/wall_trial.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

namespace fulcrum::stability {
namespace {

constexpr const char* kMeasured = "force that pulls further in";
constexpr double kDt_s = 0.001;

double measure_swing(const HumanImpedance& human, double stiffness, double damping) {
    HapticPlan plan = make_floor_plan();
    plan.coupling.stiffness_N_per_m = stiffness;
    plan.coupling.damping_Ns_per_m = damping;
    return stability::measure_swing(plan, human);
}

Finding press_at_the_edge() {
    Finding finding{0.0, z_width::kCalmSteps * kEncoderStep_m, {}};
    for (const HumanImpedance& human : kHands) {
        for (const double damping : {0.0, 2.0}) {
            const double stiffness = find_stiffness_inside(human, damping);
            finding.take(measure_swing(human, stiffness, damping),
                         describe("%.0f N/m, B %.0f Ns/m", stiffness, damping));
        }
    }
    return finding;
}

Finding press_with_the_default() {
    Finding finding{0.0, z_width::kCalmSteps * kEncoderStep_m, "of three hands"};
    const CouplingSettings coupling;
    for (const HumanImpedance& human : kHands) {
        finding.take(measure_swing(human, coupling.stiffness_N_per_m, coupling.damping_Ns_per_m),
                     finding.note);
    }
    return finding;
}

// Rounds of 0.2 to 5 ms, and a gap of 100 ms now and then; the hand presses all the while. Hand and coupling are two
// springs, so it rests at press k_h / (k_h + K) below the surface. A wall that only gives back what it was given, or less,
// keeps it between the surface and where it would be without a wall; how far it goes is told as the share of either way.
Finding press_under_jitter() {
    const double stiffness = CouplingSettings{}.stiffness_N_per_m;
    double worst = 0.0;
    for (const HumanImpedance& human : kHands) {
        const double rest_m =
            kFloorPress_m * human.stiffness_N_per_m / (human.stiffness_N_per_m + stiffness);
        std::mt19937_64 random(3);
        std::uniform_real_distribution<double> length_s(0.0002, 0.005);
        HeldArm held(make_floor_plan(), make_arm_over_floor(human));
        held.aim(-kFloorPress_m);
        held.run(1.0);
        for (int k = 0; k < 4000; ++k) {
            held.step(k % 800 == 400 ? 0.1 : length_s(random));
            const double up_m = held.height_m() + rest_m;
            worst = worse(worst, std::max(up_m / rest_m, -up_m / (kFloorPress_m - rest_m)));
        }
    }
    return {worst, 1.0, "of three hands"};
}

// Readings that are none: no number, no unit, no way that a hand can go, at no time that is now.
constexpr int kFirstLie = 1500;
void lie(int k, DeviceReading& reading) {
    if (k < kFirstLie || k % 500 > 60 || k % 3 == 1) {
        return;
    }
    switch (k / 500 % 8) {
        case 0:
            reading.pose_D.position.y() = kNan;
            break;
        case 1:
            reading.pose_D.position.x() = -kInfinity;
            break;
        case 2:
            reading.pose_D.position.y() -= 0.5;
            break;
        case 3:
            reading.pose_D.position.y() = -1.0e300;
            break;
        case 4:
            reading.pose_D.orientation.coeffs().setZero();
            break;
        case 5:
            reading.stamp_s = kNan;
            break;
        case 6:
            reading.stamp_s -= 1.0;
            break;
        default:
            reading.pose_D.position.y() -= 0.02 * (k % 2);
            break;
    }
}

// The truth is that the hand wants to be kFloorPress_m deep, and moves at v: F <= K press + B v. A lie that is believed would
// take the force to all that the arm has.
Finding press_with_a_lying_device() {
    HapticPlan plan = make_floor_plan();
    HeldArm held(plan, make_arm_over_floor(kArm));
    held.device().spoil = lie;
    held.aim(-kFloorPress_m);
    held.run(0.001 * kFirstLie - 0.1);  // the tap is over, and the hand at rest
    double worst_N = 0.0;
    double fastest_m_per_s = 0.0;
    double calmest_N = HUGE_VAL;
    int n_faults = 0;
    for (int k = kFirstLie; k < 12000; ++k) {
        held.step();
        const Vector3& force = held.device().written_D.force;
        const double force_N = is_finite(force) ? force.norm() : HUGE_VAL;
        worst_N = worse(worst_N, force_N);
        fastest_m_per_s = worse(fastest_m_per_s, held.arm().velocity_D().norm());
        n_faults += any(held.state().faults) ? 1 : 0;
        // Where a lie has lasted, the force has faded.
        if (any(held.state().faults)) {
            calmest_N = std::min(calmest_N, force_N);
        }
    }
    const bool seen = n_faults > 100 && calmest_N == 0.0;
    const CouplingSettings coupling;
    return {
        seen ? worst_N : HUGE_VAL,
        coupling.stiffness_N_per_m * kFloorPress_m + coupling.damping_Ns_per_m * fastest_m_per_s,
        std::to_string(n_faults) + " rounds with a fault"};
}

// The hand lets go while the coupling is stretched as far as the arm's force allows: what the handle flies off with, over
// what the coupling had stored.
Finding let_go_on_the_floor() {
    double worst = 0.0;
    for (const double stiffness : {500.0, 1000.0}) {
        HapticPlan plan = make_floor_plan();
        plan.coupling.stiffness_N_per_m = stiffness;
        const SimulatedArmSettings arm = make_arm_over_floor(kPosture);
        HeldArm held(plan, arm);
        held.aim(-0.018);
        held.run(2.0);
        const double depth_m = -held.height_m();
        const double force_N = std::min(stiffness * depth_m, arm.max_force_N);
        // A spring that saturates stores less than K d^2 / 2.
        const double linear_m = force_N / stiffness;
        const double stored_J = force_N * (depth_m - 0.5 * linear_m);
        held.arm().take_hold(kNobody);
        double fastest_m_per_s = 0.0;
        for (int k = 0; k < 1000; ++k) {
            held.step();
            fastest_m_per_s = worse(fastest_m_per_s, held.arm().velocity_D().norm());
        }
        worst = worse(worst, 0.5 * arm.mass_kg * fastest_m_per_s * fastest_m_per_s / stored_J);
    }
    return {worst, 1.0, "energy, let go on the floor"};
}

// The hand lets go of a handle that a spring draws with all the arm's force: nothing but the arm's own viscous friction
// brings it to rest.
Finding let_go_on_a_spring() {
    HapticPlan plan = make_floor_plan();
    FieldPlan field;
    field.kind = FieldKind::spring;
    field.stiffness_N_per_m = 100.0;
    plan.fields.push_back(field);
    HeldArm held(plan, make_arm_over_floor(kPosture));
    const Vector3 anchor_W(0.0, 0.1, 0.0);
    held.command.fields[0].anchor_W = anchor_W;
    held.aim(0.1);
    held.run(2.0);
    held.aim(0.2);
    held.run(2.0);
    if (held.state().gate != GatePhase::open || held.arm().force_D().norm() < 3.0) {
        return {HUGE_VAL, 0.0, "the spring does not pull"};
    }
    held.arm().take_hold(kNobody);
    held.run(4.0);
    double worst_m = 0.0;
    for (int k = 0; k < 1000; ++k) {
        held.step();
        worst_m = worse(worst_m, (held.arm().position_D() - anchor_W).cwiseAbs().maxCoeff());
    }
    return {worst_m, z_width::kCalmSteps * kEncoderStep_m, "in the fifth second"};
}

const HardCase kEdge{
    {"a stiff wall at the edge of the map",
     "three hands press 4 mm into a floor of nine tenths of the stiffness at which "
     "the Z-width map ends, through the program's loop",
     "the hand's swing in the last second", "m", press_at_the_edge}};
const HardCase kDefault{{"the program's own coupling on a floor",
                         "three hands press 4 mm into a floor with the coupling of a plan that "
                         "names none",
                         "the hand's swing in the last second", "m", press_with_the_default}};
const HardCase kJitter{
    {"time steps of 0.2 to 5 ms and gaps of 100 ms",
     "three hands press on a floor while the loop's clock stumbles",
     "how far the hand strays, of the way to the surface or to where it wants to be", "",
     press_under_jitter}};
const HardCase kLies{{"NaN, infinity and jumps from the device",
                      "every kind of bad reading, while a hand presses on a floor",
                      "the largest force sent to the arm", "N", press_with_a_lying_device}};
const HardCase kLetGo{{"let go at full stretch of the coupling",
                       "a hand that presses with all the arm's force vanishes",
                       "the handle's energy over the coupling's", "", let_go_on_the_floor}};
const HardCase kLetGoSpring{{"let go at full stretch of a spring",
                             "a handle that a spring draws with all the arm's force is let go",
                             "distance from the anchor along any axis", "m", let_go_on_a_spring}};

constexpr double kTick_s = 1.0e-3;
constexpr double kSpeed_m_per_s = 5.0;
constexpr double kThickness_m = 1.0e-3;
constexpr int kCrossings = 20;
constexpr int kTicks = 60;         // there, and as many back
constexpr int kTicksBetween = 20;  // at rest, for the force to fall

// A loop that touches one plate of 1 mm by 1 m by 1 m.
struct Touch {
    static HapticPlan plan() {
        HapticPlan plan;
        plan.expects_lesson = false;
        plan.expects_world = true;
        plan.solids = only_solid(touchable(make_box(kSize_m)));
        return plan;
    }
    // One round with the hand and the plate there; the last force, of the coupling and at the device.
    void step(const Vector3& hand_W, const Vector3& plate_W) {
        now_s += kTick_s;
        device.pose_D.position = hand_W;
        frame.stamp_s = now_s;
        frame.solid_poses_W[0] = Pose::at(plate_W);
        channels->world.publish(frame);
        loop.step(now_s);
    }

    static inline const Vector3 kSize_m{1.0, kThickness_m, 1.0};
    ScriptedDevice device;
    std::unique_ptr<HapticChannels> channels = std::make_unique<HapticChannels>();
    WorldFrame frame;
    double now_s = 0.0;
    HapticLoop loop{plan(), device, *channels};
};

// Hand (or plate) goes to and fro across the other; worst is the largest part of a force that pulls into the side touched.
Finding cross(bool plate_moves) {
    Touch touch;
    const Vector3 side_W(0.03, 1.0, -0.02);
    const Vector3 begin_W(0.0, 0.1, 0.0);
    const auto step_to = [&](double way_m) {
        const Vector3 hand_W = begin_W - way_m * side_W;
        plate_moves ? touch.step(begin_W, way_m * side_W) : touch.step(hand_W, Vector3::Zero());
        return Vector3(plate_moves ? begin_W - way_m * side_W : hand_W);
    };
    for (int i = 0; i < 3000; ++i) {
        step_to(0.0);
    }
    double worst_N = 0.0;
    double largest_N = 0.0;
    int n_touching = 0;
    for (int crossing = 0; crossing < kCrossings; ++crossing) {
        BoxPlace place(Touch::kSize_m, begin_W);
        for (int i = 1; i <= 2 * kTicks + kTicksBetween; ++i) {
            const int there = std::max(0, std::min(i, 2 * kTicks - i));
            // A little slower each time, so that it meets the plate elsewhere between two ticks.
            const double speed = kSpeed_m_per_s * (1.0 - 0.013 * crossing);
            place.step(step_to(speed * kTick_s * there));
            for (const Wrench& wrench :
                 {touch.loop.state().commanded_W, touch.loop.state().applied_W}) {
                worst_N =
                    worse(worst_N, place.is_touching() ? -wrench.force.dot(place.normal_B()) : 0.0);
                largest_N = std::max(largest_N, wrench.force.norm());
            }
            n_touching += place.is_touching() ? 1 : 0;
        }
    }
    const bool meant = n_touching > kCrossings * kTicks / 2 && largest_N > 1.0;
    return {meant ? worst_N : HUGE_VAL, 0.0, "touched at " + std::to_string(n_touching) + " ticks"};
}

const HardCase kHand{{"the loop at a plate of 1 mm at 5 m/s",
                      "the hand shoots through and comes back, 20 times", kMeasured, "N",
                      [] { return cross(false); }}};
const HardCase kPlate{{"the loop when a plate of 1 mm flies at 5 m/s",
                       "the plate flies through a still hand and back, 20 times", kMeasured, "N",
                       [] { return cross(true); }}};

// Walls of 500 to 2000 N/m pressed by a 50 g handle in a grip of 0.2 Ns/m: less than k T / 2 of each.
Finding press_undamped_walls() {
    Finding finding{0.0, 0.01, {}};
    for (const double stiffness_N_per_m : {500.0, 1000.0, 1500.0, 2000.0}) {
        HapticPlan plan = wall_press::make_wall(stiffness_N_per_m, 0.0);
        const auto shaking = wall_press::last_second(
            wall_press::press(plan, wall_press::make_loose_grip(), {}), plan.rate_hz);
        // Nothing felt is no wall that stands still.
        finding.take(shaking.mean_N > 0.5 ? shaking.force_N : HUGE_VAL,
                     describe("at %.0f N/m", stiffness_N_per_m));
    }
    return finding;
}

// At each answer the spring's anchor leaps to the side that the hand is moving to: the most that a lesson can feed in through it.
Finding swing_with_hand() {
    constexpr double kTenSeconds = 10.0;
    HapticPlan plan;
    FieldPlan spring;
    spring.stiffness_N_per_m = 100.0;
    plan.fields = {spring};
    LatestValue<HandTarget> target;
    target.publish({});
    SimulatedHand hand(SimulatedHandSettings{}, target);
    const auto channels = std::make_unique<HapticChannels>();
    HapticLoop loop(plan, hand, *channels);
    ForceCommand command;
    command.lesson_alive = true;
    double given_J = 0.0;
    Vector3 last_W = Vector3::Zero();
    Vector3 held_W = Vector3::Zero();
    for (int k = 1; k <= 13000; ++k) {
        if (k > 2500 && k % 17 == 0) {
            const bool goes_on = loop.state().tool_twist_W.linear.x() >= 0.0;
            command.fields[0].anchor_W.x() = goes_on ? 0.1 : -0.1;
        }
        command.stamp_s = k * kDt_s;
        channels->command.publish(command);
        loop.step(k * kDt_s);
        const Vector3& now_W = loop.state().tool_pose_W.position;
        given_J += k > 3000 ? held_W.dot(now_W - last_W) : 0.0;
        last_W = now_W;
        held_W = loop.state().applied_W.force;
    }
    // The force limit and the arm's own damping bound it; it was 0.82 W when this was written.
    const double power_W = given_J / kTenSeconds;
    return {power_W > 0.0 ? power_W : HUGE_VAL, 1.0, "5 N at most, on the usual arm"};
}

const HardCase kWalls{{"walls without a damper in a loose grip",
                       "the passivity stage keeps them from buzzing at 1 kHz",
                       "force's root mean square about its mean, last second", "N",
                       press_undamped_walls}};
const HardCase kSwing{{"a lesson that swings its spring with the hand",
                       "at 60 Hz the anchor leaps to where the hand is going",
                       "power into the hand", "W", swing_with_hand}};

}  // namespace

}  // namespace fulcrum::stability
