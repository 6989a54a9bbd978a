// A tool held out by contact levels of detail where it is hard: a contact thread that stalls, slivers, a mesh through itself, garbage from the
// device, ragged time, all sizes. Each presses a cube on something and leaves it: what is felt is a number, never above the clamp, more than nothing
// while it presses, and exactly nothing before and after; and at no time has the hand been given more energy than it put in and the tool brought along. And a
// tool that nobody damps falls on things: its energy never grows.
#include "tests/stability/cases/penalty_watch.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/join_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace fulcrum::stability {
namespace {

constexpr double kClamp_N = kPenaltyMost_N;
constexpr double kEdge_m = 0.03;
constexpr double kMass_kg = 0.02;
constexpr double kDown_m = 0.016;  // that the hand goes
constexpr double kDown_s = 0.3;
constexpr double kSway_m = 0.004;
constexpr double kSway_per_s = 4.0;

// What differs from case to case.
struct PressCourse {
    TriangleMesh object;
    double top_m = 0.0;                          // of the object, along y
    double size = 1.0;                           // all lengths times it
    std::function<bool(int)> is_garbage{};       // of a step's pose
    std::function<double(int)> find_dt_s{};      // of a step
    std::function<bool(double)> runs_contact{};  // of a time, by a thread of its own
};

ImplicitPenaltyPlan make_cube_plan(double size, const TriangleMesh& object) {
    const Vector3 edges = size * kEdge_m * Vector3::Ones();
    return make_implicit_penalty_plan(plan_penalty({.tool = make_box(edges).value(),
                                                    .inertia = make_box_inertia(kMass_kg, edges),
                                                    .voxel_m = 0.002 * size,
                                                    .objects = {object},
                                                    .n_points = 500,
                                                    .contact = ContactFinding::levels}));
}

ImplicitPenaltyTool make_pressed(const PressCourse& course) {
    ImplicitPenaltyPlan plan = make_cube_plan(course.size, course.object);
    plan.settings.own_rounds = !course.runs_contact;
    return ImplicitPenaltyTool::build(plan).value();
}

// What the hand was given so far, and the most of that: as if the force had gone on evenly between two places.
struct Given {
    Vector3 at{Vector3::Zero()};
    Vector3 force{Vector3::Zero()};
    double energy_J = 0.0;
    double most_J = 0.0;
    void add(const Vector3& to, const Vector3& felt_N) {
        energy_J += 0.5 * (force + felt_N).dot(to - at);
        most_J = worse(most_J, energy_J);
        at = to;
        force = felt_N;
    }
};

// A tool that is as fast as the hand ever is has no more to bring along.
double find_brought_J(const PressCourse& course) {
    const double speed_m_per_s = course.size * (kDown_m / kDown_s + kSway_m * kSway_per_s);
    return 0.5 * kMass_kg * speed_m_per_s * speed_m_per_s;
}

Finding press_and_leave(const PressCourse& course) {
    ImplicitPenaltyTool tool = make_pressed(course);
    const MovingFrame object;
    const double none = std::numeric_limits<double>::quiet_NaN();
    const double above_m = course.top_m + course.size * (0.5 * kEdge_m + 0.012);
    tool.place(Pose::at({0.0, above_m, 0.0}));
    double most_N = 0.0;
    double pressed_N = 0.0;
    double free_N = 0.0;
    double t_s = 0.0;
    Given given{.at = {0.0, above_m, 0.0}};
    for (int i = 1; t_s < 1.5; ++i) {
        const double dt_s = course.find_dt_s ? course.find_dt_s(i) : 0.001;
        t_s += dt_s;
        if (course.runs_contact && course.runs_contact(t_s)) {
            tool.contact_loop().step(t_s);
        }
        const double down =
            std::min(1.0, t_s / kDown_s) - std::clamp((t_s - 0.9) / kDown_s, 0.0, 1.0);
        Vector3 at(course.size * kSway_m * std::sin(kSway_per_s * t_s),
                   above_m - course.size * kDown_m * down, 0.0);
        const bool is_garbage = course.is_garbage && course.is_garbage(i);
        if (is_garbage) {
            at.y() = i % 2 == 0 ? none : 1.0e300;
        }
        // Its speed as the loop finds it.
        const bool has_speed = !is_garbage && dt_s > 0.0;
        const Vector3 speed_m_per_s =
            has_speed ? Vector3((at - given.at) / dt_s) : Vector3(Vector3::Zero());
        const ToolFelt felt =
            tool.move({Pose::at(at), {speed_m_per_s, Vector3::Zero()}}, {&object, 1}, t_s, dt_s);
        const double felt_N = felt.felt_W.force.norm();
        if (!is_garbage) {
            given.add(at, felt.felt_W.force);
        }
        most_N = worse(most_N, felt_N);
        most_N = worse(most_N, tool.grip_W().position.allFinite() ? 0.0 : none);
        pressed_N = t_s > 0.6 && t_s < 0.9 ? worse(pressed_N, felt_N) : pressed_N;
        free_N = t_s < 0.05 || t_s > 1.4 ? worse(free_N, felt_N) : free_N;
    }
    double worst = worse(most_N / (1.0001 * kClamp_N), free_N > 0.0 ? 100.0 : 0.0);
    worst = worse(worst, pressed_N > 0.1 ? 0.0 : 100.0);
    worst = worse(worst, given.most_J / find_brought_J(course));
    return {
        worst, 1.0,
        describe("at most %.2g N, pressed %.2g N, free %.1g N, given at most %.2g of %.2g mJ",
                 most_N, pressed_N, free_N, 1.0e3 * given.most_J, 1.0e3 * find_brought_J(course))};
}

// A cube on an ideal spring, which nothing damps, is let go askew over an object, and the hand stands still: what it has in motion and in the spring
// is never more than at first, whatever it falls on, and most of it is there while it falls freely.
Finding let_go_over(const TriangleMesh& object, double top_m) {
    ImplicitPenaltyPlan plan = make_cube_plan(1.0, object);
    ImplicitPenaltySettings& settings = plan.settings;
    settings.critically_damped = false;
    settings.coupling.shift.damping_Ns_per_m = 0.0;
    settings.coupling.turn.damping_Nms_per_rad = Vector3::Zero();
    settings.contacts.damping_Ns_per_m = 0.0;
    auto tool = ImplicitPenaltyTool::build(plan).value();
    const MovingFrame still;
    const Pose hand = Pose::at({0.003, top_m + 0.5 * kEdge_m - 0.002, 0.0});
    tool.place(
        {hand.position + Vector3(0.002, 0.006, 0.001), compute_exp(Vector3(0.05, 0.02, 0.08))});
    const auto find_energy_J = [&] {
        const ToolCouplingSettings& coupling = tool.settings().coupling;
        const Pose grip = tool.grip_W();
        const double turn_rad =
            compute_log((hand.orientation * grip.orientation.conjugate()).normalized()).norm();
        return compute_kinetic_energy_J(settings.inertia, tool.state()) +
               0.5 * coupling.shift.stiffness_N_per_m *
                   (hand.position - grip.position).squaredNorm() +
               0.5 * coupling.turn.stiffness_Nm_per_rad * turn_rad * turn_rad;
    };
    const double at_first_J = find_energy_J();
    double most_J = 0.0;
    double falling_J = 0.0;
    int n_touching = 0;
    for (int i = 1; i <= 3000; ++i) {
        const ToolFelt felt = tool.move({hand, {}}, {&still, 1}, 0.001 * i, 0.001);
        most_J = worse(most_J, felt.moved ? find_energy_J() : std::nan(""));
        falling_J = i == 5 ? find_energy_J() : falling_J;
        n_touching += tool.touches()[0].touches ? 1 : 0;
    }
    double worst = most_J / at_first_J;
    worst = worse(worst, n_touching > 100 && falling_J > 0.8 * at_first_J ? 0.0 : 100.0);
    return {
        worst, 1.0,
        describe("%.2g mJ at first, touches in %d of 3000 steps", 1.0e3 * at_first_J, n_touching)};
}

TriangleMesh make_block(double size = 1.0) {
    return make_box(size * Vector3(0.1, 0.04, 0.1)).value();
}

// A block along z with twenty slivers of a micrometre in the middle of each side.
TriangleMesh make_slivered() {
    return make_prism(make_slivered_square(0.02), 0.1).value();
}

// Two bars that cross.
TriangleMesh make_crossed_bars() {
    return join_meshes({{make_box({0.12, 0.04, 0.03}).value(), {}},
                        {make_box({0.03, 0.04, 0.12}).value(), {}}})
        .value();
}

Finding press_at_all_sizes() {
    Finding worst{0.0, 1.0, ""};
    for (const double size : {0.3, 1.0, 10.0}) {
        const Finding one =
            press_and_leave({.object = make_block(size), .top_m = 0.02 * size, .size = size});
        worst = {worse(worst.worst, one.worst), 1.0, one.note};
    }
    return worst;
}

constexpr const char* kMeasure =
    "force ever felt in the clamp's, energy ever given in what a tool brings along; 100: something "
    "is felt in the free, or nothing while it presses";
constexpr const char* kEnergy =
    "energy of motion and spring, in that at first; 100: it did not fall, or touched nothing";

const HardCase kStall{{"levels tool while contact stalls",
                       "200 ms without a round of the contact thread", kMeasure, "", [] {
                           return press_and_leave(
                               {.object = make_block(),
                                .top_m = 0.02,
                                .runs_contact = [](double t_s) { return t_s < 0.5 || t_s > 0.7; }});
                       }}};
const HardCase kSlivered{
    {"levels tool on slivers", "twenty of 1 um in the middle of each side", kMeasure, "",
     [] { return press_and_leave({.object = make_slivered(), .top_m = 0.02}); }}};
const HardCase kThrough{
    {"levels tool on a mesh through itself", "where two bars cross", kMeasure, "",
     [] { return press_and_leave({.object = make_crossed_bars(), .top_m = 0.02}); }}};
const HardCase kRubbish{{"levels tool and garbage from the device",
                         "a pose in seven is no number or 1e300 m away", kMeasure, "", [] {
                             return press_and_leave(
                                 {.object = make_block(), .top_m = 0.02, .is_garbage = [](int i) {
                                      return i % 7 == 3;
                                  }});
                         }}};
const HardCase kUneven{
    {"levels tool in ragged time", "steps of 0.1 to 10 ms, and none", kMeasure, "", [] {
         return press_and_leave(
             {.object = make_block(), .top_m = 0.02, .find_dt_s = [](int i) {
                  constexpr std::array<double, 5> kSteps_s{1.0e-3, 1.0e-4, 1.0e-2, 0.0, 2.0e-3};
                  return kSteps_s[static_cast<std::size_t>(i) % 5];
              }});
     }}};
const HardCase kLetGo{{"levels tool let go over a block", "askew, on a spring without a damper",
                       kEnergy, "", [] { return let_go_over(make_block(), 0.02); }}};
const HardCase kLetGoSlivers{{"levels tool let go over slivers",
                              "askew, on a spring without a damper", kEnergy, "",
                              [] { return let_go_over(make_slivered(), 0.02); }}};
const HardCase kLetGoThrough{{"levels tool let go over a mesh through itself",
                              "askew, on a spring without a damper", kEnergy, "",
                              [] { return let_go_over(make_crossed_bars(), 0.02); }}};
const HardCase kSizes{
    {"levels tool of all sizes", "cubes of 9, 30 and 300 mm", kMeasure, "", press_at_all_sizes}};

}  // namespace
}  // namespace fulcrum::stability
