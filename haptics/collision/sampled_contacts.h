// Where two solids touch of which one need not be convex: up to eight patches, each a manifold with a normal of its own.
//
// Each body's samples (surface_samples.h) are held against the other's distance (sampled_shape.h):
//   corner   as it is
//   edge     slid along its edge to where the gap is least
//   face     slid along its surface to where it is least; of each group of samples the nearest. It counts where both surfaces face each
//            other, n_own . n_other < -0.95: else a corner or an edge of the other is what touches
// Corners and edges count where the other's normal lies within the cone of their own faces' normals.
// So corners against faces, edges across edges, and round against round or flat are each found as what they are.
// What lies within the margin is parted by normals: a touch belongs to the patch whose normal is within 25 degrees of its own, those of
// last time before new ones. Where the other's normal turns within a voxel, at its edges and corners, a touch says little of the
// direction: it joins what surer ones have found within 60 degrees. A patch's normal is the mean of its touches', each by how far it is within the margin, so it turns evenly
// while touches come and go. Of a patch those count that are no farther than its nearest by 0.2 % of the size and what may close within the
// step. A field rounds edges by some hundredths of its voxel: a face that is nearer by less than that than a corner or
// an edge of its patch is as near. Which four of a patch are kept, and which of them are those of last time, is contact_points.h.
//
// Thread: that which steps the pair. Cost: 5 to 100 us, by how much of the surfaces is near; no allocation.
// Source: M. Macklin, K. Erleben, M. Mueller, N. Chentanez, S. Jeschke, Z. Corse 2020, Local optimization for robust signed distance
// field collision, Proc. ACM CGIT 3(1): the least gap of each feature is sought, instead of taken at samples; here by halving along the
// feature, where they project gradients.
#pragma once

#include "haptics/collision/contact_manifold.h"
#include "haptics/collision/sampled_shape.h"

#include <span>

namespace fulcrum {

inline constexpr int kMostPatches = 8;

struct SampledBody {
    const SampledShape& shape;
    const ContactPlace& place;
};

/// What counts as near.
struct TouchRange {
    double margin_m = 0.0;  ///< gaps up to this
    double ahead_m = 0.0;   ///< of it, how far they may close within the step
};

/// Writes all of `patches`, at most eight, which hold those of the last time; those that are not needed have no contacts. `size_m` is the
/// smaller body's. A place or margin that is not finite has no contacts.
void find_sampled_contacts(const SampledBody& first, const SampledBody& second, double size_m,
                           const TouchRange& range,
                           std::span<ContactManifold* const> patches) noexcept;

}  // namespace fulcrum
