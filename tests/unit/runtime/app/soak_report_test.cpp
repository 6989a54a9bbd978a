#include "runtime/app/soak_report.h"

#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

// In which each kind has happened, and each that must has faded.
SoakRun make_whole() {
    SoakRun run;
    run.arm.deeds.fill(1);
    run.arm.turned_rounds = 5;
    run.n_deadlines = 12;
    for (std::size_t i = 1; i < kSpoils; ++i) {
        run.arm.happened[i] = 2;
        run.arm.faded[i] = must_fade(static_cast<Spoil>(i)) ? 1 : 0;
    }
    for (std::size_t i = 1; i < kRunSpoils; ++i) {
        run.around[i] = 3;
        run.around_faded[i] = must_fade(static_cast<RunSpoil>(i)) ? 1 : 0;
    }
    return run;
}

SoakSum sum_of(const SoakRun& run) {
    SoakSum sum;
    sum.add(run);
    return sum;
}

}  // namespace

TEST_CASE("soak report: whole is what has each kind, each fade and each deed of the hand") {
    CHECK(sum_of(make_whole()).has_all());
    CHECK(conclude_soak(sum_of(make_whole()), true, {}) == 0);
    CHECK_FALSE(SoakSum{}.has_all());
    for (std::size_t i = 1; i < kSpoils; ++i) {
        SoakRun run = make_whole();
        run.arm.happened[i] = 0;
        CHECK(sum_of(run).lacks(static_cast<Spoil>(i)));
        CHECK_FALSE(sum_of(run).has_all());
        run = make_whole();
        run.arm.faded[i] = 0;
        CHECK(sum_of(run).has_all() == !must_fade(static_cast<Spoil>(i)));
    }
    for (std::size_t i = 1; i < kRunSpoils; ++i) {
        SoakRun run = make_whole();
        run.around[i] = 0;
        CHECK(sum_of(run).lacks(static_cast<RunSpoil>(i)));
        run = make_whole();
        run.around_faded[i] = 0;
        CHECK(sum_of(run).has_all() == !must_fade(static_cast<RunSpoil>(i)));
    }
    for (std::size_t i = 0; i < kHandDeeds; ++i) {
        SoakRun run = make_whole();
        run.arm.deeds[i] = 0;
        CHECK_FALSE(sum_of(run).has_all());
        CHECK(conclude_soak(sum_of(run), true, {}) == 1);
        CHECK(conclude_soak(sum_of(run), false, {}) == 0);  // one run that is looked at again
    }
}

TEST_CASE("soak report: a soak in which no torque was felt says nothing of torques") {
    SoakRun run = make_whole();
    run.arm.turned_rounds = 0;
    CHECK_FALSE(sum_of(run).has_all());
    CHECK(conclude_soak(sum_of(run), true, {}) == 1);
}

TEST_CASE("soak report: trouble, and memory that grows, fail it") {
    SoakRun run = make_whole();
    run.trouble = "late: a frame of the lesson";
    CHECK(conclude_soak(sum_of(run), true, {}) == 1);
    CHECK(conclude_soak(sum_of(make_whole()), true, {2.0, 0.0}) == 1);
    CHECK(conclude_soak(sum_of(make_whole()), true, {0.0, 100.0}) == 1);
    CHECK(conclude_soak(sum_of(make_whole()), true, {0.5, 20.0}) == 0);
}

TEST_CASE("soak report: how fast it was is told by the clock and by what the processor did") {
    SoakRun run = make_whole();
    run.simulated_s = 600.0;
    run.wall_s = 12.0;
    run.processor_s = 5.0;
    SoakSum sum = sum_of(run);
    sum.add(run);
    const std::string text = describe_soak(sum, {});
    INFO(text);
    CHECK(text.find("In all 1200 s, 50 times real time, 120 times its processor time, with") == 0);
}

TEST_CASE("soak report: each kind is told with how often it broke and how often it faded") {
    const std::string text = describe_soak(sum_of(make_whole()), {0.1, 2.0});
    INFO(text);
    check_says(text,
               {"Broke: packets lost 2, a long way 2", ", disk full 3.",
                "Faded: cable pulled 1, no pose 1, no number 1, a stuck sensor 1, motor refuses "
                "1, stop at the arm 1, world stands 1, lesson hangs 1, lesson killed 1.",
                "The hand: follows 1, presses 1, slides 1, jerks 1, lets go 1.",
                "Deadlines under the virtual clock: 12 met."});
}
