// How smooth a peg is felt that goes into a hole a thousandth wider, is turned and comes out: against how fast the hand is.
#include "tests/bench/harness/csv.h"
#include "tests/bench/harness/registry.h"
#include "tests/support/peg_trial.h"

#include <cmath>
#include <string>
#include <vector>

namespace fulcrum::bench {
namespace {

std::string rounded(double value, double unit) {
    return to_text(std::round(value / unit) * unit);
}

Report run_peg_in_hole(Run& run) {
    Sheet sheet;
    sheet.name = "peg-in-hole";
    sheet.title = "A peg in a hole, as it is felt";
    sheet.work =
        "A peg of 288 triangles, 2 cm thick, onto the rim of a hole of 280 triangles, 0.1 % wider, "
        "over it, in, turned by 1.5 rad while the hand trembles, and out; by the simulated hand of "
        "1 kg on 300 N/m in closed loop at 1 kHz. The course takes 3.7 s at speed 1. A step of the "
        "force is that of one tick, of the largest force";
    sheet.advice =
        "2 % of the force a tick up to twice that speed; a faster hand feels what its own "
        "way changes of the coupling.";
    sheet.columns = {"speed",        "hand, mm/s",    "force, N",       "step of it, %",
                     "torque, mN m", "step of it, %", "steps crossing", "steps that go on, %"};
    const std::vector<double> speeds =
        run.pick<std::vector<double>>({0.25, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0}, {1.0, 4.0});
    for (const double speed : speeds) {
        run.progress(static_cast<double>(sheet.rows.size()) / static_cast<double>(speeds.size()),
                     "speed " + to_text(speed));
        test::PegTrial trial;
        const test::PegTrial::Found found = trial.run(speed, true);
        sheet.rows.push_back({to_text(speed), rounded(1.0e3 * found.fastest_m_per_s, 1.0),
                              rounded(found.most_N, 0.01), rounded(100.0 * found.share(), 0.01),
                              rounded(1.0e3 * found.most_Nm, 0.1),
                              rounded(100.0 * found.most_step_Nm / found.most_Nm, 0.1),
                              std::to_string(found.n_crossing),
                              rounded(100.0 * found.n_unsettled / found.n_steps, 0.1)});
    }
    return {sheet};
}

const Registration kPegInHole{
    {"peg-in-hole", "how smooth a peg is felt in a hole a thousandth wider", run_peg_in_hole}};

}  // namespace
}  // namespace fulcrum::bench
