#include "runtime/app/run_spoiler.h"

#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

// A minute of ticks, with this force whenever.
RunSpoiler run_spoiler(std::uint64_t seed, double force_N, bool has_world, double& clock_s) {
    RunSpoiler spoiler(seed, 60.0);
    spoiler.begin(has_world);
    for (clock_s = 0.0; clock_s < 60.0; clock_s += 0.001) {
        clock_s += spoiler.step(clock_s, force_N);
        (void)spoiler.world_runs(clock_s);
        (void)spoiler.lesson_runs(clock_s);
        (void)spoiler.kills_lesson(clock_s);
    }
    return spoiler;
}

}  // namespace

TEST_CASE("run spoiler: in a few runs each kind has happened, and one seed makes one run") {
    std::array<std::uint64_t, kRunSpoils> all{};
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        double end_s = 0.0;
        double again_s = 0.0;
        const RunSpoiler spoiler = run_spoiler(seed, 0.0, true, end_s);
        CHECK(run_spoiler(seed, 0.0, true, again_s).happened() == spoiler.happened());
        CHECK(end_s == again_s);
        CHECK(spoiler.missed_fades() == 0);
        for (std::size_t i = 0; i < kRunSpoils; ++i) {
            all[i] += spoiler.happened()[i];
        }
    }
    for (std::size_t i = 1; i < kRunSpoils; ++i) {
        INFO(name_of(static_cast<RunSpoil>(i)));
        CHECK(all[i] >= 2);
    }
}

TEST_CASE("run spoiler: what breaks first is known before") {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        RunSpoiler spoiler(seed, 60.0);
        const RunSpoil first = spoiler.first();
        const double at_s = spoiler.first_at_s();
        spoiler.begin(true);
        (void)spoiler.step(at_s - 0.01, 0.0);
        CHECK(spoiler.happened()[static_cast<std::size_t>(first)] == 0);
        (void)spoiler.step(at_s, 0.0);
        CHECK(spoiler.happened()[static_cast<std::size_t>(first)] == 1);
    }
}

TEST_CASE("run spoiler: a force that stays where nobody speaks is told, with when and in what") {
    double end_s = 0.0;
    std::uint64_t with_world = 0;
    std::uint64_t without = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const RunSpoiler spoiler = run_spoiler(seed, 1.0, true, end_s);
        with_world += spoiler.missed_fades();
        if (spoiler.missed_fades() > 0) {
            CHECK(spoiler.bad_since_s() > RunSpoiler::kMostQuiet_s);
            CHECK((spoiler.bad_in() == RunSpoil::world_stands ||
                   spoiler.bad_in() == RunSpoil::lesson_hangs));
        }
        without += run_spoiler(seed, 1.0, false, end_s).missed_fades();
    }
    CHECK(without > 0);
    CHECK(with_world > without);
}

TEST_CASE("run spoiler: a force that was felt and goes in time is a fade of its kind") {
    std::array<std::uint64_t, kRunSpoils> all{};
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        RunSpoiler spoiler(seed, 60.0);
        spoiler.begin(true);
        double quiet_s = 0.0;
        for (double now_s = 0.0; now_s < 60.0; now_s += 0.001) {
            // There while all is well, and gone a tenth of a second after it is not.
            quiet_s = spoiler.quiet_s(now_s) > 0.0 ? 0.0 : quiet_s + 0.001;
            (void)spoiler.step(now_s, quiet_s < 0.1 ? 1.0 : 0.0);
            (void)spoiler.kills_lesson(now_s);
        }
        CHECK(spoiler.missed_fades() == 0);
        spoiler.end(0.0);
        for (std::size_t i = 0; i < kRunSpoils; ++i) {
            all[i] += spoiler.faded()[i];
        }
        // Nothing that must not go is counted, and where a force is left nothing is.
        RunSpoiler left(seed, 1.0);
        (void)left.step(0.9, 1.0);
        (void)left.kills_lesson(0.999);
        left.end(1.0);
        CHECK(left.faded()[static_cast<std::size_t>(RunSpoil::lesson_killed)] == 0);
    }
    for (std::size_t i = 0; i < kRunSpoils; ++i) {
        INFO(name_of(static_cast<RunSpoil>(i)));
        CHECK((all[i] > 0) == must_fade(static_cast<RunSpoil>(i)));
    }
}

TEST_CASE("run spoiler: what is starved or slow runs now and then, what stands not at all") {
    RunSpoiler spoiler(3, 60.0);
    spoiler.begin(true);
    int n_world = 0;
    int n_lesson = 0;
    int n_ticks = 0;
    for (double now_s = 0.0; now_s < 60.0; now_s += 0.001) {
        now_s += spoiler.step(now_s, 0.0);
        n_world += spoiler.world_runs(now_s) ? 1 : 0;
        n_lesson += spoiler.lesson_runs(now_s) ? 1 : 0;
        ++n_ticks;
    }
    CHECK(n_world < n_ticks);
    CHECK(n_world > n_ticks / 2);
    CHECK(n_lesson < n_ticks);
    CHECK(n_lesson > n_ticks / 2);
}
