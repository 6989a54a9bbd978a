// Two jaws that bite, slide and grind on each other: meshes by rule, and a course over which contact is found more or less often. After the
// experiment of Otaduy and Lin 2005, section 7, figures 5 and 6, with scenes of our own.
//
//   jaw     a horseshoe of radius 25 mm, some 16 mm thick, with teeth on its biting side; n_along x n_round corners
//   tool    the upper jaw, 10 g, on a coupling of 500 N/m; contacts of 5 kN/m
//   hand    900 ms: down from 8 mm above to a bite (0 to 200), sideways and back grinding over the teeth (200 to 700), up again
#pragma once

#include "haptics/tool/implicit_penalty/implicit_penalty.h"

#include <vector>

namespace fulcrum::test {

/// Closed; the biting side looks along y. About its centre of mass nothing is said: a frame at the arch's middle.
[[nodiscard]] Expected<TriangleMesh> make_jaw(int n_along, int n_round);

struct JawsSettings {
    PenaltyModel model = PenaltyModel::planes;
    double round_s = 0.0;  ///< of the contact thread; 0: each step
    int n_along = 160;
    int n_round = 64;  ///< 20 k triangles a jaw
    int n_points = 6000;
};

/// After one step.
struct JawsSample {
    double time_s = 0.0;
    double penetration_m = 0.0;  ///< of the tool's deepest point in the lower jaw itself, 0 or more
    double deviation_m = 0.0;    ///< from the hand to the tool's grip
    double felt_N = 0.0;
    double round_us = 0.0;  ///< what a round of contact took, by the machine's clock
    int n_clusters = 0;
};

inline constexpr double kJawsCourse_s = 0.9;

/// A sample a millisecond.
[[nodiscard]] std::vector<JawsSample> run_jaws(const JawsSettings& settings);

}  // namespace fulcrum::test
