// How much of a tap arrives behind the last gate, over the slew of what lasts; and which materials are told by what arrives.
#include "tests/bench/harness/curve.h"
#include "tests/support/tap_trial.h"

namespace fulcrum::bench {
namespace {

// The least share of a tap's energy that arrives, of those that ask for no more than the limit.
double find_least_share(const std::vector<test::TapTrial>& trials, double slew_N_per_s,
                        bool has_transients) {
    double least = 1.0;
    for (const test::TapTrial& trial : trials) {
        const test::TapForces forces = tap(trial, [&](SafetySettings& safety) {
            safety.max_slew_N_per_s = slew_N_per_s;
            safety.max_transient_N = has_transients ? safety.max_transient_N : 0.0;
        });
        least = forces.clips ? least : std::min(least, test::find_share_sent(forces));
    }
    return least;
}

LineChart draw_fidelity(Run& run) {
    LineChart chart;
    chart.name = "tap-fidelity";
    chart.title = "How much of a tap arrives, over the slew of what lasts";
    chart.work =
        "Four hands tap a block at 0.05 to 0.4 m/s and up to 0.5 rad off its normal, with the plan "
        "of a lesson; the share of the squares between 20 and 400 Hz that is sent, of what is "
        "asked for, in 80 ms from the touch on: the least of all taps that ask for no more than "
        "the limit of force.";
    chart.reference = "the same gate without transients: the slew alone";
    chart.advice = "As it ships, 500 N/s: below that transients become as much smaller.";
    chart.x = {"slew", "N/s", true};
    chart.y = {"least share that arrives", "", false};
    const std::vector<double> slews_N_per_s =
        run.pick<std::vector<double>>({50, 100, 200, 300, 500, 1000, 2000, 5000}, {100, 500});
    std::size_t done = 0;
    for (const char* material : test::kTapped) {
        std::vector<test::TapTrial> trials = test::unknown_taps(material);
        trials.resize(run.pick(trials.size(), std::size_t{8}));
        for (const bool has_transients : {true, false}) {
            const std::string name = material + std::string(has_transients ? "" : ", slew alone");
            run.progress(done++, 2 * test::kTapped.size(), name);
            chart.trace(name, has_transients ? LineStyle::measured : LineStyle::theory,
                        slews_N_per_s, [&](double slew_N_per_s) {
                            return find_least_share(trials, slew_N_per_s, has_transients);
                        });
        }
    }
    return chart;
}

Sheet list_told() {
    Sheet sheet{"tap-materials",
                "What was tapped, told by the nearest of known taps",
                "From what was sent and where the hand was. The judge has learnt eight taps of "
                "each material by one hand of 1 kg at 0.1 m/s, "
                "straight on; it is asked about four other hands at seven other speeds and five "
                "angles. Taps that ask for more than the limit of force are cut by it, and stand "
                "apart.",
                "Nothing is to be chosen here.",
                {"tapped", "taps", "told", "of those that are cut", "told"}};
    const test::TapJudge judge = test::make_taught_judge();
    for (const char* material : test::kTapped) {
        std::array<int, 2> all{};
        std::array<int, 2> told{};
        for (const test::TapTrial& trial : test::unknown_taps(material)) {
            const test::TapForces forces = tap(trial);
            ++all[forces.clips ? 1 : 0];
            told[forces.clips ? 1 : 0] += judge.tell(forces) == material ? 1 : 0;
        }
        sheet.add({material, all[0], told[0], all[1], told[1]});
    }
    return sheet;
}

Report run_tap_fidelity(Run& run) {
    return {draw_fidelity(run), list_told()};
}

const Registration kTapFidelity{
    {"tap-fidelity", "how much of a tap arrives behind the last gate, and what is told by it",
     run_tap_fidelity}};

}  // namespace
}  // namespace fulcrum::bench
