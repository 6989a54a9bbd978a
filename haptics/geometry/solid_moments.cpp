#include "haptics/geometry/solid_moments.h"

#include "haptics/math/dense.h"

#include <cmath>

namespace fulcrum {
namespace {

// The same axis or its opposite, so that its largest component is above 0.
Vector3 point_upwards(const Vector3& axis) noexcept {
    Index largest = 0;
    axis.cwiseAbs().maxCoeff(&largest);
    return axis[largest] < 0.0 ? Vector3(-axis) : axis;
}

}  // namespace

SolidMoments compute_solid_moments(const TriangleMesh& mesh) noexcept {
    // In the mesh's own size, so that meshes of any size are as exact.
    const Vector3 middle = 0.5 * (mesh.lower_B() + mesh.upper_B());
    const double size_m = mesh.diagonal_m();
    const auto corner = [&](std::int32_t i) noexcept -> Vector3 {
        return (mesh.vertices_B()[static_cast<std::size_t>(i)] - middle) / size_m;
    };
    double volume = 0.0;
    Vector3 first = Vector3::Zero();
    Matrix3 second = Matrix3::Zero();
    for (const TriangleCorners& triangle : mesh.triangles()) {
        const Vector3 a = corner(triangle[0]);
        const Vector3 b = corner(triangle[1]);
        const Vector3 c = corner(triangle[2]);
        const Vector3 e = a + b + c;
        const double determinant = a.dot(b.cross(c));
        volume += determinant / 6.0;
        first += determinant / 24.0 * e;
        second += determinant / 120.0 *
                  (a * a.transpose() + b * b.transpose() + c * c.transpose() + e * e.transpose());
    }
    // Parallel axes: the integral about the centre is that about the middle less V c c^T.
    const Vector3 centre = volume != 0.0 ? Vector3(first / volume) : Vector3(Vector3::Zero());
    second -= volume * centre * centre.transpose();
    const double cubed = size_m * size_m * size_m;
    return {cubed * volume, middle + size_m * centre, cubed * size_m * size_m * second};
}

PrincipalAxes compute_principal_axes(const Matrix3& tensor) noexcept {
    constexpr double kRounding = 1.0e-10;
    const double largest = tensor.cwiseAbs().maxCoeff();
    if (!(largest > 0.0) || !std::isfinite(largest)) {
        return {Vector3::Constant(largest), Quaternion::Identity()};
    }
    Matrix3 scaled = 0.5 / largest * (tensor + tensor.transpose());
    for (Index i = 0; i < 3; ++i) {
        for (Index j = 0; j < 3; ++j) {
            if (i != j && std::abs(scaled(i, j)) <= kRounding * scaled.trace()) {
                scaled(i, j) = 0.0;
            }
        }
    }
    const SymmetricAxes own = compute_symmetric_axes(scaled);
    Matrix3 axes;
    axes.col(0) = point_upwards(own.axes.col(0));
    axes.col(1) = point_upwards(own.axes.col(1));
    axes.col(2) = axes.col(0).cross(axes.col(1));
    Quaternion orientation(axes);
    orientation.normalize();
    return {largest * own.values, orientation};
}

}  // namespace fulcrum
