// A tool of points against a distance field where it is hardest: a wall thinner than a step is long, a scene of half a million
// triangles, and a rest of an hour in a hand that trembles.
#include "haptics/coupling/passivity.h"
#include "haptics/dynamics/loads.h"
#include "haptics/geometry/shape.h"
#include "haptics/math/rotation.h"
#include "haptics/tool/field_sampling/field_sampler.h"
#include "tests/stability/cases/tool_course.h"
#include "tests/support/join_meshes.h"
#include "tests/support/wander.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

namespace fulcrum::stability {
namespace {

struct FieldScene {
    TriangleMesh object;
    int n_along;
    TriangleMesh tool;
    int n_points;
    double stiffness_N_per_m;  // of a point
    double clamp_N;            // that the coupling pulls with at most
    double deepest_m;          // that a motion may take a point
    bool sweeps = true;
};

// A tool of 50 g on its coupling, pushed by the field; what it would pass in a step, it is stopped at.
class SweptTool {
  public:
    explicit SweptTool(const FieldScene& scene)
        : sampler_(
              FieldSampler::build(
                  std::make_shared<const DistanceField>(
                      DistanceField::build(scene.object,
                                           make_field_frame(scene.object, scene.n_along).value())
                          .value()),
                  std::make_shared<const ShellTree>(
                      ShellTree::build(make_surface_pointshell(scene.tool, scene.n_points).value())
                          .value()),
                  {.stiffness_N_per_m = scene.stiffness_N_per_m})
                  .value()),
          deepest_m_(scene.deepest_m),
          sweeps_(scene.sweeps) {
        const Vector3 size_m = scene.tool.upper_B() - scene.tool.lower_B();
        inertia_ = make_box_inertia(0.05, size_m);
        settings_.turn.stiffness_Nm_per_rad = 0.1;
        settings_ = make_critically_damped(settings_, inertia_.mass_kg, inertia_.moments_kg_m2);
        settings_.clamp_m = scene.clamp_N / settings_.shift.stiffness_N_per_m;
        settings_.clamp_rad = 0.2;
        voxel_m = scene.object.upper_B().x() * 2.0 / scene.n_along;
    }

    // Ends at `now_s`; the force on the hand.
    Vector3 step(const Pose& handle_W, double now_s) {
        const Pose before = state.pose_W;
        touch = sampler_.step({}, before);
        const ConstantLoad contact(touch.wrench_W);
        ToolCouplingLoad coupling(settings_);
        const Twist going{
            (handle_W.position - (has_handle_ ? handle_W_ : handle_W).position) / kToolDt_s,
            Vector3::Zero()};
        handle_W_ = handle_W;
        has_handle_ = true;
        coupling.set_handle({handle_W, going}, now_s);
        const Loads loads(coupling, contact);
        if (!step_rigid_body({}, inertia_, loads, now_s - kToolDt_s, kToolDt_s, state).moved()) {
            deepest_m = HUGE_VAL;
        }
        if (sweeps_) {
            const double share = sampler_.find_first_touch(before, state.pose_W, deepest_m_);
            n_stops += share < 1.0 ? 1 : 0;
            state.pose_W.position =
                before.position + share * (state.pose_W.position - before.position);
            state.pose_W.orientation = before.orientation.slerp(share, state.pose_W.orientation);
            state.velocity_W.linear *= share;
            state.velocity_W.angular *= share;
        }
        deepest_m = worse(deepest_m, touch.deepest_m);
        return coupling.compute_felt_wrench(state, now_s).force;
    }

    RigidState state;
    FieldTouch touch{};
    double deepest_m = 0.0;  // of any point so far
    double voxel_m = 0.0;
    int n_stops = 0;

  private:
    FieldSampler sampler_;
    double deepest_m_;
    bool sweeps_;
    Inertia inertia_;
    ToolCouplingSettings settings_{};
    Pose handle_W_;
    bool has_handle_ = false;
};

// A ball flies in its hand at a wall of 0.8 mm, which the hand passes; the hand then goes along behind the wall, and comes back.
Finding fly_at_wall() {
    constexpr double kClamp_N = 0.5;
    double worst = 0.0;
    std::string note;
    FieldScene scene{make_box({0.1, 0.0008, 0.1}).value(),
                     512,
                     make_sphere(0.0005, 10).value(),
                     2000,
                     300.0,
                     kClamp_N,
                     2.0e-4};
    for (const double speed_m_per_s : {2.0, 5.0}) {
        const Vector3 before(-0.021, 0.02, 0.003);
        const Vector3 behind(-0.02, -0.01, 0.0);
        const Vector3 aside(0.02, -0.01, 0.0);
        const Vector3 back(0.02, 0.02, 0.0);
        const auto go = [](SweptTool& tool, const Vector3& from, const Vector3& to, double speed,
                           int n) {
            Vector3 felt_N;
            for (int i = 1; i <= n; ++i) {
                const double share = std::min(1.0, i * kToolDt_s * speed / (to - from).norm());
                felt_N = tool.step(Pose::at(from + share * (to - from)), i * kToolDt_s);
            }
            return felt_N;
        };
        const auto fly = [&](SweptTool& tool) {
            tool.state.pose_W = {before, compute_exp({0.3, 0.2, 0.1})};
            tool.state.velocity_W = {speed_m_per_s * (behind - before).normalized(),
                                     {3.0, 0.0, -5.0}};
            return go(tool, before, behind, speed_m_per_s, 1000);
        };
        SweptTool tool(scene);
        const double held_N = fly(tool).y();
        const double rest_m_per_s = tool.state.velocity_W.linear.norm();
        (void)go(tool, behind, aside, 0.04, 2000);
        const double lag_m = std::abs(tool.state.pose_W.position.x() - aside.x());
        (void)go(tool, aside, back, 0.04, 2000);
        const double left_m = (tool.state.pose_W.position - back).norm();
        // The same without a sweep goes through, or nothing was tried.
        FieldScene blind = scene;
        blind.sweeps = false;
        SweptTool passes(blind);
        (void)fly(passes);
        const bool is_hard = passes.state.pose_W.position.y() < -0.002;
        worst = worse(worst, is_hard ? 0.0 : HUGE_VAL);
        worst = worse(worst, tool.deepest_m / (scene.deepest_m + 0.1 * tool.voxel_m));
        worst = worse(worst, rest_m_per_s / 1.0e-3);
        worst = worse(worst, std::abs(held_N - kClamp_N) / (0.05 * kClamp_N));
        worst = worse(worst, lag_m / 5.0e-4);
        worst = worse(worst, left_m / 1.0e-4);
        note += describe(
            "%.0f m/s: %.3g mm deep, %.3g N held, %.1g m/s, lag %.2g mm, back to %.2g mm; ",
            speed_m_per_s, 1000.0 * tool.deepest_m, held_N, rest_m_per_s, 1000.0 * lag_m,
            1000.0 * left_m);
    }
    return {worst, 1.0, note};
}

// Sixty-four rings that hang in each other, `n_ring` by `n_tube` squares each.
TriangleMesh make_tangle(int n_ring, int n_tube) {
    std::vector<std::pair<TriangleMesh, Pose>> rings;
    const TriangleMesh ring = make_torus(0.02, 0.004, n_ring, n_tube).value();
    Random random(7);
    for (int i = 0; i < 64; ++i) {
        const Quaternion turn(AngleAxis(std::numbers::pi * random.uniform(), random.direction()));
        rings.emplace_back(ring,
                           Pose{0.03 * Vector3(i % 4 - 1.5, i / 4 % 4 - 1.5, i / 16 - 1.5), turn});
    }
    return join_meshes(rings).value();
}

// The hand wanders through the tangle; the tool comes after as it can, never deeper than it may, and free again it is at the hand.
Finding wander_through_tangle() {
    FieldScene scene{make_tangle(125, 32),
                     256,
                     make_box({0.012, 0.003, 0.003}).value(),
                     1000,
                     100.0,
                     1.0,
                     6.0e-4};
    SweptTool tool(scene);
    tool.state.pose_W = Pose::at({0.0, 0.08, 0.0});
    Wanderer wanderer(5, 0.01);
    double n_leaves = 0.0;
    double n_touching = 0.0;
    constexpr int kSteps = 6000;
    for (int i = 1; i <= kSteps; ++i) {
        // At half a metre a second, inwards and outwards.
        const double radius_m = 0.045 + 0.035 * std::cos(0.005 * i);
        (void)tool.step(Pose::at(radius_m * wanderer.next()), i * kToolDt_s);
        n_leaves += static_cast<double>(tool.touch.n_leaves) / kSteps;
        n_touching += tool.touch.n_touching > 0 ? 1.0 / kSteps : 0.0;
    }
    double worst = tool.deepest_m / (scene.deepest_m + 0.1 * tool.voxel_m);
    worst = worse(worst, n_touching > 0.1 ? 0.0 : HUGE_VAL);
    return {worst, 1.0,
            std::to_string(scene.object.triangles().size()) + " triangles, touching " +
                std::to_string(static_cast<int>(100.0 * n_touching)) + " % of the time, " +
                std::to_string(static_cast<int>(n_leaves)) + " leaves a step, stopped " +
                std::to_string(tool.n_stops) + " times"};
}

// A plate at rest on a plate in a hand that trembles by 0.1 mm at 8 Hz and pushes it a little to and fro at half of that. For an
// hour where FULCRUM_REST_SECONDS says 3600.
Finding rest_in_hand() {
    const char* const asked = std::getenv("FULCRUM_REST_SECONDS");
    const double seconds = asked != nullptr ? std::atof(asked) : 20.0;
    SweptTool tool({make_box({0.2, 0.02, 0.2}).value(), 128, make_box({0.05, 0.01, 0.05}).value(),
                    1000, 20.0, 1.0, 1.0e-3});
    const auto handle_at = [](double time_s) {
        const double phase = 2.0 * std::numbers::pi * 8.0 * time_s;
        return Pose::at({1.0e-4 * std::sin(0.5 * phase), 0.0135 + 1.0e-4 * std::sin(phase), 0.0});
    };
    tool.state.pose_W = Pose::at({0.0, 0.016, 0.0});
    PassivityController observer(PassivitySettings{}, {.device_damping = 0.0});
    const auto n_settle = static_cast<std::int64_t>(2.0 / kToolDt_s);
    const auto n_steps = static_cast<std::int64_t>(seconds / kToolDt_s) + n_settle;
    constexpr std::int64_t kPeriod = 250;  // steps of both motions together
    double given_J = 0.0;
    double spring_J = 0.0;  // most that was given and not yet taken back
    Vector3 felt_N = Vector3::Zero();
    Vector3 first_m = Vector3::Zero();
    double drift_m = 0.0;
    for (std::int64_t i = 1; i <= n_steps; ++i) {
        const double now_s = static_cast<double>(i) * kToolDt_s;
        const Vector3 motion_m = handle_at(now_s).position - handle_at(now_s - kToolDt_s).position;
        const Vector3 before_N = std::exchange(felt_N, tool.step(handle_at(now_s), now_s));
        (void)observer.step({.motion = motion_m, .asked = felt_N, .dt_s = kToolDt_s});
        observer.sent(felt_N);
        if (i == n_settle) {
            first_m = tool.state.pose_W.position;
            observer.reset();
        } else if (i > n_settle) {
            // As if the force had gone on evenly; what its being held for a step adds is the observer's.
            given_J += 0.5 * (before_N + felt_N).dot(motion_m);
            spring_J = worse(spring_J, given_J);
            if ((i - n_settle) % kPeriod == 0) {
                drift_m = worse(drift_m, (tool.state.pose_W.position - first_m).norm());
            }
        }
    }
    // What a spring of 1 N gives back over the tremor.
    constexpr double kSpring_J = 2.0e-4;
    double worst = drift_m / 1.0e-6;
    worst = worse(worst, given_J / 1.0e-6);
    worst = worse(worst, spring_J / kSpring_J);
    worst = worse(worst, observer.energy().peak_J / kSpring_J);
    worst = worse(worst, tool.touch.n_touching > 100 ? 0.0 : HUGE_VAL);
    return {
        worst, 1.0,
        describe("%.0f s: drift %.2g um, %.3g mJ given, %.2g mJ at most, observer's peak %.2g mJ",
                 seconds, 1.0e6 * drift_m, 1000.0 * given_J, 1000.0 * spring_J,
                 1000.0 * observer.energy().peak_J)};
}

const HardCase kWall{
    {"field tool and a thin wall at 2 and 5 m/s",
     "a ball flown at a wall thinner than its steps stops there, slides along and comes back",
     "worst of: depth as let in, speed in 1 mm/s, force off the clamp's in 5 %, lag "
     "in 0.5 mm, distance at the end in 0.1 mm",
     "", fly_at_wall}};
const HardCase kTangle{{"field tool in half a million triangles",
                        "a stick follows a hand that wanders through sixty-four rings",
                        "depth, as let in", "", wander_through_tangle}};
const HardCase kHour{
    {"field tool at rest in a hand that trembles",
     "a plate on a plate, 20 s, or an hour with FULCRUM_REST_SECONDS=3600",
     "worst of: drift in um, energy given in uJ, most of it and the observer's peak in 0.2 mJ", "",
     rest_in_hand}};

}  // namespace
}  // namespace fulcrum::stability
