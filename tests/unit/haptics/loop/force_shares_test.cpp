// What the loop tells of each effect: together they are what is commanded, and telling changes no force.
#include "haptics/geometry/shape.h"
#include "tests/support/touchable.h"
#include "tests/unit/haptics/loop/haptic_loop_fixture.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <vector>

using namespace fulcrum;

namespace {

// A sum of a dozen forces of some newtons, added in another order.
constexpr double kRounding_N = 1e-12;

HapticPlan make_plan() {
    HapticPlan plan = make_weight_plan();
    plan.lesson_force = true;
    plan.fields = {FieldPlan{FieldKind::spring, Vector3(0.02, 0.0, 0.0), 40.0, 0.5},
                   FieldPlan{FieldKind::viscosity, Vector3::Zero(), 0.0, 3.0}};
    plan.solids = only_solid(touchable(make_sphere(0.05, 8)));
    plan.solids[0].body = 3;
    return plan;
}

struct Told {
    std::vector<RecordRound> rounds;
    std::vector<Wrench> applied_W;
    std::vector<EffectSlot> effects;
};

// A hand goes through the springs into the ball; a weight hangs from a while on.
Told play(bool is_told) {
    const auto ring = std::make_unique<RecordRing>();
    HandBench bench(make_plan(), {}, {.record = is_told ? ring.get() : nullptr});
    bench.command.fields[0].anchor_W = make_plan().fields[0].anchor_W;
    bench.world.solid_poses_W[0] = Pose::at(Vector3(0.0, -0.06, 0.0));
    Told told;
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

}  // namespace

TEST_CASE("force shares: together they are the commanded force in every round") {
    const Told told = play(true);
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

TEST_CASE("force shares: asking for them changes no force") {
    const Told told = play(true);
    const Told untold = play(false);
    REQUIRE(untold.rounds.empty());
    for (std::size_t i = 0; i < told.applied_W.size(); ++i) {
        REQUIRE(same_bits(told.applied_W[i], untold.applied_W[i]));
    }
}

TEST_CASE("force shares: before the device has given a pose every share is zero, as the force is") {
    LatestValue<ForceShares> shares;
    Bench mute(make_plan(), {.shares = &shares});
    mute.device.gives_pose = false;
    mute.run(1);
    REQUIRE(shares.take());
    REQUIRE(shares.value().n == 7);
    for (std::size_t i = 0; i < 7; ++i) {
        CHECK(shares.value().each_W[i].force.norm() == 0.0);
    }
}
