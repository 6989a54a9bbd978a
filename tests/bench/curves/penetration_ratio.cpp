// L14's table 2: the share of contact frames in which a point got past the layer that pushes, with and without brakes.
#include "tests/bench/harness/curve.h"
#include "tests/support/penetration_trial.h"

#include <cstdio>

namespace fulcrum::bench {
namespace {

struct Variant {
    const char* name;
    PreContactBraking braking;
    bool lead_clamped;
};
const std::array<Variant, 4> kVariants{
    {{"none", PreContactBraking::off, false},
     {"viscous", PreContactBraking::viscous, false},
     {"one cycle", PreContactBraking::one_cycle, false},
     {"one cycle, the hand's motion clamped", PreContactBraking::one_cycle, true}}};

std::string to_ratio(double ratio) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.1e", ratio);
    return text.data();
}

Report run_penetration_ratio(Run& run) {
    Sheet sheet{
        "penetration-ratio",
        "How often a fast tool gets past the layer that pushes",
        "A ring of 75 mm and 12 g swept by an arm against a plate and beams at 1 kHz, voxels of 5 "
        "mm, the pushing layer two voxels outside, at most 15 N felt, semi-implicit Euler. Ratio: "
        "frames with a point in an interior voxel over frames in contact. McNeely's own scene, "
        "hand and tool were others.",
        "Clamp the hand's motion with the springs near the object, as is the default: what passes "
        "is pulled through by the dampers. The one-cycle brakes adapt to speed and to the number "
        "of points.",
        {"hand at most m/s", "brakes", "penetrations", "contacts", "ratio", "passed"}};
    sheet.rows = {{"printed 1999", "none", "70", "69000", "1.0e-03", ""},
                  {"printed 1999", "with", "6", "108000", "5.6e-05", ""}};
    double done = 0.0;
    for (const double fastest_m_per_s : {1.0, 1.5, 2.0, 3.0}) {
        for (const Variant& variant : kVariants) {
            run.progress(done, variant.name);
            const test::PenetrationCount count =
                test::run_penetration_trial({variant.braking, variant.lead_clamped,
                                             run.pick(400'000, 40'000), fastest_m_per_s, 1});
            sheet.add({fastest_m_per_s, variant.name, count.n_penetrations, count.n_contacts,
                       to_ratio(count.ratio()), count.n_passed});
            done += 1.0 / 16.0;
        }
    }
    return {sheet};
}

const Registration kPenetrationRatio{
    {"penetration-ratio",
     "penetrations with and without pre-contact braking, as McNeely counted them",
     run_penetration_ratio}};

}  // namespace
}  // namespace fulcrum::bench
