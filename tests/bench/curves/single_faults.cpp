// Every single fault of the fault tree, and what the hand feels of it: peak force, steps, energy, how long until there is none.
#include "tests/bench/harness/curve.h"
#include "tests/support/fault_kinds.h"

namespace fulcrum::bench {
namespace {

Report run_single_faults(Run& run) {
    Sheet sheet{
        "single-faults",
        "What the hand feels of every single fault",
        "A hand that moves about presses into a surface and is pulled by a lesson's spring, "
        "through haptic loop, link, arm's server and a simulated arm at 1 kHz under one clock; "
        "then one thing breaks and stays broken for a second.",
        "Nothing is to be chosen here: no peak may exceed the force before by more than the arm's "
        "limit allows, and what does not say \"stays\" has to be gone.",
        {"fault", "noticed first by", "after, ms", "force before, N", "peak after, N",
         "largest step, N", "energy given, mJ", "gone after, ms", "at the end, N"}};
    const auto kinds = test_link::all_faults();
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        run.progress(i, kinds.size(), kinds[i].name);
        const test_link::FaultCourse c = test_link::run_fault(kinds[i]);
        sheet.add({kinds[i].name, name_of(c.who),
                   c.who == test_link::Notices::nobody ? "-" : to_text(1e3 * c.notice_s),
                   c.before_N, c.peak_N, c.largest_step_N, 1e3 * c.given_J,
                   std::isfinite(c.gone_s) ? to_text(1e3 * c.gone_s) : "stays", c.end_N});
    }
    return {sheet};
}

const Registration kSingleFaults{{"single-faults",
                                  "what the hand feels of every single fault of the fault tree",
                                  run_single_faults}};

}  // namespace
}  // namespace fulcrum::bench
