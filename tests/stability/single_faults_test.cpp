// Every single fault of the fault tree, in the closed loop: what the hand feels is bounded, and where it must, the force is gone in time.
#include "tests/support/fault_trial.h"

#include <catch2/catch.hpp>

using namespace fulcrum;
using namespace fulcrum::test_link;

namespace {

constexpr double kNotice_s = 0.1;  // the longest until somebody notices: a lesson that hangs
constexpr double kFade_s = 0.1;
constexpr double kMargin_s = 0.03;  // rounds of both sides, and a packet under way

}  // namespace

TEST_CASE("single faults: the force that was held is there before, or nothing would be shown") {
    const FaultKind nothing{"nothing", "nobody", false, [](FaultBench&) {}};
    const FaultCourse course = run_fault(nothing);
    CHECK(course.before_N > 2.8);
    CHECK(course.end_N == Approx(course.before_N).epsilon(1e-3));
    CHECK(course.given_J < 1e-4);
}

TEST_CASE(
    "single faults: each is noticed, no force grows by it, and the force is gone in time or goes "
    "on") {
    for (const FaultKind& kind : all_faults()) {
        const FaultCourse course = run_fault(kind);
        INFO(kind.name << ": before " << course.before_N << " N, then at most " << course.peak_N
                       << " N, steps of " << course.largest_step_N << " N, " << course.given_J
                       << " J, gone after " << course.gone_s << " s, at the end " << course.end_N
                       << " N");
        // The limits hold whatever happens; a step is what the slew allows in two rounds.
        CHECK(course.peak_N <= 5.0);
        CHECK((kind.drops || course.largest_step_N <= 1.01));
        CHECK(course.given_J < 0.25);
        if (kind.fades) {
            CHECK(course.peak_N <= course.before_N + 0.2);
            CHECK(course.gone_s <= kNotice_s + kFade_s + kMargin_s);
            CHECK(course.end_N == 0.0);
        } else {
            CHECK(course.end_N > 0.8 * course.before_N);
        }
    }
}
