// A tool held out by clusters of contact (implicit_penalty.h) where that is hardest: a peg wedged by a turn, a plate on a thousand contacts, a
// sheet between two sheets, a wedge, a bar spun at 20 rad/s in a cage, tools of 1 to 500 g, and a contact thread that stalls for 200 ms. Contact is
// found by points in fields, and by contact levels of detail (level_contacts.h) with a tolerance of 2.5 %, both as a plan has them; by these on
// broken meshes too.
#include "tests/stability/cases/penalty_watch.h"
#include "tests/support/gear.h"
#include "tests/support/hard_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace fulcrum::stability {
namespace {

constexpr double kDt_s = kPenaltyDt_s;
constexpr double kMost_N = kPenaltyMost_N;

std::unique_ptr<ToolSolver> make(const PenaltyScene& scene) {
    return make_tool(plan_penalty(scene));
}

// What a course led to: the worst of its last fifth, in which the hand is still, and of all of it.
struct Rest {
    double speed_m_per_s = 0.0;
    double ripple_N = 0.0;
    double felt_N = 0.0;
    double most_N = 0.0;  // ever
    double most_Nm = 0.0;
    double step_N = 0.0;      // from one millisecond to the next, ever
    std::int64_t n_near = 0;  // contacts before they are clustered
    bool moved = true;
};

// Follows a tool step by step.
class Watch {
  public:
    explicit Watch(const ToolSolver& tool) : tool_(tool), last_m_(tool.grip_W().position) {}

    // Whether the hand is still in this step and the tool ought to be.
    void see(const ToolFelt& felt, bool rests) {
        rest_.moved = rest_.moved && felt.moved;
        rest_.n_near = felt.effort.n_points;
        rest_.felt_N = felt.felt_W.force.norm();
        rest_.most_N = worse(rest_.most_N, rest_.felt_N);
        rest_.most_Nm = worse(rest_.most_Nm, felt.felt_W.torque.norm());
        rest_.step_N = worse(rest_.step_N, (felt.felt_W.force - last_N_).norm());
        if (rests) {
            const double way_m = (tool_.grip_W().position - last_m_).norm();
            rest_.speed_m_per_s = worse(rest_.speed_m_per_s, way_m / kDt_s);
            least_N_ = std::min(least_N_, rest_.felt_N);
            greatest_N_ = worse(greatest_N_, rest_.felt_N);
            rest_.ripple_N = greatest_N_ - least_N_;
        }
        last_N_ = felt.felt_W.force;
        last_m_ = tool_.grip_W().position;
    }
    [[nodiscard]] const Rest& rest() const { return rest_; }

  private:
    const ToolSolver& tool_;
    Rest rest_;
    double least_N_ = HUGE_VAL;
    double greatest_N_ = 0.0;
    Vector3 last_N_{Vector3::Zero()};
    Vector3 last_m_;
};

// The hand goes by shares of the course; in the last fifth it is still.
Rest run(ToolSolver& tool, int n_steps, const std::function<MovingFrame(double)>& hand) {
    const MovingFrame object;
    tool.place(hand(0.0).pose_W);
    Watch watch(tool);
    for (int i = 1; i <= n_steps; ++i) {
        watch.see(tool.move(hand(static_cast<double>(i) / n_steps), {&object, 1}, i * kDt_s, kDt_s),
                  i > n_steps * 4 / 5);
    }
    return watch.rest();
}

constexpr const char* kMeasured =
    "worst of: speed at rest in 5 mm/s, ripple in 0.05 N, force ever felt in the clamp's, its step "
    "in a millisecond in 2 N; 100: it could not be moved, or nothing is felt";

Finding judge(const Rest& rest, double least_N = 0.5) {
    double worst = worse(rest.speed_m_per_s / 5.0e-3, rest.ripple_N / 0.05);
    worst = worse(worst, rest.most_N / (1.0001 * kMost_N));
    worst = worse(worst, rest.step_N / 2.0);
    worst = worse(worst, rest.moved && rest.felt_N >= least_N ? 0.0 : 100.0);
    return {
        worst, 1.0,
        describe("%.2g N at rest, ripple %.1g N, %.1g mm/s, at most %.2g N, steps of %.2g N",
                 rest.felt_N, rest.ripple_N, 1.0e3 * rest.speed_m_per_s, rest.most_N, rest.step_N)};
}

Finding worse_of(const Finding& a, const Finding& b) {
    return {worse(a.worst, b.worst), a.limit, a.note + "; " + b.note};
}

std::function<MovingFrame(double)> along(const Vector3& from, const Vector3& to) {
    return [from, to](double share) {
        return MovingFrame{Pose::at(from + std::min(1.0, 2.0 * share) * (to - from)), {}};
    };
}

Finding wedge_peg_by_turn(ContactFinding contact) {
    const auto tool = make({.tool = make_peg(0.01, 0.06, 72).value(),
                            .inertia = make_box_inertia(0.05, {0.02, 0.02, 0.06}),
                            .voxel_m = 0.001,
                            .objects = {make_bush(0.02, 0.0115, 0.03, 35).value()},
                            .contact = contact});
    // In, then turned askew by a third of a radian and pressed down on that.
    return judge(run(*tool, 4000, [](double share) {
        const double in = std::min(1.0, 4.0 * share);
        const double askew = std::clamp(4.0 * share - 1.0, 0.0, 1.0);
        return MovingFrame{
            {{0.0, 0.006 * askew, 0.07 - 0.07 * in}, compute_exp(Vector3(0.33 * askew, 0.0, 0.0))},
            {}};
    }));
}

Finding rest_on_a_thousand(ContactFinding contact) {
    const Vector3 size(0.1, 0.01, 0.1);
    ImplicitPenaltyPlan plan =
        make_implicit_penalty_plan(plan_penalty({.tool = make_box(size).value(),
                                                 .inertia = make_box_inertia(0.1, size),
                                                 .objects = {make_box({0.2, 0.02, 0.2}).value()},
                                                 .contact = contact}));
    // Levels find the same plate by a few pieces; their thousand is below. By fields there is room for all that are near: as a plan has them they are
    // thinned out to some 650.
    const bool by_fields = contact == ContactFinding::fields;
    plan.settings.most_near = by_fields ? 4096 : plan.settings.most_near;
    auto tool = ImplicitPenaltyTool::build(plan).value();
    const Rest rest = run(tool, 1000, along({0.0, 0.03, 0.0}, {0.0, 0.01, 0.0}));
    Finding finding = judge(rest);
    if (by_fields) {
        finding.note += ", " + std::to_string(rest.n_near) + " contacts";
        finding.worst = worse(finding.worst, rest.n_near >= 1000 ? 0.0 : 100.0);
    }
    return finding;
}

// A plate of 2 mm goes in between two of 4 mm that are 3 mm apart, is pressed on one, and on the other.
Finding slide_between_sheets(ContactFinding contact) {
    const TriangleMesh sheet = make_box({0.12, 0.004, 0.08}).value();
    const Vector3 size(0.06, 0.002, 0.04);
    const auto tool = make({.tool = make_box(size).value(),
                            .inertia = make_box_inertia(0.02, size),
                            .voxel_m = 0.001,
                            .objects = {sheet, sheet},
                            .contact = contact});
    const std::array<MovingFrame, 2> sheets{
        {{Pose::at({0.0, -0.0035, 0.0}), {}}, {Pose::at({0.0, 0.0035, 0.0}), {}}}};
    Finding all{0.0, 1.0, {}};
    for (const double side : {-1.0, 1.0}) {
        tool->place(Pose::at({-0.12, 0.0, 0.0}));
        Watch watch(*tool);
        for (int i = 1; i <= 3000; ++i) {
            const double in = std::min(1.0, i / 1000.0);
            const double press = std::clamp(i / 1000.0 - 1.0, 0.0, 1.0);
            const Pose hand = Pose::at({-0.12 + 0.12 * in, side * 0.004 * press, 0.0});
            watch.see(tool->move({hand, {}}, sheets, i * kDt_s, kDt_s), i > 2600);
        }
        Finding one = judge(watch.rest());
        // It may not have gone through either.
        one.worst = worse(one.worst, std::abs(tool->grip_W().position.y()) < 0.0015 ? 0.0 : 100.0);
        all = all.note.empty() ? one : worse_of(all, one);
    }
    return all;
}

// A bar in the square hole of a bush of four sides, which it cannot turn in: the hand turns at 20 rad/s.
Finding spin_in_cage(ContactFinding contact) {
    const Vector3 size(0.05, 0.008, 0.02);
    const auto tool = make({.tool = make_box(size).value(),
                            .inertia = make_box_inertia(0.02, size),
                            .voxel_m = 0.001,
                            .objects = {make_bush(0.05, 0.03, 0.04, 4).value()},
                            .contact = contact});
    const Rest rest = run(*tool, 3000, [](double share) {
        const double angle = 20.0 * 3.0 * share;
        return MovingFrame{{Vector3::Zero(), compute_exp(Vector3(0.0, 0.0, angle))},
                           {Vector3::Zero(), Vector3(0.0, 0.0, 20.0)}};
    });
    // It is struck about all the time, so nothing rests; it stays within the cage, and the force within the clamp.
    const double away_m = tool->grip_W().position.norm();
    const double clamp_Nm = 1.01 * kMost_N * 0.5 * size.norm();
    double worst = worse(rest.most_N / (1.0001 * kMost_N), rest.most_Nm / clamp_Nm);
    worst = worse(worst, away_m / 0.03);
    return {rest.moved && rest.most_Nm > 0.5 * clamp_Nm ? worst : 100.0, 1.0,
            describe("at most %.2g N and %.2g Nm, %.2g mm off the middle", rest.most_N,
                     rest.most_Nm, 1.0e3 * away_m)};
}

Finding press_light_and_heavy(ContactFinding contact) {
    Finding all{0.0, 1.0, {}};
    for (const double mass_kg : {0.001, 0.01, 0.1, 0.5}) {
        const Vector3 size(0.04, 0.02, 0.04);
        const auto tool = make({.tool = make_box(size).value(),
                                .inertia = make_box_inertia(mass_kg, size),
                                .objects = {make_box({0.2, 0.04, 0.2}).value()},
                                .contact = contact});
        const Finding one = judge(run(*tool, 2000, along({0.0, 0.06, 0.0}, {0.0, 0.01, 0.0})));
        all = all.note.empty() ? one : worse_of(all, one);
    }
    return all;
}

// The hand slides over a block and off its edge while nothing is told of contact, from 0.5 s to 0.7 s.
Finding stall_contact_thread() {
    const Vector3 size(0.04, 0.02, 0.04);
    ImplicitPenaltyPlan penalty =
        make_implicit_penalty_plan(plan_penalty({.tool = make_box(size).value(),
                                                 .inertia = make_box_inertia(0.01, size),
                                                 .objects = {make_box({0.1, 0.04, 0.1}).value()}}));
    penalty.settings.own_rounds = false;
    auto tool = ImplicitPenaltyTool::build(penalty).value();
    const MovingFrame block;
    Vector3 hand_m(-0.03, 0.04, 0.0);
    tool.place(Pose::at(hand_m));
    Watch watch(tool);
    Vector3 felt_N = Vector3::Zero();
    double given_J = 0.0;  // to the hand so far, as if the force had gone on evenly
    double most_given_J = 0.0;
    for (int i = 1; i <= 1400; ++i) {
        const double t_s = i * kDt_s;
        if (t_s < 0.5 || t_s > 0.7) {
            tool.contact_loop().step(t_s);
        }
        const double down = std::min(1.0, t_s / 0.3) - std::clamp((t_s - 0.9) / 0.3, 0.0, 1.0);
        const Vector3 at(-0.03 + 0.12 * std::clamp((t_s - 0.3) / 0.5, 0.0, 1.0),
                         0.04 - 0.015 * down, 0.0);
        const ToolFelt felt = tool.move({Pose::at(at), {}}, {&block, 1}, t_s, kDt_s);
        watch.see(felt, false);
        given_J += 0.5 * (felt_N + felt.felt_W.force).dot(at - hand_m);
        most_given_J = worse(most_given_J, given_J);
        felt_N = felt.felt_W.force;
        hand_m = at;
    }
    const Rest& rest = watch.rest();
    // At the end the hand has left, and nothing is felt.
    Finding finding = judge(rest, 0.0);
    finding.worst = worse(finding.worst, rest.felt_N > 0.0 ? 100.0 : 0.0);
    finding.worst = worse(finding.worst, rest.most_N > 2.0 ? 0.0 : 100.0);
    // Nor has it given the hand more than the tool may bring along from free space.
    constexpr double kBrought_J = 3.0e-4;  // 10 g at 24 cm/s
    finding.worst = worse(finding.worst, most_given_J / kBrought_J);
    finding.note += describe(", %.2g mJ given", 1.0e3 * most_given_J);
    return finding;
}

// A plate made of 361 loose triangles: a thousand corners, of which three would do.
Finding rest_loose_on_a_floor() {
    constexpr int kN = 19;
    std::vector<Vector3> vertices;
    std::vector<TriangleCorners> triangles;
    for (int i = 0; i < kN * kN; ++i) {
        const Vector3 at(0.004 * (i % kN) - 0.037, 0.0,
                         0.004 * static_cast<double>(i / kN) - 0.037);
        const auto first = static_cast<std::int32_t>(vertices.size());
        vertices.insert(vertices.end(),
                        {at, at + Vector3(0.002, 0.0, 0.0), at + Vector3(0.0, 0.0, 0.002)});
        triangles.push_back({first, first + 1, first + 2});  // they look down
    }
    const auto tool = make({.tool = TriangleMesh::build(vertices, triangles).value(),
                            .inertia = make_box_inertia(0.05, {0.08, 0.01, 0.08}),
                            .objects = {make_box({0.2, 0.02, 0.2}).value()},
                            .contact = ContactFinding::levels});
    return judge(run(*tool, 1000, along({0.0, 0.03, 0.0}, {0.0, 0.0, 0.0})));
}

// A cube goes round over a bumpy ball of 40 mm, pressed as deep as the force lets it. What is guaranteed: it is held, at most by the clamp's
// force, and its middle stays out of the ball.
Finding go_round_broken_ball(const TriangleMesh& ball) {
    const Vector3 size(0.03, 0.03, 0.03);
    const auto tool = make({.tool = make_box(size).value(),
                            .inertia = make_box_inertia(0.05, size),
                            .objects = {ball},
                            .contact = ContactFinding::levels});
    double nearest_m = HUGE_VAL;
    const Rest rest = run(*tool, 3000, [&](double share) {
        const double down = std::min(1.0, 5.0 * share);
        const double round = 2.0 * std::numbers::pi * std::clamp(1.6 * share - 0.32, 0.0, 0.8);
        if (share > 0.0) {
            nearest_m = std::min(nearest_m, tool->grip_W().position.norm());
        }
        return MovingFrame{hold_over_ball(down, round), {}};
    });
    double worst = worse(rest.most_N / (1.0001 * kMost_N), 0.04 / nearest_m);
    worst = worse(worst, rest.moved && rest.felt_N > 0.5 ? 0.0 : 100.0);
    return {worst, 1.0,
            describe("%.2g N at the end, at most %.2g N, no nearer to the middle than %.3g mm",
                     rest.felt_N, rest.most_N, 1.0e3 * nearest_m)};
}

TriangleMesh make_whole_ball() {
    return make_bumpy_sphere(0.04, 8, 0.1, 60.0).value();
}

// A case by either way of finding contact.
struct CasePair {
    CasePair(const std::string& name, const std::string& what, const std::string& measured,
             Finding (*find)(ContactFinding))
        : by_fields({"penalty " + name, what, measured, "",
                     [=] { return find(ContactFinding::fields); }}),
          by_levels({"levels " + name, what, measured, "",
                     [=] { return find(ContactFinding::levels); }}) {}
    HardCase by_fields;
    HardCase by_levels;
};

constexpr const char* kOfBroken =
    "force ever felt in the clamp's, radius of the ball in the least way to its middle; 100: it "
    "could not be moved, or nothing is felt";

const CasePair kTurned{"peg wedged by a turn", "in a hole, turned askew, pressed", kMeasured,
                       wedge_peg_by_turn};
const CasePair kFlat{"tool flat on a thousand contacts", "a plate at rest on a plate", kMeasured,
                     rest_on_a_thousand};
const CasePair kSheets{"sheet between two sheets", "2 mm between 3 mm, pressed on either",
                       kMeasured, slide_between_sheets};
const CasePair kSpun{
    "bar spun in a cage", "20 rad/s against four walls that it cannot turn between",
    "force and torque ever felt in the clamps', way from the middle in 3 cm; 100: it could not "
    "be moved, or turned freely",
    spin_in_cage};
const CasePair kMasses{"tools of 1 to 500 g", "pressed far deeper than the coupling pulls",
                       kMeasured, press_light_and_heavy};
const HardCase kLoose{{"levels tool of loose triangles", "a thousand corners on a floor", kMeasured,
                       "", rest_loose_on_a_floor}};
const HardCase kWhole{{"levels cube round a ball", "of one piece, to compare with broken ones",
                       kOfBroken, "", [] { return go_round_broken_ball(make_whole_ball()); }}};
const HardCase kFlipped{
    {"levels cube round flipped and doubled triangles",
     "and triangles without area, nothing welded", kOfBroken, "",
     [] { return go_round_broken_ball(make_messy(make_whole_ball(), 0.0).value()); }}};
const HardCase kCracked{
    {"levels cube round cracks of 0.1 mm", "a seam left open", kOfBroken, "",
     [] { return go_round_broken_ball(make_cracked(make_whole_ball(), 1.0e-4, 3, 0.0).value()); }}};
const HardCase kStalled{{"penalty tool while contact stalls",
                         "200 ms without a round of the contact thread, over an edge", kMeasured,
                         "", stall_contact_thread}};

}  // namespace
}  // namespace fulcrum::stability
