// Pushes through a whole loop on simulated arms: good ones, one whose motors push against what they are told, one that is clamped.
#include "haptics/loop/push_trial.h"

#include "tests/support/bad_numbers.h"
#include "tests/support/pushed_arm.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace fulcrum;

namespace {

struct Bench : PushedArm {
    using PushedArm::PushedArm;
    PushTrial push(const Vector3& way_W, const PushSettings& settings = {}) {
        PushTrial trial(settings, way_W);
        for (int frames = 0; trial.end() == PushEnd::running && frames < 6000; ++frames) {
            frame(trial.step(loop->state(), now_s));
        }
        for (int i = 0; i < 30; ++i) {
            frame(Vector3::Zero());
        }
        return trial;
    }
    PushVerdict try_way(const Vector3& way_W) {
        const PushTrial plus = push(way_W);
        const PushTrial minus = push(-way_W);
        CHECK(plus.end() == PushEnd::done);
        CHECK(minus.end() == PushEnd::done);
        return judge_pushes(way_W, plus.motion_W(), minus.motion_W());
    }
};

}  // namespace

TEST_CASE("push trial: an arm that pushes as it is told moves the hand by F / k, less friction") {
    SimulatedArmSettings smooth = arm_held_by(kPosture);
    smooth.dry_friction_N = 0.0;
    Bench bench(Matrix3::Identity(), smooth);
    for (const Vector3& way_W :
         {Vector3(Vector3::UnitX()), Vector3(Vector3::UnitY()), Vector3(Vector3::UnitZ())}) {
        const PushTrial trial = bench.push(way_W);
        REQUIRE(trial.end() == PushEnd::done);
        const double expected_m = 0.8 / kPosture.stiffness_N_per_m;
        // The mean begins while the hand still swings to its rest.
        CHECK((trial.motion_W() - expected_m * way_W).norm() < 0.05 * expected_m);
    }
    CHECK(bench.arm->largest_N <= 1.0);
}

TEST_CASE("push trial: with friction, steps and any usual hand it is felt, softly, below 1 N") {
    for (const HumanImpedance& human : {kArm, kPosture}) {
        Bench bench(Matrix3::Identity(), arm_held_by(human));
        for (const Vector3& way_W :
             {Vector3(Vector3::UnitX()), Vector3(Vector3::UnitY()), Vector3(Vector3::UnitZ())}) {
            CHECK(bench.try_way(way_W) == PushVerdict::with);
        }
        CHECK(bench.arm->largest_N <= 1.0);
        CHECK(bench.arm->largest_step_N <= 0.05);
    }
}

TEST_CASE("push trial: wrong motors are noticed; a hand that goes back or far ends it at once") {
    Matrix3 mirrored = Matrix3::Identity();
    mirrored(0, 0) = -1.0;
    Bench one_axis(mirrored);
    CHECK(one_axis.try_way(Vector3::UnitX()) == PushVerdict::against);
    CHECK(one_axis.try_way(Vector3::UnitY()) == PushVerdict::with);
    Matrix3 exchanged = Matrix3::Zero();
    exchanged(0, 1) = exchanged(1, 0) = exchanged(2, 2) = 1.0;
    Bench crossed(exchanged);
    CHECK(crossed.try_way(Vector3::UnitX()) == PushVerdict::aside);
    CHECK(crossed.try_way(Vector3::UnitZ()) == PushVerdict::with);
    // Dead motors, or a clamped arm.
    Bench dead(Matrix3::Zero());
    CHECK(dead.try_way(Vector3::UnitX()) == PushVerdict::unfelt);
    // A free arm with its motors reversed runs away against the push.
    Bench reversed(-Matrix3::Identity(), arm_held_by({0.3, 2.0, 20.0}));
    const PushTrial back = reversed.push(Vector3::UnitX());
    CHECK(back.end() == PushEnd::ran_against);
    CHECK(back.motion_W().isZero());
    Bench loose(Matrix3::Identity(), arm_held_by({0.1, 1.0, 1.0}));
    CHECK(loose.push(Vector3::UnitX()).end() == PushEnd::ran_away);
    CHECK(loose.loop->state().applied_W.force.norm() < 1e-9);
}

TEST_CASE("push trial: what disturbs it makes it begin anew, and in the end give up") {
    Bench bench;
    PushTrial trial({}, Vector3::UnitX());
    int disturbances = 0;
    for (int i = 0; trial.end() == PushEnd::running && i < 6000; ++i) {
        const Vector3 force_W = trial.step(bench.loop->state(), bench.now_s);
        bench.arm->told = force_W.norm() > 0.5 && disturbances < 2 ? Fault::clutched : Fault::none;
        disturbances += any(bench.arm->told) ? 1 : 0;
        bench.frame(force_W);
    }
    CHECK(disturbances == 2);
    REQUIRE(trial.end() == PushEnd::done);
    // What was seen while it was disturbed is not counted.
    CHECK(trial.motion_W().x() > 0.5 * 0.8 / kPosture.stiffness_N_per_m);
    Bench shut;
    shut.arm->told = Fault::emergency_stop;
    const PushTrial waits = shut.push(Vector3::UnitX());
    CHECK(waits.end() == PushEnd::disturbed);
    CHECK(shut.arm->largest_N == 0.0);
}

TEST_CASE("push trial: a clock that stands, or a place that is none, gives no force") {
    PushTrial trial({}, Vector3::UnitX());
    HapticState state;
    state.gate = GatePhase::open;
    double now_s = 0.0;
    Vector3 force_W = Vector3::Zero();
    while (force_W.norm() < 0.5) {
        force_W = trial.step(state, now_s += 0.01);
        REQUIRE(now_s < 5.0);
    }
    CHECK(trial.step(state, now_s).isZero());
    CHECK(trial.step(state, now_s - 1.0).isZero());
    CHECK(trial.step(state, std::nan("")).isZero());
    state.tool_pose_W.position.x() = kNan;
    CHECK(trial.step(state, now_s + 0.01).isZero());
    CHECK(judge_pushes(Vector3::UnitX(), state.tool_pose_W.position, Vector3::Zero()) ==
          PushVerdict::unfelt);
}

TEST_CASE("push trial: slow wandering falls out of two opposite pushes") {
    const Vector3 wandering(0.004, -0.003, 0.002);
    const Vector3 way_W = Vector3::UnitY();
    const Vector3 pushed = 0.003 * way_W;
    CHECK(judge_pushes(way_W, wandering + pushed, wandering - pushed) == PushVerdict::with);
    CHECK(judge_pushes(way_W, wandering - pushed, wandering + pushed) == PushVerdict::against);
    CHECK(judge_pushes(way_W, wandering, wandering) == PushVerdict::unfelt);
    // At the border.
    const auto judge = [&](double along_m, double across_m) {
        const Vector3 motion_W(across_m, along_m, 0.0);
        return judge_pushes(way_W, motion_W, -motion_W);
    };
    CHECK(judge(0.99 * kLeastMotion_m, 0.0) == PushVerdict::unfelt);
    CHECK(judge(-0.99 * kLeastMotion_m, 0.0) == PushVerdict::unfelt);
    CHECK(judge(1.01 * kLeastMotion_m, 0.0) == PushVerdict::with);
    CHECK(judge(-1.01 * kLeastMotion_m, 0.0) == PushVerdict::against);
    CHECK(judge(0.002, 0.0039) == PushVerdict::with);
    CHECK(judge(0.002, 0.0041) == PushVerdict::aside);
}

TEST_CASE("push trial: a push lost in friction is unfelt, and bad settings are refused") {
    CHECK(validate(PushSettings{}));
    CHECK_FALSE(validate(PushSettings{.force_N = 3.01}));
    CHECK_FALSE(validate(PushSettings{.force_N = std::nan("")}));
    CHECK_FALSE(validate(PushSettings{.ramp_s = 0.1}));
    CHECK_FALSE(validate(PushSettings{.hold_s = 0.1}));
    CHECK_FALSE(validate(PushSettings{.settle_s = 60.0}));
    SimulatedArmSettings heavy = arm_held_by(kPosture);
    heavy.dry_friction_N = 2.0;
    for (const double sign : {1.0, -1.0}) {
        Bench bench(Vector3(sign, 1.0, 1.0).asDiagonal(), heavy);
        CHECK(bench.try_way(Vector3::UnitX()) == PushVerdict::unfelt);
        const PushTrial plus = bench.push(Vector3::UnitX(), {.force_N = kMostPush_N});
        CHECK(plus.motion_W().x() * sign >= 0.0);
    }
}
