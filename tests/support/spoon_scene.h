// The comparison of Otaduy & Lin 2005, figure 4, on a scene of planes: a spoon, held at its end by a coupling of 500 N/m, whose
// stem runs through the handle of a cup, at 1 kHz for 600 ms.
//
//   spoon   a strip of 140 x 12 x 3 mm, of even density; its corners at 5 mm on both sides of the middle, and its tip, touch
//   cup     a rectangular ring of 16 x 10 mm around the stem: four planes for eight corners; a wall before the tip
//   hand    0-120 ms 20 mm along the stem, free; 120-300 ms sideways and up against the ring, and turned; 300-450 ms still;
//           450-600 ms drawn along the ring, pressed
// Contacts are viscoelastic with a damping that belongs to the surfaces, so it is the same for every mass; the coupling is
// critically damped for the spoon's mass and about each of its axes, whose moments differ by 128. One damper for all, for the mean
// moment, decays about the stem at h b / I = 12 at 1 kHz and 100 g, where RK4 ends at 2.8: the paper's 100 g could not be
// had. The paper's own scene is two triangle meshes.
//
// Source: M. Otaduy, M. Lin 2005, Stable and responsive six-degree-of-freedom haptic manipulation using implicit
// integration, World Haptics, section 7 and figures 3 and 4.
#pragma once

#include "haptics/dynamics/integrator.h"

#include <string>
#include <vector>

namespace fulcrum::test {

struct SpoonSettings {
    Integrator integrator = Integrator::backward_euler;
    double mass_kg = 0.01;
    double contact_stiffness_N_per_m = 2000.0;
    double contact_damping_Ns_per_m = 8.0;
    double dt_s = 0.001;
    int newton_iterations = IntegratorSettings{}.newton_iterations;
};

/// After one step.
struct SpoonSample {
    double time_s;
    double penetration_m;         ///< of the deepest corner
    double coupling_deviation_m;  ///< from the hand to the spoon's grip
    double contact_force_N;       ///< of all contacts together
    double felt_force_N;          ///< in the hand
    double kinetic_energy_J;
    int n_touching;
    StepResult step;
};

constexpr double kSpoonCourse_s = 0.6;

/// The whole course, a sample a step.
[[nodiscard]] std::vector<SpoonSample> run_spoon(const SpoonSettings& settings);

/// Whether the spoon is still at the end of the time in which the hand is: less than 1 uJ from 400 to 450 ms, where 100 g that
/// ring out have 0.01 uJ, 150 g have 0.3 uJ and a spoon that chatters has 100 uJ and more.
[[nodiscard]] bool comes_to_rest(const std::vector<SpoonSample>& samples);

/// Worst and mean of what `value` gives, over the samples from `from_s` to `to_s`.
struct Summary {
    double worst = 0.0;
    double mean = 0.0;
    double spread = 0.0;  ///< largest less least
};
template <class Value>
[[nodiscard]] Summary summarise(const std::vector<SpoonSample>& samples, double from_s, double to_s,
                                Value value) {
    Summary summary;
    double least = 1.0e300;
    int n = 0;
    for (const SpoonSample& sample : samples) {
        if (sample.time_s >= from_s && sample.time_s <= to_s) {
            const double now = value(sample);
            summary.worst = now > summary.worst ? now : summary.worst;
            least = now < least ? now : least;
            summary.mean += now;
            ++n;
        }
    }
    summary.mean /= n > 0 ? n : 1;
    summary.spread = summary.worst - least;
    return summary;
}

}  // namespace fulcrum::test
