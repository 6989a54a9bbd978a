// How smooth a peg is felt that goes into a hole a thousandth wider, is turned and comes out: against how fast the hand is.
#include "tests/bench/harness/curve.h"
#include "tests/support/peg_trial.h"

namespace fulcrum::bench {
namespace {

Report run_peg_in_hole(Run& run) {
    Sheet sheet{
        "peg-in-hole",
        "A peg in a hole, as it is felt",
        "A peg of 288 triangles, 2 cm thick, onto the rim of a hole of 280 triangles, 0.1 % wider, "
        "over it, in, turned by 1.5 rad while the hand trembles, and out; by the simulated hand of "
        "1 kg on 300 N/m in closed loop at 1 kHz. The course takes 3.7 s at speed 1. A step of the "
        "force is that of one tick, of the largest force",
        "2 % of the force a tick up to twice that speed; a faster hand feels what its own way "
        "changes of the coupling.",
        {"speed", "hand, mm/s", "force, N", "step of it, %", "torque, mN m", "step of it, %",
         "steps crossing", "steps that go on, %"}};
    const std::vector<double> speeds =
        run.pick<std::vector<double>>({0.25, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0}, {1.0, 4.0});
    for (const double speed : speeds) {
        run.progress(sheet.rows.size(), speeds.size(), "speed " + to_text(speed));
        test::PegTrial trial;
        const test::PegTrial::Found found = trial.run(speed, true);
        sheet.add({speed, rounded(1.0e3 * found.fastest_m_per_s, 0), rounded(found.most_N, 2),
                   rounded(100.0 * found.share(), 2), rounded(1.0e3 * found.most_Nm, 1),
                   rounded(100.0 * found.most_step_Nm / found.most_Nm, 1), found.n_crossing,
                   rounded(100.0 * found.n_unsettled / found.n_steps, 1)});
    }
    return {sheet};
}

const Registration kPegInHole{
    {"peg-in-hole", "how smooth a peg is felt in a hole a thousandth wider", run_peg_in_hole}};

}  // namespace
}  // namespace fulcrum::bench
