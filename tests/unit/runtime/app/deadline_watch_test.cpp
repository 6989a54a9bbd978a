#include "runtime/app/deadline_watch.h"

#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

constexpr double kDt_s = 0.001;
constexpr DeadlinePeriods kPeriods{kDt_s, 0.005, 0.0, 1.0 / 60.0};

DeadlineWatch make_watch() {
    DeadlineWatch watch;
    watch.begin(kPeriods);
    return watch;
}

}  // namespace

TEST_CASE("deadlines: what comes in its time is met, and counted") {
    DeadlineWatch watch = make_watch();
    long frame = 0;
    for (int tick = 0; tick < 10000; ++tick) {
        const double now_s = kDt_s * tick;
        if (now_s * 60.0 >= static_cast<double>(frame) - 1e-9) {
            watch.passed(Deadline::frame, now_s, now_s);
            ++frame;
        }
        watch.hands_stepped(now_s, 0.0, {}, now_s);
        if (tick % 5 == 0) {
            watch.passed(Deadline::world, now_s, now_s);
        }
    }
    CHECK(watch.n_broken() == 0);
    CHECK(watch.broken() == Deadline::none);
    CHECK(watch.n_met(Deadline::hands) == 9999);
    CHECK(watch.n_met(Deadline::world) >= 1990);
    CHECK(watch.n_met(Deadline::frame) >= 590);
    CHECK(watch.n_met(Deadline::command) == 8500);
    CHECK(watch.n_met(Deadline::kite) == 0);
}

TEST_CASE("deadlines: a round that is left out is told, a clock that jumped is not") {
    DeadlineWatch watch = make_watch();
    watch.hands_stepped(1.000, 0.0, {}, 0.0);
    watch.hands_stepped(1.001, 0.0, {}, 0.0);
    watch.hands_stepped(1.502, 0.5, {}, 0.0);
    CHECK(watch.n_broken() == 0);
    watch.hands_stepped(1.504, 0.0, {}, 0.0);
    CHECK(watch.n_broken() == 1);
    CHECK(watch.broken() == Deadline::hands);
    CHECK(watch.broken_at_s() == 1.504);
}

TEST_CASE("deadlines: a world or a frame is late only while nobody keeps it back") {
    for (const Deadline what : {Deadline::world, Deadline::frame}) {
        DeadlineWatch watch = make_watch();
        watch.passed(what, 1.0, 1.0);
        watch.passed(what, 1.1, 0.0);  // kept back
        watch.passed(what, 1.2, 0.004);
        CHECK(watch.n_broken() == 0);
        watch.passed(what, 1.3, 0.1);
        CHECK(watch.n_broken() == 1);
        CHECK(watch.broken() == what);
    }
}

TEST_CASE("deadlines: who is told to be late with nothing broken is late") {
    for (const Fault fault : {Fault::device_read, Fault::device_stale, Fault::command_stale,
                              Fault::device_write, Fault::record_full}) {
        DeadlineWatch watch = make_watch();
        HapticState state;
        state.faults = fault | Fault::hand_too_fast;
        watch.hands_stepped(1.0, 0.0, state, 0.5 * DeadlineWatch::kSettle_s);
        CHECK(watch.n_broken() == 0);
        watch.hands_stepped(1.001, 0.0, state, DeadlineWatch::kSettle_s);
        CHECK(watch.n_broken() == 1);
        CHECK(watch.broken() == Deadline::command);
    }
    // What a hand or a person does breaks none.
    DeadlineWatch watch = make_watch();
    HapticState state;
    state.faults = Fault::hand_too_fast | Fault::emergency_stop | Fault::too_much_energy;
    watch.hands_stepped(1.0, 0.0, state, 5.0);
    CHECK(watch.n_broken() == 0);
}
