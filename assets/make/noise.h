// Smooth noise in space, the same on every machine: what makes melon stripes ragged and bananas
// freckled.
//
// Source: Perlin 2002, "Improving Noise" (gradients on a lattice, quintic fade); our own hash in
// place of its table.
#pragma once

#include "haptics/math/spatial.h"

namespace fulcrum::assets {

/// Gradient noise, about -1 to 1, 0 at lattice points; features about 1 unit apart.
[[nodiscard]] double noise(const Vector3& p);

/// Sum of `octaves` noises, each twice as fine and half as strong; about -1 to 1.
[[nodiscard]] double fractal_noise(const Vector3& p, int octaves);

/// 0 below `from`, 1 above `to`, smooth between.
[[nodiscard]] double smooth_step(double from, double to, double x);

/// A number from 0 to 1 for each cell of the unit lattice.
[[nodiscard]] double cell_hash(long x, long y, long z);

/// Strength 0 to 1 of round spots, at most one a unit cell, present in the share `density` of
/// cells, of `radius` below 0.5 units.
[[nodiscard]] double spots(const Vector3& p, double density, double radius);

}  // namespace fulcrum::assets
