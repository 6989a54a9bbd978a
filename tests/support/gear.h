// Bodies drawn out along z with a hole through them: a gear, a bush, and the peg that goes into it.
#pragma once

#include "haptics/geometry/triangle_mesh.h"

#include <vector>

namespace fulcrum {

struct GearSettings {
    int n_teeth = 12;
    double tip_m = 0.05;    ///< radius of the teeth's ends
    double root_m = 0.04;   ///< radius between them
    double bore_m = 0.015;  ///< radius of the hole
    double width_m = 0.02;
};

/// A gear round the z axis with teeth like trapezia, 32 triangles each; its middle is the origin.
[[nodiscard]] Expected<TriangleMesh> make_gear(const GearSettings& settings);

/// A ring with `n_sides` flat sides within and without: 8 n_sides triangles. Radii of its corners.
[[nodiscard]] Expected<TriangleMesh> make_bush(double outer_m, double inner_m, double width_m,
                                               int n_sides);

/// A prism round the z axis with flat sides: 4 n_sides triangles.
[[nodiscard]] Expected<TriangleMesh> make_peg(double radius_m, double length_m, int n_sides);

}  // namespace fulcrum
