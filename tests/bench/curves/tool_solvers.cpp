// One scene by every way in which a tool can be kept outside: a block on a table, by the one word that a lesson changes. What the hand should feel is
// known in closed form: the coupling's spring, from where the hand is to where the block would lie on the table exactly.
#include "haptics/math/rotation.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/tool_scene.h"

namespace fulcrum::bench {
namespace {

constexpr double kDt_s = 0.001;
constexpr double kStiffness_N_per_m = 500.0;
constexpr double kPressed_m = 0.006;
constexpr double kMass_kg = 0.02;
constexpr double kLight_kg = 0.01;  // what is tried for stability
const Vector3 kEdges_m(0.04, 0.02, 0.03);
const double kOnEdge_rad =
    std::atan2(kEdges_m.x(), kEdges_m.y());                 // an edge right below the middle
const MovingFrame kTable{Pose::at({0.0, -0.02, 0.0}), {}};  // its top is y = 0

struct Solver {
    const char* name;
    ToolMethod method;
    ToolMass mass = ToolMass::massive;
    double round_s = 0.0;  // of the contact thread
    ContactFinding contact = ContactFinding::fields;
};
const std::vector<Solver> kSolvers{
    {"field_sampling", ToolMethod::field_sampling},
    {"field_sampling, massless", ToolMethod::field_sampling, ToolMass::massless},
    {"voxel_sampling", ToolMethod::voxel_sampling},
    {"voxel_sampling, massless", ToolMethod::voxel_sampling, ToolMass::massless},
    {"implicit_penalty", ToolMethod::implicit_penalty},
    {"implicit_penalty, contact found 100 times a second", ToolMethod::implicit_penalty,
     ToolMass::massive, 0.01},
    {"implicit_penalty, contact by levels", ToolMethod::implicit_penalty, ToolMass::massive, 0.0,
     ContactFinding::levels},
    {"god_object", ToolMethod::god_object}};

struct Setting {
    double stiffness_N_per_m = kStiffness_N_per_m;
    double mass_kg = kMass_kg;
    bool silent = true;
    double contact_times = 1.0;  // as stiff as a plan makes contacts
};

// A god-object's contacts have no stiffness.
bool has_soft_contacts(const Solver& solver) {
    return solver.method != ToolMethod::god_object;
}

void stiffen_contacts(double times, ToolPlan& plan) {
    if (plan.penalty) {
        plan.penalty->contacts.stiffness_N_per_m *= times;
    }
    if (auto* const voxels = std::get_if<std::vector<VoxelSamplingPlan>>(&plan.objects)) {
        voxels->front().settings.stiffness_N_per_m *= times;
    }
    if (auto* const fields = std::get_if<std::vector<FieldSamplingPlan>>(&plan.objects)) {
        fields->front().settings.stiffness_N_per_m *= times;
    }
}

std::unique_ptr<ToolSolver> make_block(const Solver& solver, const Setting& setting) {
    test::ToolScene scene = test::make_ball_tool(solver.method);
    scene.tool = make_box(kEdges_m).value();
    scene.inertia = make_box_inertia(setting.mass_kg, kEdges_m);
    scene.voxel_m = 0.002;
    scene.in_rows = true;
    scene.contact = solver.contact;
    scene.settings.mass = solver.mass;
    scene.settings.silent_in_free_space = setting.silent;
    scene.settings.coupling.shift.stiffness_N_per_m = setting.stiffness_N_per_m;
    scene.settings.coupling.turn.stiffness_Nm_per_rad = 1.0e-3 * setting.stiffness_N_per_m;
    ToolPlan plan = *test::make_tool_of(scene, {make_box({0.2, 0.04, 0.2}).value()});
    if (plan.penalty) {
        plan.penalty->round_s = solver.round_s;
    }
    if (setting.contact_times == 1.0) {
        return make_tool(plan);
    }
    stiffen_contacts(setting.contact_times, plan);
    return validate(plan) ? make_tool(plan) : nullptr;
}

double find_depth_m(const ToolSolver& tool) {
    double lowest_m = 0.0;
    for (int i = 0; i < 8; ++i) {
        const Vector3 corner(i % 2 == 0 ? 0.5 : -0.5, i / 2 % 2 == 0 ? 0.5 : -0.5,
                             i / 4 == 0 ? 0.5 : -0.5);
        lowest_m = std::min(lowest_m, (tool.grip_W() * corner.cwiseProduct(kEdges_m)).y());
    }
    return -lowest_m;
}

struct Pressed {
    double error = 0.0;  // of the felt force's size, when at rest
    double ripple =
        0.0;  // between the least and the greatest force of the last tenth of a second, over their mean
    double depth_m = 0.0;
    bool moved = true;
};

// The hand comes down in 0.3 s, turned about z by that, to `pressed_m` deeper than the table lets the block, and rests.
Pressed press(ToolSolver& tool, double turn_rad, const Setting& setting, double pressed_m) {
    const double half_m =
        0.5 * (kEdges_m.y() * std::cos(turn_rad) + kEdges_m.x() * std::sin(turn_rad));
    const Quaternion turn = compute_exp(Vector3(0.0, 0.0, turn_rad));
    Pressed pressed;
    double least_N = 1.0e9;
    double most_N = 0.0;
    tool.place({Vector3(0.0, half_m + 0.02, 0.0), turn});
    for (int i = 1; i <= 1000; ++i) {
        const double down = std::min(1.0, i / 300.0);
        const Vector3 at(0.0, half_m + 0.02 - (0.02 + pressed_m) * down, 0.0);
        const ToolFelt felt = tool.move({{at, turn}, {}}, {&kTable, 1}, i * kDt_s, kDt_s);
        pressed.moved = pressed.moved && felt.moved && felt.felt_W.force.allFinite();
        pressed.depth_m = std::max(pressed.depth_m, find_depth_m(tool));
        if (i > 900) {
            least_N = std::min(least_N, felt.felt_W.force.norm());
            most_N = std::max(most_N, felt.felt_W.force.norm());
        }
    }
    const double ideal_N = setting.stiffness_N_per_m * pressed_m;
    const double mean_N = 0.5 * (least_N + most_N);
    pressed.error = std::abs(mean_N - ideal_N) / ideal_N;
    pressed.ripple = mean_N > 0.0 ? (most_N - least_N) / mean_N : HUGE_VAL;
    return pressed;
}

// Pressed flat and drawn along at 5 cm/s: the share of the force that holds it back, where nothing should.
struct Drawn {
    double drag = 0.0;
    Cost cost;
};
Drawn draw(const Solver& solver, double seconds) {
    const std::unique_ptr<ToolSolver> tool = make_block(solver, {});
    tool->place(Pose::at({-0.04, 0.02, 0.0}));
    Drawn drawn;
    std::vector<double> us;
    double along_N = 0.0;
    double down_N = 0.0;
    const int n = static_cast<int>(seconds * 1000.0);
    for (int i = 1; i <= n; ++i) {
        const double down_m = std::min(1.0, i / 300.0) * (0.01 + kPressed_m);
        // To and fro.
        const double phase = 2.0 * std::numbers::pi * 0.2 * std::max(0, i - 300) * kDt_s;
        const Vector3 at(-0.04 * std::cos(phase), 0.02 - down_m, 0.0);
        const Vector3 v(0.04 * 2.0 * std::numbers::pi * 0.2 * std::sin(phase), 0.0, 0.0);
        ToolFelt felt;
        const Took took = time_once([&] {
            felt = tool->move({Pose::at(at), {v, Vector3::Zero()}}, {&kTable, 1}, i * kDt_s, kDt_s);
        });
        us.push_back(took.clock_us);
        if (i > 400 && std::abs(v.x()) > 0.02) {
            along_N += std::abs(felt.felt_W.force.x());
            down_N += std::abs(felt.felt_W.force.y());
        }
    }
    drawn.drag = along_N / down_N;
    drawn.cost = summarise(std::move(us));
    return drawn;
}

// What is felt of it in free air at 10 m/s^2, if nothing hides it; kilograms.
double find_felt_mass_kg(const Solver& solver) {
    constexpr double kPace_m_per_s2 = 10.0;
    const std::unique_ptr<ToolSolver> tool = make_block(solver, {.silent = false});
    tool->place(Pose::at({0.0, 1.0, 0.0}));
    ToolFelt felt;
    for (int i = 1; i <= 300; ++i) {
        const double t_s = i * kDt_s;
        felt = tool->move({Pose::at({0.5 * kPace_m_per_s2 * t_s * t_s, 1.0, 0.0}),
                           {{kPace_m_per_s2 * t_s, 0.0, 0.0}, Vector3::Zero()}},
                          {&kTable, 1}, t_s, kDt_s);
    }
    return felt.felt_W.force.norm() / kPace_m_per_s2;
}

// The largest number for which something holds, between two, to a factor of 2^(1 / parts); kNone where not even the least does.
template <class Holds>
double find_largest(double least, double most, int parts, const Holds& holds) {
    if (!holds(least)) {
        return kNone;
    }
    if (holds(most)) {
        return most;
    }
    while (most / least > std::exp2(1.0 / parts)) {
        const double middle = std::sqrt(least * most);
        (holds(middle) ? least : most) = middle;
    }
    return least;
}

// Does a tool of 10 g rest on the table, and on its edge, without a ripple of a hundredth?
bool does_rest(const Solver& solver, double contact_times) {
    const Setting setting{.mass_kg = kLight_kg, .contact_times = contact_times};
    for (const double turn_rad : {0.0, kOnEdge_rad}) {
        const std::unique_ptr<ToolSolver> tool = make_block(solver, setting);
        if (tool == nullptr) {
            return false;
        }
        const Pressed pressed = press(*tool, turn_rad, setting, kPressed_m);
        if (!pressed.moved || !(pressed.ripple < 0.01)) {
            return false;
        }
    }
    return true;
}

// In parts of what a plan makes.
std::string find_stiffest_contact(const Solver& solver, int parts) {
    if (!has_soft_contacts(solver)) {
        return "hard";
    }
    const double times =
        find_largest(1.0 / 64.0, 1024.0, parts, [&](double n) { return does_rest(solver, n); });
    return std::isfinite(times) ? to_text(rounded(times, 2)) : "none of those tried";
}

// Does a hand of 0.5 kg and 2 Ns/m that presses the block on the table by 2 N come to rest, within a twentieth of what it feels?
bool does_hand_rest(const Solver& solver, double stiffness_N_per_m) {
    constexpr double kHand_kg = 0.5;
    constexpr double kHand_Ns_per_m = 2.0;
    constexpr double kPush_N = 2.0;
    const Setting setting{.stiffness_N_per_m = stiffness_N_per_m, .mass_kg = kLight_kg};
    const std::unique_ptr<ToolSolver> tool = make_block(solver, setting);
    if (tool == nullptr) {
        return false;
    }
    double y_m = 0.012;
    double speed_m_per_s = 0.0;
    double least_N = 1.0e9;
    double most_N = 0.0;
    tool->place(Pose::at({0.0, y_m, 0.0}));
    // Its own damping settles it in half a second, where nothing else does.
    for (int i = 1; i <= 5000; ++i) {
        const MovingFrame hand{Pose::at({0.0, y_m, 0.0}),
                               {{0.0, speed_m_per_s, 0.0}, Vector3::Zero()}};
        const ToolFelt felt = tool->move(hand, {&kTable, 1}, i * kDt_s, kDt_s);
        if (!felt.moved || !felt.felt_W.force.allFinite()) {
            return false;
        }
        speed_m_per_s +=
            kDt_s / kHand_kg * (felt.felt_W.force.y() - kPush_N - kHand_Ns_per_m * speed_m_per_s);
        y_m += kDt_s * speed_m_per_s;
        if (i > 4800) {
            least_N = std::min(least_N, felt.felt_W.force.y());
            most_N = std::max(most_N, felt.felt_W.force.y());
        }
    }
    return most_N > 0.5 * kPush_N && most_N - least_N < 0.05 * kPush_N;
}

std::string find_stiffest_coupling(const Solver& solver, int parts) {
    constexpr double kMost_N_per_m = 64000.0;
    const double stiffest = find_largest(500.0, kMost_N_per_m, parts,
                                         [&](double k) { return does_hand_rest(solver, k); });
    if (!std::isfinite(stiffest)) {
        return "none of those tried";
    }
    return to_text(std::round(stiffest)) +
           (stiffest == kMost_N_per_m ? ", the stiffest tried" : "");
}

Report run_tool_solvers(Run& run) {
    Sheet sheet{
        "tool-solvers",
        "One block on one table, by every solver",
        "A block of 4 x 2 x 3 cm, 20 g and 2000 points (among voxels one a voxel) on a coupling of "
        "500 N/m, voxels of 2 mm, pressed 6 mm too deep, flat and on its edge, and drawn along "
        "flat. Stability by bisection, of a tool of 10 g at 1 kHz: the stiffest contact by which "
        "it rests, flat and on an edge, with a ripple of less than 1 %, in parts of what a plan "
        "makes; and the stiffest coupling by which a hand of 0.5 kg and 2 Ns/m that presses with 2 "
        "N comes to rest",
        "field_sampling unless something speaks against it; implicit_penalty where contact is "
        "found late or the coupling is stiff; voxel_sampling for models that no field can be made "
        "of; massless where no inertia may be felt and jumps may.",
        {"solver", "quadrant", "force off, flat, %", "force off, on an edge, %", "deepest, mm",
         "drag, %", "felt mass in free air, g", "step, median us", "99 %, us", "memory, MB",
         "stiffest contact, times", "stiffest coupling in a hand, N/m"}};
    const int parts = run.pick(4, 1);
    for (const Solver& solver : kSolvers) {
        run.progress(sheet.rows.size(), kSolvers.size(), solver.name);
        const std::unique_ptr<ToolSolver> block = make_block(solver, {});
        const Pressed flat = press(*block, 0.0, {}, kPressed_m);
        const Pressed edge = press(*block, kOnEdge_rad, {}, kPressed_m);
        const Drawn drawn = draw(solver, run.pick(10.0, 2.0));
        sheet.add({solver.name, find_quadrant(solver.method, solver.mass),
                   rounded(100.0 * flat.error, 2), rounded(100.0 * edge.error, 2),
                   rounded(1.0e3 * std::max(flat.depth_m, edge.depth_m), 2),
                   rounded(100.0 * drawn.drag, 2), rounded(1.0e3 * find_felt_mass_kg(solver), 1),
                   drawn.cost.median_us, drawn.cost.p99_us,
                   rounded(1.0e-6 * static_cast<double>(block->memory_bytes()), 2),
                   find_stiffest_contact(solver, parts), find_stiffest_coupling(solver, parts)});
    }
    return {sheet};
}

const Registration kToolSolvers{
    {"tool-solvers", "one scene by every way of keeping a tool outside: error, depth, mass, time",
     run_tool_solvers}};

}  // namespace
}  // namespace fulcrum::bench
