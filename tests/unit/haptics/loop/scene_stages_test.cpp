#include "haptics/loop/scene_forces.h"
#include "haptics/loop/scene_solids.h"
#include "haptics/loop/stage_listener.h"
#include "haptics/loop/touch_stage.h"
#include "tests/unit/haptics/loop/haptic_loop_fixture.h"

#include <catch2/catch.hpp>

#include <array>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

using namespace fulcrum;

namespace {

constexpr double kPeriod_s = 1.0e-3;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

FieldPlan make_spring(double stiffness_N_per_m) {
    FieldPlan field;
    field.kind = FieldKind::spring;
    field.stiffness_N_per_m = stiffness_N_per_m;
    return field;
}

// A floor at the height of its body, two springs and a weight.
HapticPlan make_plan() {
    HapticPlan plan;
    plan.coupling = {.stiffness_N_per_m = 500.0, .damping_Ns_per_m = 0.0};
    plan.solids = {{.body = 3, .shape = BoxShape{{0.1, 0.1, 0.1}}}};
    plan.expects_world = true;
    plan.carries_weight = true;
    plan.fields = {make_spring(100.0), make_spring(40.0)};
    return plan;
}

// The scene of a plan, and a hand in it that stands.
struct Scene {
    explicit Scene(HapticPlan of) : plan(std::move(of)) {
        channels->shares = shares.get();
        state.tool_pose_W = Pose::at({0.0, -0.01, 0.0});
    }
    void tell(const WorldFrame& frame) {
        channels->world.publish(frame);
        (void)channels->world.take();
    }
    SceneRound round(bool has_pose = true, bool heard_world = true) {
        return {.state = state,
                .teller = teller,
                .gate = gate,
                .hand = {velocity, now_s},
                .now_s = now_s,
                .dt_s = kPeriod_s,
                .has_pose = has_pose,
                .heard_world = heard_world};
    }
    void go(const SceneRound& round) {
        (void)velocity.step(state.tool_pose_W.position, now_s);
        forces.move(round, NobodyListens{});
        forces.compute(round, NobodyListens{});
        teller.publish(state, now_s, kPeriod_s);
        now_s += kPeriod_s;
    }
    // What each effect was told to add in the last round.
    std::vector<Vector3> take_shares() {
        REQUIRE(shares->take());
        std::vector<Vector3> forces_W;
        for (std::int32_t i = 0; i < shares->value().n; ++i) {
            forces_W.push_back(shares->value().each_W[static_cast<std::size_t>(i)].force);
        }
        return forces_W;
    }

    HapticPlan plan;
    std::unique_ptr<LatestValue<ForceShares>> shares = std::make_unique<LatestValue<ForceShares>>();
    std::unique_ptr<HapticChannels> channels = std::make_unique<HapticChannels>();
    SceneForces forces{plan, ScriptedDevice().traits_, plan.safety, *channels,
                       std::make_unique<FloorProxy>()};
    std::vector<EffectSlot> effects = forces.list_effects();
    RoundTeller teller{with_shares(), effects};
    SafetyGate gate{plan.safety, kPeriod_s};
    VelocityEstimator velocity{VelocitySettings{}};
    HapticState state{};
    double now_s = 1.0;

  private:
    HapticChannels& with_shares() {
        channels->shares = shares.get();
        return *channels;
    }
};

TEST_CASE("scene forces: the sum is that of what each effect is told to add") {
    Scene scene(make_plan());
    WorldFrame frame;
    frame.carried_force_W = {0.0, -2.0, 0.0};
    scene.tell(frame);
    for (int i = 0; i < 400; ++i) {
        scene.go(scene.round());
    }
    const std::vector<Vector3> shares = scene.take_shares();
    // Coupling and its damping, weight, two springs, in the order of the step. The hand is 1 cm below the floor and the anchors.
    REQUIRE(shares.size() == 5);
    REQUIRE(scene.effects.size() == 5);
    CHECK(shares[0].y() == Approx(5.0));
    CHECK(shares[1].y() == Approx(0.0).margin(1.0e-12));
    CHECK(shares[2].y() == Approx(-2.0));
    CHECK(shares[3].y() == Approx(1.0));
    CHECK(shares[4].y() == Approx(0.4));
    CHECK(scene.forces.demand().wrench_W.force.y() == Approx(4.4));
    CHECK(scene.state.commanded_W.force.y() == Approx(4.4));
    CHECK(scene.forces.demand().force.now_W.y() == Approx(4.4));
    CHECK(scene.forces.demand().contact.force.y() == Approx(5.0));
    CHECK(scene.state.proxy_position_W.y() == 0.0);
    CHECK(scene.state.touched_body == 3);
    CHECK_FALSE(any(scene.state.faults));
}

TEST_CASE("scene forces: without a pose, or where a solid is nowhere, nothing holds the hand off") {
    Scene scene(make_plan());
    WorldFrame frame;
    scene.tell(frame);
    scene.go(scene.round(false));
    CHECK(scene.take_shares()[0].isZero(0.0));
    CHECK(scene.state.commanded_W.force.isZero(0.0));
    CHECK(scene.state.touched_body == kNoBody);
    CHECK(scene.state.proxy_position_W == scene.state.tool_pose_W.position);

    for (int i = 0; i < 400; ++i) {
        scene.go(scene.round());
    }
    CHECK(scene.state.touched_body == 3);
    frame.solid_poses_W[0].position.x() = kNone;
    scene.tell(frame);
    scene.go(scene.round());
    CHECK(scene.state.faults == Fault::command_invalid);
    CHECK(scene.state.touched_body == kNoBody);
    CHECK(scene.take_shares()[0].isZero(0.0));
    // Springs pull on.
    CHECK(scene.forces.demand().wrench_W.force.y() == Approx(1.4));

    // As long as nobody has spoken solids are where the plan has them.
    scene.state.faults = Fault::none;
    scene.go(scene.round(true, false));
    CHECK_FALSE(any(scene.state.faults));
    CHECK(scene.state.touched_body == 3);
}

TEST_CASE("scene forces: a weight that is no number is a fault") {
    Scene scene(make_plan());
    WorldFrame frame;
    frame.carried_force_W.y() = kNone;
    scene.tell(frame);
    scene.go(scene.round());
    CHECK(scene.state.faults == Fault::command_invalid);
    CHECK(scene.forces.demand().wrench_W.force.allFinite());
}

class StageList final : public StageListener {
  public:
    void passed(HapticStage stage) noexcept override { stages.push_back(stage); }
    std::vector<HapticStage> stages;
};

TEST_CASE("scene forces: stages are told as they end, those that there are") {
    Scene scene(make_plan());
    scene.tell({});
    StageList heard;
    scene.forces.move(scene.round(), TellsListener{heard});
    scene.forces.compute(scene.round(), TellsListener{heard});
    std::vector<StageInfo> built;
    scene.forces.list_stages(built);
    REQUIRE(built.size() == 5);
    REQUIRE(heard.stages.size() == 5);
    for (std::size_t i = 0; i < built.size(); ++i) {
        CHECK(heard.stages[i] == built[i].stage);
        CHECK(built[i].rate_Hz == scene.plan.rate_hz);
    }
}

TEST_CASE("scene solids: they are where the world tells, and what is put elsewhere is told once") {
    HapticPlan plan = make_plan();
    plan.solids[0].initial_pose_W = Pose::at({0.5, 0.0, 0.0});
    const auto channels = std::make_unique<HapticChannels>();
    SceneSolids solids(plan, *channels);
    CHECK(solids.may_move());
    REQUIRE(solids.step(nullptr, 1.0));
    REQUIRE(solids.poses_W().size() == 1);
    CHECK(solids.poses_W()[0].position.x() == 0.5);
    CHECK(solids.body_of(0) == 3);
    CHECK(solids.body_of(kNoBody) == kNoBody);

    WorldFrame frame;
    frame.solid_poses_W[0].position.x() = 0.25;
    for (const std::uint32_t placements : {1U, 2U}) {
        frame.solid_placements[0] = placements;
        REQUIRE(solids.step(&frame, 1.001));
        CHECK(solids.poses_W()[0].position.x() == 0.25);
        CHECK(solids.put() == 1U);
        REQUIRE(solids.step(&frame, 1.002));
        CHECK(solids.put() == 0U);
    }
    solids.leave();
    CHECK(solids.poses_W().empty());
    REQUIRE(solids.step(&frame, 1.003));
    frame.solid_poses_W[0].position.x() = kNone;
    CHECK_FALSE(solids.step(&frame, 1.004));
    CHECK(solids.poses_W().empty());

    plan.expects_world = false;
    CHECK_FALSE(SceneSolids(plan, *channels).may_move());
    plan.axles = {{}};
    CHECK(SceneSolids(plan, *channels).may_move());
}

TEST_CASE("touch stage: what is left, or jumped away from, gives no force") {
    HapticPlan plan = make_plan();
    TouchStage stage(plan, std::make_unique<FloorProxy>(), ScriptedDevice().traits_, nullptr);
    VelocityEstimator velocity{VelocitySettings{}};
    const std::array<Pose, 1> floor{};
    const Vector3 deep_W(0.0, -0.01, 0.0);
    (void)velocity.step(deep_W, 1.0);
    const auto feel = [&](const Vector3& hand_W) {
        (void)stage.move(Pose::at(hand_W), floor);
        return stage.couple(hand_W, {velocity, 1.0}, floor).force_W;
    };
    CHECK(feel(deep_W).y() == Approx(5.0));
    REQUIRE(stage.touches().size() == 1);
    CHECK(feel(-deep_W).isZero(0.0));
    CHECK(stage.touches().empty());
    CHECK(feel(deep_W).y() == Approx(5.0));
    stage.leave();
    CHECK(stage.couple(deep_W, {velocity, 1.0}, floor).force_W.isZero(0.0));
    CHECK(feel(deep_W).y() == Approx(5.0));
    stage.forget(deep_W);
    CHECK(stage.touches().empty());
    CHECK(stage.effects() == nullptr);
}

}  // namespace
