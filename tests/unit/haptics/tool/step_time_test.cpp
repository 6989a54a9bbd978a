#include "haptics/tool/step_time.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace fulcrum;

TEST_CASE(
    "step time: looks are sixths at most, shared among what is near, and never more than is left") {
    StepTime time(120.0, BudgetClock::counted);
    time.begin();
    CHECK(time.find_look_us(1) == 20.0);
    CHECK(time.find_look_us(4) == 5.0);
    time.count(0, 110.0);
    CHECK(time.find_look_us(1) == Approx(10.0));
    time.count(0, 50.0);
    CHECK(time.left_us() == 0.0);
    CHECK(time.find_look_us(1) == 0.0);
    // The next step has all of it; one look alone likewise.
    time.begin(1);
    CHECK(time.left_us() == 120.0);
    CHECK(time.find_look_us(1) == 120.0);
}

TEST_CASE("step time: there is time while two looks as dear as the dearest are left") {
    StepTime time(100.0, BudgetClock::counted);
    time.begin();
    CHECK(time.has_time());
    const auto look = [&](double cost_us) {
        time.begin_look();
        time.count(32, cost_us);
        time.end_look();
    };
    look(30.0);
    CHECK(time.has_time());
    look(10.0);
    CHECK(time.has_time());  // 60 are left
    look(1.0);
    CHECK_FALSE(time.has_time());
    CHECK(time.has_time_for(1.0));
    look(30.0);
    CHECK_FALSE(time.has_time_for(1.0));
    CHECK(time.n_looks() == 4);
    CHECK(time.n_points() == 4 * 32);
    time.begin();
    CHECK(time.has_time());
    CHECK(time.n_looks() == 0);
    CHECK(time.n_points() == 0);
}

TEST_CASE("step time: without a budget there is always time, on the machine's clock it passes") {
    StepTime endless;
    endless.begin();
    endless.begin_look();
    endless.count(7, 1.0e9);
    endless.end_look();
    CHECK_FALSE(endless.has_end());
    CHECK(endless.has_time());
    CHECK(std::isinf(endless.left_us()));
    CHECK(endless.n_points() == 7);
    StepTime time(1.0);
    time.begin();
    time.begin_look();
    const double began_s = monotonic_now_s();
    while (monotonic_now_s() - began_s < 2.0e-6) {
    }
    time.end_look();
    CHECK(time.elapsed_us() >= 2.0);
    CHECK(time.left_us() == 0.0);
    CHECK_FALSE(time.has_time());
}
