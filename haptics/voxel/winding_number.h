// How often a mesh winds round a point: which side of a surface the point is on, for surfaces with holes, cracks, doubled or
// loose triangles too.
//
//   w(p) = 1 / (4 pi) sum of Omega_t(p)       1 inside a closed mesh whose fronts face outwards, 0 outside, in between
//                                             near a hole: half the sky seen through it counts half
//   tan(Omega / 2) = a.(b x c) / (|a||b||c| + (a.b)|c| + (b.c)|a| + (c.a)|b|)     a, b, c from p to the corners
// A cluster (triangle_clusters.h) that is farther than `opening` times its radius counts as one dipole:
//   w_cluster(p) = N.(c - p) / (4 pi |c - p|^3)
// Inside is where |w| >= 1/2: a mesh turned inside out encloses what it encloses.
//
// Thread: build at load; asked from any thread. Cost: a few hundred triangles near, one dipole a far cluster: 1 to 3 us. Large
// triangles near each other are in no far cluster: 40 ns each.
// Source: A. Jacobson, L. Kavan, O. Sorkine-Hornung 2013, Robust inside-outside segmentation using generalized winding
// numbers, ACM TOG 32(4), section 4; the solid angle: A. van Oosterom, J. Strackee 1983, The solid angle of a plane
// triangle, IEEE Trans. Biomed. Eng. 30(2), equation 8; the dipoles: G. Barill, N. Dickson, R. Schmidt, D. Levin,
// A. Jacobson 2018, Fast winding numbers for soups and clouds, ACM TOG 37(4), section 3, its first order.
#pragma once

#include "haptics/voxel/triangle_clusters.h"

namespace fulcrum {

/// Radii beyond which a cluster counts as a dipole; 2 to 3 is usual, more is more exact and slower. At 2.5 the sum is
/// within 0.02 of the exact one.
inline constexpr double kDipoleOpening = 2.5;

/// The solid angle at which `p` sees the triangle, steradians, above 0 where it sees its back. At `p` on the triangle itself it
/// is one of its two sides' values.
[[nodiscard]] double compute_solid_angle(const Vector3& p, const TriangleAt& triangle) noexcept;

/// w at `p_B`.
[[nodiscard]] double compute_winding_number(const TriangleClusters& clusters, const Vector3& p_B,
                                            double opening = kDipoleOpening) noexcept;

/// How much work `compute_winding_number` is there: dipoles and triangles, of which each counts as five.
[[nodiscard]] double count_winding_terms(const TriangleClusters& clusters, const Vector3& p_B,
                                         double opening = kDipoleOpening) noexcept;

/// |w| >= 1/2.
[[nodiscard]] bool is_wound_round(const TriangleClusters& clusters, const Vector3& p_B) noexcept;

}  // namespace fulcrum
