#include "haptics/flight/kite_loop.h"
#include "haptics/geometry/shape.h"
#include "haptics/loop/stage_listener.h"
#include "haptics/loop/told_rings.h"
#include "haptics/loop/touch_teller.h"
#include "tests/support/touchable.h"
#include "tests/unit/haptics/loop/haptic_loop_fixture.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

using namespace fulcrum;

namespace {

constexpr double kRounding_N = 1e-12;

HapticPlan make_shared_plan() {
    HapticPlan plan = make_weight_plan();
    plan.lesson_force = true;
    plan.fields = {FieldPlan{FieldKind::spring, Vector3(0.02, 0.0, 0.0), 40.0, 0.5},
                   FieldPlan{FieldKind::viscosity, Vector3::Zero(), 0.0, 3.0}};
    plan.solids = only_solid(touchable(make_sphere(0.05, 8)));
    plan.solids[0].body = 3;
    return plan;
}

struct Played {
    std::vector<RecordRound> rounds;
    std::vector<Wrench> applied_W;
    std::vector<EffectSlot> effects;
};

// A hand goes through the springs into the ball; a weight hangs from a while on.
Played play(bool is_told) {
    const auto ring = std::make_unique<RecordRing>();
    HandBench bench(make_shared_plan(), {}, {.record = is_told ? ring.get() : nullptr});
    bench.command.fields[0].anchor_W = make_shared_plan().fields[0].anchor_W;
    bench.world.solid_poses_W[0] = Pose::at(Vector3(0.0, -0.06, 0.0));
    Played told;
    told.effects = bench.loop.effects();
    for (int k = 0; k < 6000; ++k) {
        bench.command.linearised.stamp_s = bench.now_s + kDt_s;
        bench.command.linearised.force_W.z() = k > 1000 ? 0.3 : 0.0;
        bench.world.carried_force_W.y() = k > 3000 ? -1.0 : 0.0;
        bench.run_to(0.02 * Vector3(std::sin(0.003 * k), -std::sin(0.001 * k), 0.0));
        told.applied_W.push_back(bench.state().applied_W);
        for (RecordRound round; ring->pop(round);) {
            told.rounds.push_back(round);
        }
    }
    return told;
}

bool same_bits(const Wrench& a, const Wrench& b) {
    return std::memcmp(a.force.data(), b.force.data(), 3 * sizeof(double)) == 0 &&
           std::memcmp(a.torque.data(), b.torque.data(), 3 * sizeof(double)) == 0;
}

// Everything that a plan can hold.
HapticPlan make_full_plan() {
    HapticPlan plan = make_weight_plan();
    plan.lesson_force = true;
    plan.fields = {{.kind = FieldKind::spring, .stiffness_N_per_m = 30.0},
                   {.kind = FieldKind::viscosity, .damping_Ns_per_m = 1.0},
                   {.kind = FieldKind::magnet, .peak_force_N = 1.0, .range_m = 0.05}};
    plan.solids = only_solid(touchable(make_sphere(0.1, 4)));
    return plan;
}

class Listener final : public StageListener {
  public:
    void passed(HapticStage stage) noexcept override { stages.push_back(stage); }
    std::vector<HapticStage> stages;
};

// A lesson that pulls, a weight, and a hand on its way into the ball.
struct FedBench : Bench {
    explicit FedBench(const HapticPlan& plan) : Bench(plan) {
        command.linearised.force_W = {0.1, 0.2, 0.0};
        world.carried_force_W = {0.0, -0.5, 0.0};
    }
    void run(StageListener* listener) {
        now_s += kDt_s;
        command.stamp_s = command.linearised.stamp_s = world.stamp_s = now_s;
        channels->command.publish(command);
        channels->world.publish(world);
        device.pose_D.position = {0.12 - 0.04 * now_s, 0.01, 0.0};
        if (listener != nullptr) {
            loop.step_observed(now_s, *listener);
        } else {
            loop.step(now_s);
        }
    }
};

// What came out, as "kind tick value".
std::vector<std::string> drain(ToldRings& rings) {
    std::vector<std::string> out;
    rings.drain([&](const auto& told) {
        using T = std::remove_cvref_t<decltype(told.value)>;
        const std::string tick = " " + std::to_string(told.tick);
        if constexpr (std::is_same_v<T, ToldReading>) {
            out.push_back("reading" + tick);
        } else if constexpr (std::is_same_v<T, AxleOrders>) {
            out.push_back("axles" + tick);
        } else {
            out.push_back((std::is_same_v<T, ForceCommand> ? "command"
                           : std::is_same_v<T, WorldFrame> ? "world"
                           : std::is_same_v<T, RigidFrame> ? "rigid"
                                                           : "line") +
                          tick + " " + std::to_string(static_cast<int>(told.value.stamp_s)));
        }
    });
    return out;
}

HapticPlan make_heard_plan() {
    HapticPlan plan;
    plan.solids.resize(3);
    plan.solids[0].surface.audible = true;
    plan.solids[2].surface.audible = true;
    return plan;
}

}  // namespace

// What the loop tells of each effect: together they are what is commanded, and telling changes no force.

TEST_CASE("force shares: together they are the commanded force in every round") {
    const Played told = play(true);
    REQUIRE(told.effects.size() == 7);
    const Effect order[] = {Effect::contact, Effect::contact_damping, Effect::weight, Effect::field,
                            Effect::field,   Effect::lesson,          Effect::brake};
    for (std::size_t i = 0; i < told.effects.size(); ++i) {
        CHECK(told.effects[i].effect == order[i]);
    }
    CHECK((told.effects[3].field == 0 && told.effects[4].field == 1));
    REQUIRE(told.rounds.size() == told.applied_W.size());
    std::vector<double> most_N(told.effects.size(), 0.0);
    for (const RecordRound& round : told.rounds) {
        REQUIRE(round.shares.n == static_cast<std::int32_t>(told.effects.size()));
        Wrench sum_W{};
        for (std::size_t i = 0; i < told.effects.size(); ++i) {
            sum_W.force += round.shares.each_W[i].force;
            sum_W.torque += round.shares.each_W[i].torque;
            most_N[i] = std::max(most_N[i], round.shares.each_W[i].force.norm());
        }
        REQUIRE((sum_W.force - round.sample.commanded_W.force).norm() < kRounding_N);
        REQUIRE((sum_W.torque - round.sample.commanded_W.torque).norm() < kRounding_N);
    }
    // Each that was meant to act did, so that none is told in another's place; the brake need not.
    for (std::size_t i = 0; i + 1 < most_N.size(); ++i) {
        INFO(i);
        CHECK(most_N[i] > 0.01);
    }
    const RecordRound& last = told.rounds.back();
    CHECK(last.shares.each_W[2].force.y() == Approx(-1.0).margin(1e-3));
    CHECK(last.shares.each_W[5].force.z() == Approx(0.3));
    CHECK(std::ranges::any_of(told.rounds, [](const RecordRound& round) {
        return round.sample.touched_body == 3 && round.shares.each_W[0].force.y() > 0.1;
    }));
}

TEST_CASE("force shares: asking changes no force, and before the first pose all are zero") {
    const Played told = play(true);
    const Played untold = play(false);
    REQUIRE(untold.rounds.empty());
    for (std::size_t i = 0; i < told.applied_W.size(); ++i) {
        REQUIRE(same_bits(told.applied_W[i], untold.applied_W[i]));
    }
    LatestValue<ForceShares> shares;
    Bench mute(make_shared_plan(), {.shares = &shares});
    mute.device.gives_pose = false;
    mute.run(1);
    REQUIRE(shares.take());
    REQUIRE(shares.value().n == 7);
    for (std::size_t i = 0; i < 7; ++i) {
        CHECK(shares.value().each_W[i].force.norm() == 0.0);
    }
}

TEST_CASE("stage listener: a round that is watched is the same round to the byte") {
    const HapticPlan plan = make_full_plan();
    FedBench plain(plan);
    FedBench watched(plan);
    Listener listener;
    bool touched = false;
    for (int k = 1; k <= 1000; ++k) {
        plain.run(nullptr);
        watched.run(&listener);
        const HapticState& a = plain.state();
        const HapticState& b = watched.state();
        REQUIRE(a.commanded_W.force == b.commanded_W.force);
        REQUIRE(a.commanded_W.torque == b.commanded_W.torque);
        REQUIRE(a.applied_W.force == b.applied_W.force);
        REQUIRE(a.proxy_position_W == b.proxy_position_W);
        REQUIRE(a.faults == b.faults);
        touched = touched || a.touched_body >= 0;
    }
    CHECK(touched);
    CHECK(plain.state().applied_W.force.norm() > 0.1);
}

TEST_CASE("stage listener: it is told of the stages that were built, in order, and of no others") {
    HapticPlan bare;
    bare.expects_lesson = false;
    for (const HapticPlan& plan : {make_full_plan(), bare}) {
        FedBench bench(plan);
        Listener listener;
        bench.run(&listener);
        std::vector<HapticStage> built;
        for (const StageInfo& info : bench.loop.stages()) {
            built.push_back(info.stage);
        }
        CHECK(listener.stages == built);
    }
}

TEST_CASE("told rings: of each channel what was taken is kept with its round, once") {
    auto channels = std::make_unique<HapticChannels>();
    AxleChannels axles;
    RigidChannels rigid;
    KiteChannels kite;
    channels->axles = &axles;
    channels->rigid = &rigid;
    channels->kite = &kite;
    ToldRings rings(*channels);
    CHECK(rings.keep(0, {}));
    CHECK(drain(rings).empty());
    ForceCommand command;
    command.stamp_s = 3.0;
    channels->command.publish(command);
    CHECK(rings.keep(1, {}));  // not taken yet
    CHECK(drain(rings).empty());
    REQUIRE(channels->command.take());
    WorldFrame frame;
    frame.stamp_s = 4.0;
    channels->world.publish(frame);
    REQUIRE(channels->world.take());
    CHECK(rings.keep(2, {Fault::clutched, true}));
    CHECK(rings.keep(3, {}));
    axles.orders.publish({});
    REQUIRE(axles.orders.take());
    rigid.frame.publish({5.0});
    REQUIRE(rigid.frame.take());
    kite.line.publish({6.0});
    REQUIRE(kite.line.take());
    CHECK(rings.keep(4, {Fault::none, false}));
    CHECK(drain(rings) == std::vector<std::string>{"command 2 3", "world 2 4", "axles 4",
                                                   "rigid 4 5", "line 4 6", "reading 2",
                                                   "reading 4"});
    CHECK(rings.dropped() == 0);
}

TEST_CASE("told rings: what finds no room is told at once and counted") {
    auto channels = std::make_unique<HapticChannels>();
    ToldRings rings(*channels);
    std::uint64_t tick = 0;
    const auto tell = [&] {
        channels->world.publish({});
        REQUIRE(channels->world.take());
        return rings.keep(tick++, {});
    };
    for (std::size_t i = 0; i < kToldRingCapacity; ++i) {
        REQUIRE(tell());
    }
    CHECK_FALSE(tell());
    CHECK(rings.dropped() == 1);
    CHECK(drain(rings).size() == kToldRingCapacity);
    CHECK(tell());
    CHECK(rings.dropped() == 1);
}

TEST_CASE("touch teller: the audible solid that is pressed most, once a round, and its end once") {
    const HapticPlan plan = make_heard_plan();
    CHECK(TouchTeller::is_needed(plan));
    CHECK_FALSE(TouchTeller::is_needed(HapticPlan{}));
    const auto ring = std::make_unique<TouchRing>();
    TouchTeller teller(plan, *ring);
    TouchMotion motion(plan);
    const std::array<Pose, 3> poses{};
    TouchSample sample;
    const auto round = [&](std::span<const TouchForce> touches, double x) {
        motion.step(touches, poses, {Vector3(x, 0.0, 0.02), Vector3(0.1, -0.3, 0.0), 0.001});
        teller.step(touches, motion, nullptr, 1.5 + x);
    };
    round({}, 0.0);
    CHECK_FALSE(ring->pop(sample));
    const std::array<TouchForce, 3> touches{TouchForce{0, Vector3::UnitY(), 0.001, 500.0},
                                            TouchForce{1, Vector3::UnitY(), 0.009, 500.0},
                                            TouchForce{2, Vector3::UnitY(), 0.002, 400.0}};
    round(touches, 0.25);
    REQUIRE(ring->pop(sample));
    CHECK(sample.solid == 2);
    CHECK(sample.time_s == 1.75);
    CHECK(sample.u_m == 0.25F);
    CHECK(sample.v_m == 0.02F);
    CHECK(sample.normal_force_N == Approx(0.8F));
    CHECK(sample.slip_speed_m_per_s == Approx(0.1F));
    CHECK(sample.texture_height_m == 0.0F);
    // Both begin in this round, equally fast: the first is told of.
    CHECK(sample.impact_speed_m_per_s == 0.0F);
    round({touches.data(), 1}, 0.25);
    REQUIRE(ring->pop(sample));
    CHECK(sample.solid == 0);
    // Touched by what is not heard: the end is told once.
    round({touches.data() + 1, 1}, 0.25);
    REQUIRE(ring->pop(sample));
    CHECK(sample.solid == kNoBody);
    round({}, 0.25);
    CHECK_FALSE(ring->pop(sample));
    round({touches.data(), 1}, 0.25);
    REQUIRE(ring->pop(sample));
    CHECK(sample.impact_speed_m_per_s == Approx(0.3F));
}

TEST_CASE("felt time: what is asked for is felt, waits or was taken away, by the gate's phase") {
    struct {
        GatePhase gate;
        double asked_N, sent_N;
        FeltTime expected;
    } const rows[] = {
        {GatePhase::waiting, 3.0, 0.0, {.asked_s = 1.0, .waiting_s = 1.0}},
        {GatePhase::rising, 3.0, 0.2, {.asked_s = 1.0, .felt_s = 1.0}},
        {GatePhase::open, 3.0, 3.0, {.asked_s = 1.0, .felt_s = 1.0}},
        {GatePhase::fading, 3.0, 1.0, {.asked_s = 1.0, .felt_s = 1.0, .taken_s = 1.0}},
        {GatePhase::stopped, 3.0, 0.0, {.asked_s = 1.0, .taken_s = 1.0}},
        {GatePhase::fading, 0.0, 1.0, {.felt_s = 1.0}},
        {GatePhase::waiting, kLeastFelt_N, 0.0, {}},
    };
    for (const auto& row : rows) {
        HapticState state;
        state.gate = row.gate;
        state.commanded_W.force.x() = row.asked_N;
        state.applied_W.force.x() = row.sent_N;
        FeltTime time;
        time.add(state, 1.0);
        CHECK(time.asked_s == row.expected.asked_s);
        CHECK(time.felt_s == row.expected.felt_s);
        CHECK(time.waiting_s == row.expected.waiting_s);
        CHECK(time.taken_s == row.expected.taken_s);
    }
    FeltTime turned;
    HapticState state;
    state.commanded_W.torque.z() = -2.0 * kLeastFelt_Nm;
    turned.add(state, 0.5);
    CHECK(turned.asked_s == 0.5);
    CHECK(turned.shut_s() == 0.5);
}
