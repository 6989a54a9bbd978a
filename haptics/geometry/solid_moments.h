// How much a closed surface encloses, where the centre of that lies, and how it is spread: what masses and moments of inertia
// are made of.
//
//   V   = integral of 1             = sum of D / 6,   D = a . (b x c) of a triangle with the corners a, b, c
//   V c = integral of p             = sum of D / 24  e,   e = a + b + c
//   S   = integral of p p^T         = sum of D / 120 (a a^T + b b^T + c c^T + e e^T)
// Each term belongs to the tetrahedron between the triangle and one point common to all, here the middle of the mesh's box, and
// counts below 0 where that point sees the triangle's front. So a place counts as often as the surface winds round it: twice
// where two solids overlap, less than 0 where fronts look inwards. A surface with holes has no such sums: what is missing
// depends on the common point.
//
// Thread: load. Cost: some 60 multiplications a triangle.
// Source: M. Kallay 2006, Computing the moment of inertia of a solid defined by a triangle mesh, Journal of Graphics Tools 11(2);
// the sum over signed tetrahedra: S. Lien, J. Kajiya 1984, A symbolic method for calculating the integral properties of
// arbitrary nonconvex polyhedra, IEEE Computer Graphics and Applications 4(10).
#pragma once

#include "haptics/geometry/triangle_mesh.h"

namespace fulcrum {

/// Of a solid, frame B.
struct SolidMoments {
    double volume_m3 = 0.0;  ///< below 0 where the surface is inside out
    Vector3 centre_B{
        Vector3::Zero()};  ///< of the volume; the middle of the mesh's box where there is none
    Matrix3 second_m5{
        Matrix3::Zero()};  ///< the integral of (p - c)(p - c)^T; below 0 like the volume
};

/// Moments and how they were found.
struct MeasuredSolid {
    SolidMoments moments{};
    bool by_samples = false;  ///< not the sums above: the mesh is broken, and was sampled
};

/// Of what the mesh winds round.
[[nodiscard]] SolidMoments compute_solid_moments(const TriangleMesh& mesh) noexcept;

/// The tensor of inertia over the density, trace(S) - S, m^5, about the centre.
[[nodiscard]] inline Matrix3 compute_unit_inertia(const SolidMoments& moments) noexcept {
    return moments.second_m5.trace() * Matrix3::Identity() - moments.second_m5;
}

/// A symmetric tensor seen along axes in which it is diagonal.
struct PrincipalAxes {
    Vector3 moments{Vector3::Zero()};  ///< ascending
    /// Turns the principal axes' frame to the tensor's: I = R diag(moments) R^T. Of the first two axes the largest component is
    /// above 0, so the same tensor has the same axes each time.
    Quaternion orientation{Quaternion::Identity()};
};

/// Of a symmetric tensor. What lies beside the diagonal by rounding alone, 1e-10 of the trace, counts as none: where moments are
/// equal the axes are then the tensor's own.
[[nodiscard]] PrincipalAxes compute_principal_axes(const Matrix3& tensor) noexcept;

}  // namespace fulcrum
