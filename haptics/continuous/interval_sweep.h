// When two triangles first touch: the fifteen elementary contacts in interval arithmetic. Slow, and what the faster finder is judged by.
//
// The first contact of two triangles that were apart is one of a corner and a face (six ways) or of two edges (nine). Each is looked for from the
// beginning of the way on, in halves: a piece of time T is free of it when
//   the heights say so    |f(T)| > touch |n|: no root of Redon's equation (turn_function.h), f(T) enclosed by itself and by its mean value form
//                         f(m) + f'(T) (T - m), of which the intersection with [-touch |n|, touch |n|] also cuts T to where roots may be (Newton)
//   a direction says so   k . p(T) > max k . a_j + touch for all the features' moving corners, k between the nearest points at T's middle
// Otherwise T is halved, until no place moves farther in half of it than a quarter of the tolerance. Then its beginning is the contact: the
// direction would have told a distance above touch + tolerance / 2 from touch. Of the fifteen the first counts.
//
// Why nothing is missed. T is dropped only where an enclosure says that no time in it is a contact; enclosures hold all values (interval.h, the
// series of in_between_motion.h, the coefficients of turn_function.h); the halves of T are all of T; and what is nearer than `touch` within one
// of the features passes none of the two tests at that time. Nothing is asked of rounded numbers but k and the cuts' places, for which any
// number would do. Edges that are parallel, faces without area, motions in the plane have f = 0 all along: there the directions decide alone.
// It ends: a way of length L has at most 4 L / tolerance last pieces; kMostPieces ends it earlier, with the beginning of the piece that is next as
// the contact (never a miss).
//
// Thread: any; no allocation. Cost: 20 to 100 us.
// Source: S. Redon, A. Kheddar, S. Coquillart 2002 (in_between_motion.h): intervals for the elementary equations; Moore, Kearfott, Cloud 2009
// (interval.h), section 8.1: interval Newton.
#pragma once

#include "haptics/continuous/sweep.h"

namespace fulcrum {

/// Pieces of time that one elementary contact is looked for in.
inline constexpr int kMostPieces = 20000;

/// As `sweep_triangles`.
[[nodiscard]] TriangleSweep sweep_triangles_by_intervals(
    const InBetweenMotion& motion, const Triangle& fixed, const MovingTriangle& moving,
    const SweepSettings& settings, double t_begin = 0.0, double t_end = 1.0) noexcept;

}  // namespace fulcrum
