// What each effect adds to a round of the haptic loop: the same hand and the same messages, scene after scene beside the bare
// loop. Rounds are timed in batches between two answers of a lesson; the scenes take turns, and each keeps the pass with its
// least median, for what the machine does besides only adds.
#include "haptics/device/simulated/simulated_hand.h"
#include "haptics/geometry/shape.h"
#include "haptics/loop/haptic_loop.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/tool_scene.h"
#include "tests/support/touchable.h"

namespace fulcrum::bench {
namespace {

constexpr double kDt_s = 0.001;
constexpr int kBatch = 16;  // rounds between two answers of a lesson at 60 Hz
constexpr double kBall_m = 0.05;
constexpr double kOutside_m = 0.02;  // the hand's way about the ball, and into it
constexpr double kInside_m = -0.005;
constexpr double kTool_m = 0.01;
constexpr double kPressed_m = kTool_m - 0.002;  // a tool's middle over the ball
constexpr double kHeavy_N = 3.0;

// A hand that goes round the ball at a given height over it; where it is in each round of a batch is known beforehand.
class Walker final : public Device {
  public:
    explicit Walker(double height_m) : radius_m_(kBall_m + height_m) {
        traits_.name = "a hand on its way";
        traits_.renders_force = true;
        traits_.max_force_N = 100.0;
        traits_.max_torque_Nm = 10.0;
    }
    [[nodiscard]] const DeviceTraits& traits() const noexcept override { return traits_; }
    [[nodiscard]] bool read(double now_s, DeviceReading& reading) noexcept override {
        reading.stamp_s = now_s;
        reading.pose_D.position = positions_[next_++ % kBatch];
        return true;
    }
    [[nodiscard]] bool write(double /*now_s*/, const Wrench& wrench_D) noexcept override {
        keep(wrench_D);
        return true;
    }
    [[nodiscard]] Vector3 position_at(int k) const {
        const double angle = 0.003 * k;
        return radius_m_ * Vector3(std::cos(angle), std::sin(angle), 0.1).normalized();
    }
    void prepare(int first) {
        next_ = 0;
        for (int i = 0; i < kBatch; ++i) {
            positions_[static_cast<std::size_t>(i)] = position_at(first + i);
        }
    }

  private:
    DeviceTraits traits_;
    double radius_m_;
    std::array<Vector3, kBatch> positions_{};
    std::size_t next_ = 0;
};

struct Scene {
    std::string name;
    HapticPlan plan;
    double height_m = kOutside_m;
    bool simulated_hand = false;
    bool changing_weight = false;
    bool recorded = false;
};

// One scene's loop with all that it needs.
class Stand {
  public:
    explicit Stand(const Scene& scene)
        : scene_(scene),
          walker_(scene.height_m),
          hand_(SimulatedHandSettings{}, target_),
          loop_(scene.plan, scene.simulated_hand ? static_cast<Device&>(hand_) : walker_,
                channels_) {
        if (scene.recorded) {
            channels_.record = &ring_;
        }
    }

    // One pass: microseconds a round.
    Cost measure(int n_batches) {
        std::vector<double> us;
        for (int i = 0; i < n_batches; ++i) {
            prepare();
            time_batches([&] { loop_.step(kDt_s * ++round_); },
                         {.samples = 1, .batch = kBatch, .warm_up = 0}, us);
        }
        return summarise(std::move(us));
    }
    std::size_t count_bytes() const {
        std::size_t n = 0;
        for (const StageInfo& stage : loop_.stages()) {
            n += stage.bytes;
        }
        return n;
    }

  private:
    // As lesson, world and recorder do, outside the time that is taken.
    void prepare() {
        walker_.prepare(round_);
        HandTarget wanted;
        wanted.pose_D.position = walker_.position_at(round_);
        target_.publish(wanted);
        ForceCommand command;
        command.stamp_s = kDt_s * round_;
        command.lesson_alive = true;
        command.linearised.stamp_s = command.stamp_s;
        command.linearised.force_W.x() = std::sin(0.01 * round_);
        channels_.command.publish(command);
        WorldFrame world;
        world.stamp_s = command.stamp_s;
        const bool is_light = scene_.changing_weight && round_ / 256 % 2 == 0;
        world.carried_force_W.y() = is_light ? 0.0 : -kHeavy_N;
        channels_.world.publish(world);
        RecordRound round;
        while (ring_.pop(round)) {
        }
    }

    Scene scene_;
    HapticChannels channels_;
    RecordRing ring_;
    LatestValue<HandTarget> target_;
    Walker walker_;
    SimulatedHand hand_;
    HapticLoop loop_;
    int round_ = 0;
};

HapticPlan make_field(FieldKind kind) {
    HapticPlan plan;
    FieldPlan field;
    field.kind = kind;
    field.stiffness_N_per_m = 20.0;
    field.damping_Ns_per_m = 2.0;
    field.peak_force_N = 2.0;
    plan.fields = {field};
    return plan;
}

HapticPlan make_weight() {
    HapticPlan plan;
    plan.carries_weight = true;
    plan.expects_world = true;
    return plan;
}

// Every scene with forces has the passivity stage; this is the same scene without it.
HapticPlan make_unwatched(HapticPlan plan) {
    plan.passivity.on = false;
    return plan;
}

HapticPlan make_solid() {
    HapticPlan plan;
    plan.solids = only_solid(touchable(make_sphere(kBall_m, 10)));
    return plan;
}

// A ball of 1 cm and 2000 points in the hand.
HapticPlan make_tool(ToolMethod method) {
    HapticPlan plan = make_solid();
    plan.tool = test::make_tool_of({.tool = make_sphere(kTool_m, 12).value(),
                                    .inertia = make_ball_inertia(0.02, kTool_m),
                                    .method = method,
                                    .voxel_m = 0.002},
                                   {make_sphere(kBall_m, 10).value()});
    return plan;
}

HapticPlan make_lesson() {
    HapticPlan plan;
    plan.lesson_force = true;
    return plan;
}

HapticPlan make_estimator(VelocityMethod method) {
    HapticPlan plan;
    plan.velocity_method = method;
    return plan;
}

// The bare loop first, for the others are measured against it.
std::vector<Scene> list_scenes() {
    return {
        {"bare: reads the hand, no force", {}},
        {"velocity by finite differences", make_estimator(VelocityMethod::finite_difference)},
        {"velocity by a low pass", make_estimator(VelocityMethod::filtered_difference)},
        {"velocity by a Kalman filter", make_estimator(VelocityMethod::kalman)},
        {"weight that stays", make_weight()},
        {"weight that stays, without the passivity stage", make_unwatched(make_weight())},
        {.name = "weight that comes and goes (the gravity lesson)",
         .plan = make_weight(),
         .changing_weight = true},
        {"spring", make_field(FieldKind::spring)},
        {"viscosity", make_field(FieldKind::viscosity)},
        {"magnet", make_field(FieldKind::magnet)},
        {"a lesson's own force", make_lesson()},
        {"a solid, not touched", make_solid()},
        {"a solid, touched", make_solid(), kInside_m},
        {"a solid, touched, without the passivity stage", make_unwatched(make_solid()), kInside_m},
        {"a tool in a distance field, not touching", make_tool(ToolMethod::field_sampling)},
        {"a tool in a distance field, touching", make_tool(ToolMethod::field_sampling), kPressed_m},
        {"a tool among voxels, not touching", make_tool(ToolMethod::voxel_sampling)},
        {"a tool among voxels, touching", make_tool(ToolMethod::voxel_sampling), kPressed_m},
        {.name = "recorded", .plan = {}, .recorded = true},
        {.name = "the gravity lesson with the simulated hand",
         .plan = make_weight(),
         .simulated_hand = true,
         .changing_weight = true},
    };
}

Report run_stage_cost(Run& run) {
    const std::vector<Scene> scenes = list_scenes();
    std::vector<std::unique_ptr<Stand>> stands;
    for (const Scene& scene : scenes) {
        stands.push_back(std::make_unique<Stand>(scene));
    }
    std::vector<Cost> costs(scenes.size(), {HUGE_VAL, HUGE_VAL});
    const int n_passes = run.pick(21, 4);
    for (int pass = 0; pass < n_passes; ++pass) {
        run.progress(static_cast<double>(pass) / n_passes);
        for (std::size_t i = 0; i < scenes.size(); ++i) {
            const Cost cost = stands[i]->measure(run.pick(1000, 200));
            costs[i] = cost.median_us < costs[i].median_us ? cost : costs[i];
        }
    }
    Sheet sheet{
        "stage-cost",
        "What each effect adds to a round of the haptic loop",
        "A hand goes round a ball of 5 cm at 0.2 m/s, 2 cm over it (touched: 5 mm inside), 1 kHz. "
        "Rounds are timed by 16, without what lesson and world do; of several passes the one with "
        "the least median. The bare loop estimates the hand's velocity by the adaptive window. The "
        "tool is a ball of 1 cm with 2000 points, 2 mm inside where it touches.",
        "Every effect is a small part of the millisecond that a round has, so choose by what is to "
        "be felt; a solid that is touched costs as much as one or two bare rounds more, a tool "
        "with force and torque tens of them.",
        {"scene", "median µs", "99 % µs", "added µs", "times bare",
         "state in bytes, meshes included"}};
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        sheet.add({scenes[i].name, rounded(costs[i].median_us, 3), rounded(costs[i].p99_us, 3),
                   rounded(costs[i].median_us - costs[0].median_us, 3),
                   rounded(costs[i].median_us / costs[0].median_us, 2), stands[i]->count_bytes()});
    }
    return {sheet};
}

const Registration kStageCost{
    {"stage-cost", "what each effect adds to a round of the haptic loop", run_stage_cost}};

}  // namespace
}  // namespace fulcrum::bench
