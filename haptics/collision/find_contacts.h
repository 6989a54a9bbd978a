// Where two convex bodies touch: a normal and up to four points, which stay the same points from step to step.
//
//   gap = height of the upper body over the lower along n at a place; below 0 they overlap. n from the second to the first
// The direction comes of contact_axis.h, the points of contact_shadow.h: the corners of what both bodies' features share, of which those
// within the margin count. Of more than four, four are kept that span the largest area, the deepest among them. A point's place lies half
// way between both surfaces.
//
// What was there last time is kept where it can be, as contact_manifold.h tells the same point again. The four kept are those of last time
// unless others span a tenth more, or are deeper.
//
// Thread: that which steps the pair. Cost: two boxes face to face 0.4 us; no allocation.
// Source: symmetric in both bodies by the shadows' law; the four points as D. Gregorius 2015, Robust contact creation for physics
// simulations, GDC, chooses them.
#pragma once

#include "haptics/collision/contact_manifold.h"
#include "haptics/collision/contact_shape.h"

namespace fulcrum {

/// Finds the pair's contacts anew; `manifold` is that of the last time, or a fresh one. Points with a gap above `margin_m`, 0 or more, are
/// left out. A place that is not finite has no contacts. Two half spaces never touch.
void find_contacts(const ContactShape& first, const ContactPlace& first_place,
                   const ContactShape& second, const ContactPlace& second_place, double margin_m,
                   ContactManifold& manifold) noexcept;

}  // namespace fulcrum
