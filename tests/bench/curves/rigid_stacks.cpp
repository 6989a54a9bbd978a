// Stacks, a wall and heaps of rigid bodies at 1 kHz, collision detection included: what a step costs, beside other engines, and how it
// grows. Nothing sleeps.
#include "tests/bench/curves/rigid_stacks.h"

#include "tests/bench/harness/curve.h"
#include "tests/support/rigid_worlds.h"

#include <iterator>

namespace fulcrum::bench {
namespace {

constexpr double kFallen_m = 0.02;

RigidWorldPlan make_bare_plan() {
    RigidWorldPlan plan;
    plan.settings.sleep_after_s = 0.0;
    plan.bodies.push_back({.role = BodyRole::ground,
                           .static_friction = kStackFriction,
                           .dynamic_friction = kStackFriction});
    return plan;
}

RigidWorldPlan make_weightless_plan() {
    RigidWorldPlan plan;
    plan.settings.gravity_W.setZero();
    plan.settings.sleep_after_s = 0.0;
    return plan;
}

void add_box(RigidWorldPlan& plan, const StackBox& box) {
    plan.bodies.push_back({.shape = BoxShape{box.half_m},
                           .mass_kg = box.mass_kg,
                           .pose_W = Pose::at(box.at_W),
                           .static_friction = kStackFriction,
                           .dynamic_friction = kStackFriction});
}

void add_cube(RigidWorldPlan& plan, const Vector3& at) {
    add_box(plan, {.at_W = at});
}

RigidWorldPlan make_plan(const StackScene& scene) {
    RigidWorldPlan plan = make_bare_plan();
    for (const StackBox& box : scene.boxes) {
        add_box(plan, box);
    }
    return plan;
}

class FulcrumStack final : public StackEngine {
  public:
    explicit FulcrumStack(const RigidWorldPlan& plan) : world_(make_rigid_world(plan)) {
        world_->prepare(kStackStep_s);
    }
    void step() override { world_->step(kStackStep_s); }
    [[nodiscard]] Vector3 place(int box) const override {
        return world_->shape_pose_W(box + 1).position;
    }
    void push(int box, const Vector3& force_W) override {
        world_->push(box + 1, {force_W, Vector3::Zero()});
    }
    void throw_from(int box, const Vector3& at_W, const Vector3& velocity_W) override {
        world_->place(box + 1, Pose::at(at_W), {velocity_W, Vector3::Zero()});
    }
    [[nodiscard]] RigidWorld& world() { return *world_; }

  private:
    std::unique_ptr<RigidWorld> world_;
};

template <class Step>
std::vector<double> time_steps(int n_steps, Step step) {
    std::vector<double> us;
    us.reserve(static_cast<std::size_t>(n_steps));
    for (int i = 0; i < n_steps; ++i) {
        us.push_back(time_by_clock_us([&] { step(i); }));
    }
    return us;
}

CostPoint measure_stack_of(const std::string& name, const StackScene& scene,
                           const MakeStackEngine& make, int n_steps) {
    const auto engine = make(scene);
    const std::vector<double> us = time_steps(n_steps, [&](int) { engine->step(); });
    double sunk_m = 0.0;
    double drift_m = 0.0;
    double below_m = -kCubeHalf_m;
    bool stands = true;
    for (std::size_t i = 0; i < scene.boxes.size(); ++i) {
        const Vector3 at = engine->place(static_cast<int>(i));
        sunk_m = std::max(sunk_m, 2.0 * kCubeHalf_m - (at.y() - below_m));
        drift_m = std::max(drift_m, std::hypot(at.x(), at.z()));
        stands = stands && std::abs(at.y() - scene.boxes[i].at_W.y()) <= kFallen_m;
        below_m = at.y();
    }
    const auto told = [&](double m) { return stands ? 1.0e3 * m : kNone; };
    return {name,
            static_cast<double>(scene.boxes.size()),
            told(std::max(sunk_m, drift_m)),
            summarise(us),
            {told(sunk_m), told(drift_m)}};
}

}  // namespace

StackScene make_stack(int n_cubes, double top_kg, double apart_m) {
    StackScene scene;
    for (int i = 0; i < n_cubes; ++i) {
        const double height_m = kCubeHalf_m * (2 * i + 1) + apart_m * (i + 1);
        scene.boxes.push_back(
            {.mass_kg = i + 1 == n_cubes ? top_kg : 1.0, .at_W = {0.0, height_m, 0.0}});
    }
    return scene;
}

StackScene make_wall() {
    StackScene scene;
    for (int i = 0; i < 100; ++i) {
        const int row = i / 10;
        scene.boxes.push_back({.half_m = {0.1, 0.05, 0.05},
                               .at_W = {0.2 * (i % 10) + 0.1 * (row % 2), 0.05 + 0.1 * row, 0.0}});
    }
    return scene;
}

std::unique_ptr<StackEngine> make_fulcrum_stack(const StackScene& scene) {
    return std::make_unique<FulcrumStack>(make_plan(scene));
}

std::vector<CostPoint> measure_stacks(const std::string& name, const MakeStackEngine& make,
                                      const Run& run) {
    const int n_steps = run.pick(10000, 1000);
    std::vector<CostPoint> points;
    for (const int n : {6, 10, 20}) {
        points.push_back(measure_stack_of(name, make_stack(n), make, n_steps));
    }
    points.push_back(
        measure_stack_of(name + ", 100:1 on top", make_stack(20, 100.0), make, n_steps));
    return points;
}

namespace {

CostCurve measure_standing(Run& run) {
    CostCurve curve;
    curve.name = "rigid-stacks";
    curve.title = "Stacks of cubes that stand for ten seconds";
    curve.work =
        "6, 10 and 20 equal aligned cubes of 0.1 m and 1 kg, friction 0.6, 1 ms a step, from rest, "
        "and 20 with 100 kg on top; collision detection included, nothing sleeps. A stack that "
        "fell has no error.";
    curve.reference = "exact: where the cubes were put";
    curve.advice = "Stacks of any of these sizes fit a haptic step, and stay where they are.";
    curve.knob = {"cubes", "", true};
    curve.error = {"how far a cube sinks or drifts", "mm", true};
    curve.extras = {{"penetration", "mm", true}, {"sideways drift", "mm", true}};
    curve.default_series = "Fulcrum";
    curve.default_knob = 10.0;
    curve.points = measure_stacks("Fulcrum", make_fulcrum_stack, run);
    return curve;
}

struct Course {
    std::string name;
    RigidWorldPlan plan;
    std::function<void(FulcrumStack&, int)> disturb;
};

// Those that other engines are put to, but for what only stands, and what only ours is asked.
std::vector<Course> make_courses() {
    std::vector<Course> courses;
    for (EngineCourse& course : make_engine_courses()) {
        if (!course.name.starts_with("20 ")) {
            courses.push_back({course.name, make_plan(course.scene), course.disturb});
        }
    }
    return courses;
}

// Every 20 steps all bodies are where they began, as fast.
std::function<void(FulcrumStack&, int)> begin_again(const RigidWorldPlan& plan) {
    return [bodies = plan.bodies](FulcrumStack& stack, int i) {
        for (std::size_t body = 0; i % 20 == 0 && body < bodies.size(); ++body) {
            if (bodies[body].role == BodyRole::moves) {
                stack.world().place(static_cast<std::int32_t>(body), bodies[body].pose_W,
                                    bodies[body].velocity_W);
            }
        }
    };
}

Course make_passing(const std::string& name, double speed_m_per_s) {
    Course course{name, make_weightless_plan(), {}};
    for (int i = 0; i < 64; ++i) {
        const double way = i / 8 % 2 == 0 ? 1.0 : -1.0;
        course.plan.bodies.push_back(
            {.shape = SphereShape{0.02},
             .mass_kg = 0.1,
             .pose_W = Pose::at({0.1 * (i % 8), 0.0, 0.045 * (i / 8)}),
             .velocity_W = {{way * speed_m_per_s, 0.0, 0.0}, Vector3::Zero()}});
    }
    course.disturb = begin_again(course.plan);
    return course;
}

// Each hits one that stands before a wall, which is farther than anybody had looked for.
Course make_held_back() {
    Course course{
        "8 balls that are hit by others at 100 m/s before a wall", make_weightless_plan(), {}};
    for (int i = 0; i < 8; ++i) {
        for (const double side : {0.0, 1.0}) {
            course.plan.bodies.push_back({.shape = SphereShape{0.02},
                                          .mass_kg = 0.1,
                                          .pose_W = Pose::at({-0.0437 * side, 0.0, 0.1 * i}),
                                          .velocity_W = {{100.0 * side, 0.0, 0.0}, Vector3::Zero()},
                                          .restitution = 1.0});
        }
    }
    course.plan.bodies.push_back({.shape = BoxShape{{0.0005, 1.0, 1.0}},
                                  .role = BodyRole::stays,
                                  .pose_W = Pose::at({0.0825, 0.0, 0.0})});
    course.disturb = begin_again(course.plan);
    return course;
}

Course make_chain(const std::string& name, double spin_rad_per_s) {
    Course course{name, make_weightless_plan(), [](FulcrumStack&, int) {}};
    for (int i = 0; i < 10; ++i) {
        const double at_m = 0.1 * i - 0.45;
        course.plan.bodies.push_back(
            {.shape = SphereShape{0.03},
             .mass_kg = 0.1,
             .pose_W = Pose::at({at_m, 0.0, 0.0}),
             .velocity_W = {{0.0, at_m * spin_rad_per_s, 0.0}, {0.0, 0.0, spin_rad_per_s}}});
        if (i > 0) {
            course.plan.joints.push_back({.kind = JointKind::ball,
                                          .body_a = i - 1,
                                          .body_b = i,
                                          .anchor_W = {at_m - 0.05, 0.0, 0.0}});
        }
    }
    return course;
}

// What looking ahead, holding back, hands and parts of a step cost, beside the same without.
std::vector<Course> make_costly_courses() {
    std::vector<Course> courses{make_passing("64 balls that pass each other at 0.2 m/s", 0.2),
                                make_passing("64 balls that pass each other at 20 m/s", 20.0),
                                make_held_back(),
                                make_chain("a chain of 10 that goes round at 30 rad/s", 30.0),
                                make_chain("a chain of 10 that goes round at 300 rad/s", 300.0)};
    courses.push_back({"10 at rest, each gripped by a hand", make_plan(make_stack(10)),
                       [](FulcrumStack& stack, int) {
                           RigidWorld& world = stack.world();
                           for (std::int32_t cube = 1; cube <= 10; ++cube) {
                               BodyHold hold{.at_W = world.shape_pose_W(cube).position};
                               hold.slopes = {600.0, 5.0, 0.5, 0.01, 0.04};
                               hold.bounds = {.most_N = 9.0, .most_Nm = 0.2};
                               world.hold(cube, hold);
                           }
                       }});
    return courses;
}

Sheet measure_courses(Run& run) {
    Sheet sheet{
        "rigid-courses",
        "Steps of stacks that are left alone, dropped and hit, and of what is looked ahead for",
        "The same cubes, and what flies, hits, goes round or is held, at 1 ms a step, collision "
        "detection included, one thread, nothing sleeps.",
        "Worst steps are those of this machine too, which is interrupted now and then.",
        {"course", "median µs", "99 % µs", "worst µs", "deepest mm", "unconverged", "held back",
         "in parts"}};
    const int n_steps = run.pick(5000, 500);
    std::vector<Course> courses = make_courses();
    std::ranges::move(make_costly_courses(), std::back_inserter(courses));
    for (const Course& course : courses) {
        run.progress(0.5, course.name);
        FulcrumStack stack(course.plan);
        double deepest_m = 0.0;
        int n_unconverged = 0;
        int n_held = 0;
        int n_in_parts = 0;
        std::vector<double> us = time_steps(n_steps, [&](int i) {
            course.disturb(stack, i);
            stack.step();
            const auto& report = stack.world().report();
            deepest_m = std::max(deepest_m, report.deepest_m);
            n_unconverged += report.n_unconverged;
            n_held += report.n_held;
            n_in_parts += report.n_in_parts;
        });
        const double worst_us = *std::max_element(us.begin(), us.end());
        const Cost cost = summarise(std::move(us));
        sheet.add({course.name, rounded(cost.median_us, 2), rounded(cost.p99_us, 2),
                   rounded(worst_us, 2), 1.0e3 * deepest_m, n_unconverged, n_held, n_in_parts});
    }
    return sheet;
}

LineChart measure_growth(Run& run) {
    LineChart chart;
    chart.name = "rigid-growth";
    chart.title = "A step of the world against its bodies";
    chart.work =
        "Cubes at rest at 1 ms a step, four contacts each: in one stack, in stacks of five, and "
        "each alone on the ground; the median of a step, collision detection included, nothing "
        "sleeps.";
    chart.x = {"bodies", "", true};
    chart.y = {"time a step", "µs", true};
    struct Heap {
        const char* name;
        int height;
    };
    std::string grows;
    for (const Heap& heap :
         {Heap{"one stack", 1 << 20}, Heap{"stacks of five", 5}, Heap{"alone", 1}}) {
        chart.trace(heap.name, LineStyle::measured,
                    run.pick<std::vector<double>>({5, 10, 20, 40}, {5, 20}), [&](double n) {
                        RigidWorldPlan plan = make_bare_plan();
                        for (int i = 0; i < static_cast<int>(n); ++i) {
                            add_cube(plan, {0.3 * (i / heap.height),
                                            kCubeHalf_m * (2 * (i % heap.height) + 1), 0.0});
                        }
                        const auto world = make_rigid_world(plan);
                        return summarise(time_steps(run.pick(2000, 300),
                                                    [&](int) { world->step(kStackStep_s); }))
                            .median_us;
                    });
        grows += (grows.empty() ? "" : ", ") + std::string(heap.name) + " " +
                 to_text(rounded(find_power(chart.lines.back()), 2));
    }
    chart.advice =
        "Time grows as the number of bodies, and so of contacts, to the power of: " + grows + ".";
    return chart;
}

Report run_rigid_stacks(Run& run) {
    CostCurve standing = measure_standing(run);
    Sheet courses = measure_courses(run);
    Sheet engines = measure_stack_engines(run);
    return {std::move(standing), std::move(courses), std::move(engines), measure_growth(run)};
}

const Registration kRigidStacks{{"rigid-stacks",
                                 "stacks and a wall of rigid bodies beside other engines: time, "
                                 "penetration and drift, hits, and growth with the bodies",
                                 run_rigid_stacks}};

}  // namespace
}  // namespace fulcrum::bench
