// Reads a grid of OpenVDB between its voxels.
#pragma once

#include "haptics/math/spatial.h"

#include <array>
#include <openvdb/openvdb.h>

namespace fulcrum::bench {

// The value and its gradient a voxel at `at`, in voxels, from the cell's eight corners.
struct OpenVdbSample {
    double value;
    Vector3 slope;
};
inline OpenVdbSample read_openvdb(openvdb::FloatGrid::ConstAccessor& field, const Vector3& at) {
    const Vector3 low = at.cwiseFloor();
    const Vector3 u = at - low;
    const openvdb::Coord corner(static_cast<int>(low.x()), static_cast<int>(low.y()),
                                static_cast<int>(low.z()));
    std::array<double, 8> v{};
    for (int i = 0; i < 8; ++i) {
        v[static_cast<std::size_t>(i)] =
            field.getValue(corner.offsetBy(i & 1, (i >> 1) & 1, i >> 2));
    }
    const auto mix = [](double a, double b, double t) { return a + t * (b - a); };
    const std::array<double, 4> x{mix(v[0], v[1], u.x()), mix(v[2], v[3], u.x()),
                                  mix(v[4], v[5], u.x()), mix(v[6], v[7], u.x())};
    const std::array<double, 4> dx{v[1] - v[0], v[3] - v[2], v[5] - v[4], v[7] - v[6]};
    const double y0 = mix(x[0], x[1], u.y());
    const double y1 = mix(x[2], x[3], u.y());
    return {mix(y0, y1, u.z()),
            {mix(mix(dx[0], dx[1], u.y()), mix(dx[2], dx[3], u.y()), u.z()),
             mix(x[1] - x[0], x[3] - x[2], u.z()), y1 - y0}};
}

}  // namespace fulcrum::bench
