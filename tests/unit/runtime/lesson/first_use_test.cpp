// The whole first use through a loop, a simulated arm and a simulated child, who says what the motors really did.
#include "runtime/lesson/first_use.h"

#include "haptics/device/arm/simulated_wam.h"
#include "tests/support/pushed_arm.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

const char* words_for(const Vector3& force_N) {
    int axis = 0;
    (void)force_N.cwiseAbs().maxCoeff(&axis);
    constexpr const char* kForth[] = {"It goes right.", "UP", "to me"};
    constexpr const char* kBack[] = {"left", "It pushes down!", "away from me"};
    return force_N(axis) > 0.0 ? kForth[axis] : kBack[axis];
}

// What the child feels since the last answer: the strongest of each of the newest two pushes.
struct Child {
    void feel(const Vector3& force_N) {
        constexpr double kFelt_N = 0.05;
        const bool feels = force_N.norm() > kFelt_N;
        if (feels && !felt_before) {
            first = std::exchange(second, Vector3(Vector3::Zero()));
        }
        felt_before = feels;
        second = force_N.norm() > second.norm() ? force_N : second;
    }
    [[nodiscard]] std::string answer(FirstUseQuestion question) const {
        return question == FirstUseQuestion::way ? words_for(second)
               : first.norm() > second.norm()    ? "the first"
                                                 : "The second push.";
    }
    Vector3 first{Vector3::Zero()};
    Vector3 second{Vector3::Zero()};
    bool felt_before = false;
};

using Speaks = std::function<std::string(FirstUseQuestion, const Child&)>;

std::string truly(FirstUseQuestion question, const Child& child) {
    return child.answer(question);
}

FirstUse play(auto&& bench, bool asks, const Speaks& speaks = truly,
              const TriedDevice& tried = {}) {
    FirstUse trial(asks, tried);
    Child child;
    for (int i = 0; trial.end() == FirstUseEnd::running && i < 20'000; ++i) {
        bench.frame(trial.step(bench.loop->state(), bench.now_s));
        child.feel(bench.arm->written_N);
        if (trial.question() != FirstUseQuestion::none) {
            (void)trial.answer(speaks(trial.question(), child));
        }
    }
    return trial;
}

Matrix3 mirror_x() {
    return Vector3(-1.0, 1.0, 1.0).asDiagonal();
}

}  // namespace

TEST_CASE("first use: a good arm is found good, watched or asked about, below 1 N and softly") {
    for (const bool asks : {false, true}) {
        PushedArm bench;
        const FirstUse trial = play(bench, asks);
        CHECK(trial.end() == FirstUseEnd::good);
        CHECK(tell(trial, {}).empty());
        CHECK(bench.arm->largest_N > 0.7);
        CHECK(bench.arm->largest_N <= 1.0);
        CHECK(bench.arm->largest_step_N <= 0.05);
    }
}

TEST_CASE("first use: reversed and exchanged motors end it, whatever the child says") {
    const FirstUse against = play(PushedArm(mirror_x()), true);
    CHECK(against.end() == FirstUseEnd::against);
    CHECK(against.axis() == 0);
    check_says(tell(against, {}), {"left and right"});
    Matrix3 wiring = Matrix3::Zero();
    wiring(0, 0) = wiring(1, 2) = wiring(2, 1) = 1.0;
    CHECK(play(PushedArm(wiring), false).end() == FirstUseEnd::aside);
    CHECK(play(PushedArm(Matrix3::Zero()), false).end() == FirstUseEnd::unfelt);
}

TEST_CASE("first use: what friction takes up is pushed again, stronger, never taken for good") {
    SimulatedArmSettings heavy = arm_held_by(kPosture);
    heavy.dry_friction_N = 2.0;
    for (const bool asks : {false, true}) {
        PushedArm good(Matrix3::Identity(), heavy);
        CHECK(play(good, asks).end() == FirstUseEnd::good);
        CHECK(good.arm->largest_N > 2.5);
        CHECK(good.arm->largest_N <= kMostPush_N);
        CHECK(good.arm->largest_step_N <= 0.15);
        CHECK(play(PushedArm(mirror_x(), heavy), asks).end() == FirstUseEnd::against);
    }
    // A real one, which gives way aside of the push where its joints' friction lets it.
    const PushedArm::MakeArm make_wam = [](LatestValue<HandTarget>& target) {
        return std::unique_ptr<Device>(std::move(*SimulatedWam::create({}, target)));
    };
    CHECK(play(PushedArm(Matrix3::Identity(), make_wam), false).end() == FirstUseEnd::good);
    for (const char* words : {"-x,y,z", "x,-y,z", "x,y,-z"}) {
        CHECK(play(PushedArm(AxisOrder::read(words)->matrix(), make_wam), false).end() ==
              FirstUseEnd::against);
    }
    for (const char* words : {"y,x,z", "x,z,y", "z,y,x"}) {
        const FirstUseEnd end =
            play(PushedArm(AxisOrder::read(words)->matrix(), make_wam), false).end();
        CHECK((end == FirstUseEnd::aside || end == FirstUseEnd::against));
    }
    // Nobody saw it move, so nobody knows.
    heavy.dry_friction_N = 4.0;
    for (const Matrix3& wiring : {Matrix3(Matrix3::Identity()), mirror_x()}) {
        const FirstUse trial = play(PushedArm(wiring, heavy), false);
        CHECK(trial.end() == FirstUseEnd::unfelt);
        CHECK(tell(trial, {}).starts_with("the arm gives no force in this lesson: "));
    }
    // One axis of three is enough to know nothing.
    const FirstUse trial = play(PushedArm(Vector3(1.0, 1.0, 0.0).asDiagonal()), false);
    CHECK(trial.end() == FirstUseEnd::unfelt);
    check_says(tell(trial, {}), {"near and away"});
}

TEST_CASE("first use: an arm that stands otherwise than it says is told, with axes that mend it") {
    for (const char* words : {"-x,y,z", "z,y,-x", "-x,y,-z", "y,x,z", "-z,-x,y"}) {
        CAPTURE(words);
        const AxisOrder axes = *AxisOrder::read(words);
        const FirstUse trial =
            play(PushedArm(Matrix3::Identity(), arm_held_by(kPosture), {.axes = axes}), true);
        REQUIRE(trial.end() == FirstUseEnd::turned);
        // Set as it was set the child's frame is the arm's own.
        check_says(tell(trial, axes), {"--axes x,y,z."});
        // Nobody who only watches can know.
        CHECK(play(PushedArm(Matrix3::Identity(), arm_held_by(kPosture), {.axes = axes}), false)
                  .end() == FirstUseEnd::good);
    }
}

TEST_CASE("first use: who feels nothing twice gets no force; once is asked again") {
    const Speaks honest = [](FirstUseQuestion question, const Child& child) {
        return child.second.norm() < 0.05 ? "I feel nothing" : child.answer(question);
    };
    // Its motors give nothing, whatever is commanded.
    const FirstUse unfelt = play(PushedArm(Matrix3::Zero()), true,
                                 [](FirstUseQuestion, const Child&) { return "I feel nothing"; });
    CHECK(unfelt.end() == FirstUseEnd::unfelt);
    CHECK(unfelt.axis() == 0);
    check_says(tell(unfelt, {}), {"were not felt, left and right"});
    PushedArm good;
    const FirstUse numb =
        play(good, true, [](FirstUseQuestion, const Child&) { return "nothing"; });
    CHECK(numb.end() == FirstUseEnd::unfelt);
    int asked = 0;
    const Speaks once = [&](FirstUseQuestion question, const Child& child) {
        return ++asked == 3 ? "I feel nothing" : honest(question, child);
    };
    CHECK(play(PushedArm(), true, once).end() == FirstUseEnd::good);
    CHECK(asked == 9);
    // Two pushes that are always the same are not told apart.
    PushedArm same;
    const Speaks alike = [](FirstUseQuestion question, const Child& child) {
        return question == FirstUseQuestion::stronger ? "They are the same."
                                                      : child.answer(question);
    };
    CHECK(play(same, true, alike).end() == FirstUseEnd::unsure);
}

TEST_CASE("first use: one wrong answer is asked once more, always the same answer fits nothing") {
    int asked = 0;
    const Speaks once_wrong = [&](FirstUseQuestion question, const Child& child) {
        ++asked;
        return asked == 2 ? "left" : asked == 3 ? "what?" : child.answer(question);
    };
    CHECK(play(PushedArm(), true, once_wrong).end() == FirstUseEnd::good);
    CHECK(asked == 10);  // six ways, one of them again, once not understood, twice the stronger one
    PushedArm same;
    const FirstUse bored = play(same, true, [](FirstUseQuestion, const Child&) { return "left"; });
    CHECK(bored.end() == FirstUseEnd::unsure);
    CHECK(tell(bored, {}).ends_with('.'));
    // Right ways, and the same of any two pushes.
    PushedArm first;
    const Speaks always_first = [](FirstUseQuestion question, const Child& child) {
        return question == FirstUseQuestion::stronger ? "first" : child.answer(question);
    };
    CHECK(play(first, true, always_first).end() == FirstUseEnd::unsure);
}

TEST_CASE("first use: while a question is open there is no force, and no other answer counts") {
    PushedArm bench;
    FirstUse trial(true);
    CHECK_FALSE(trial.answer("left"));
    while (trial.question() == FirstUseQuestion::none) {
        bench.frame(trial.step(bench.loop->state(), bench.now_s));
        REQUIRE(bench.now_s < 20.0);
    }
    for (int i = 0; i < 200; ++i) {
        const Vector3 force_W = trial.step(bench.loop->state(), bench.now_s);
        CHECK(force_W.isZero());
        bench.frame(force_W);
    }
    CHECK(bench.arm->written_N.norm() < 1e-9);
    CHECK_FALSE(trial.answer("banana"));
    CHECK(trial.question() == FirstUseQuestion::way);
}

TEST_CASE("first use: a stop, or an arm that nobody holds, leaves it untried") {
    PushedArm stopped;
    stopped.arm->told = Fault::emergency_stop;
    CHECK(play(stopped, false).end() == FirstUseEnd::disturbed);
    const FirstUse trial =
        play(PushedArm(Matrix3::Identity(), arm_held_by({0.1, 1.0, 1.0})), false);
    CHECK(trial.end() == FirstUseEnd::disturbed);
    check_says(tell(trial, {}), {"hold it loosely"});
}

TEST_CASE("first use: a joystick is tried along the axes that it has, up being away") {
    const TriedDevice stick{.is_stick = true, .pushes = {true, true, false}};
    const Matrix3 motors = Vector3(1.0, 1.0, 0.0).asDiagonal();
    int asked = 0;
    const Speaks on_a_table = [&](FirstUseQuestion question, const Child& child) {
        ++asked;
        const std::string said = child.answer(question);
        return said == "UP" ? "away" : said == "It pushes down!" ? "to me" : said;
    };
    PushedArm good(motors);
    CHECK(play(good, true, on_a_table, stick).end() == FirstUseEnd::good);
    CHECK(asked == 6);  // four ways, twice the stronger one
    CHECK(play(PushedArm(motors), true, truly, stick).end() == FirstUseEnd::good);
    CHECK(play(PushedArm(motors), false, truly, stick).end() == FirstUseEnd::good);
    // An arm that has lost an axis is none.
    CHECK(play(PushedArm(motors), false).end() == FirstUseEnd::unfelt);
    // The wrong way, either axis.
    for (const Vector3& wrong : {Vector3(-1.0, 1.0, 0.0), Vector3(1.0, -1.0, 0.0)}) {
        const FirstUse trial = play(PushedArm(wrong.asDiagonal()), false, truly, stick);
        CHECK(trial.end() == FirstUseEnd::against);
        CHECK(tell(trial, {}).starts_with(
            "the stick gives no force in this lesson: the hand goes against its push"));
    }
    CHECK(play(PushedArm(Matrix3::Zero()), false, truly, stick).end() == FirstUseEnd::unfelt);
    // One with a motor along x alone is compared there.
    CHECK(play(PushedArm(Vector3(1.0, 0.0, 0.0).asDiagonal()), true, truly,
               {.is_stick = true, .pushes = {true, false, false}})
              .end() == FirstUseEnd::good);
    CHECK(FirstUse(true, {.is_stick = true, .pushes = {false, false, false}}).end() ==
          FirstUseEnd::unfelt);
}

TEST_CASE("first use: a joystick that stands turned is told, with the axes that mend it") {
    const TriedDevice stick{.is_stick = true, .pushes = {true, true, false}};
    const AxisOrder axes = *AxisOrder::read("-x,y,z");
    const FirstUse trial =
        play(PushedArm(Vector3(1.0, 1.0, 0.0).asDiagonal(), arm_held_by(kPosture), {.axes = axes}),
             true, truly, stick);
    REQUIRE(trial.end() == FirstUseEnd::turned);
    check_says(tell(trial, {}), {"--axes -x,y,z."});
    const FirstUse exchanged =
        play(PushedArm(Vector3(1.0, 1.0, 0.0).asDiagonal(), arm_held_by(kPosture),
                       {.axes = *AxisOrder::read("y,x,z")}),
             true, truly, stick);
    REQUIRE(exchanged.end() == FirstUseEnd::turned);
    check_says(tell(exchanged, {}), {"--axes y,x,z."});
}
