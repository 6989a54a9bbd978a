#include "runtime/app/soak_report.h"

#include <catch2/catch.hpp>

#include <string>

using namespace fulcrum;
using namespace fulcrum::runtime;

namespace {

SoakSum sum_of(const SoakRun& run) {
    SoakSum sum;
    sum.add("lever", run);
    return sum;
}

}  // namespace

TEST_CASE("soak: a lesson whose tool's steps are short of something is named, and fails") {
    FeltWatch watch;
    HapticState state;
    for (int i = 0; i < 120'000; ++i) {
        state.tool.lacks = {};
        state.tool.tell(ToolLack::unsettled, i < 2401);
        state.tool.tell(ToolLack::wedged, i < 2399);
        watch.hands_stepped(state, 0.0, true, false);
    }
    SoakRun run;
    run.felt = watch.rounds();
    const SoakSum sum = sum_of(run);
    CHECK(describe_soak(sum, {}).find("2401 steps of the tool were not settled") !=
          std::string::npos);
    CHECK(describe_soak(sum, {}).find("2399 steps of the tool were wedged") != std::string::npos);
    CHECK(sum.find_lacking().find("not settled") != std::string::npos);
    CHECK(conclude_soak(sum, false, {}) == 1);
    run.felt.lacking = {2400, 2399, 0, 0};
    run.felt.world = {.n_steps = 50'000, .n_unconverged = 1001};
    CHECK(describe_soak(sum_of(run), {}).find("1001 of 50000 steps of the world ended before") !=
          std::string::npos);
    CHECK(sum_of(run).find_lacking().find("of the world") != std::string::npos);
    run.felt.world.n_unconverged = 1000;
    CHECK(sum_of(run).find_lacking().empty());
    CHECK(conclude_soak(sum_of(run), false, {}) == 0);
}
