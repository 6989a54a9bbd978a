// Triangles for models: sheets given as a function of (u, v), with smooth normals and texture
// coordinates.
//
// Metres, +Y up. A sheet's outer side is the one from which u runs to the right while v runs
// downwards, as a picture lies on it; `MeshPart::turn_inside_out` mends a sheet that came out the
// other way.
#pragma once

#include "assets/make/picture.h"
#include "haptics/math/affine.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace fulcrum::assets {

/// Triangles of one material.
struct MeshPart {
    std::vector<Vector3> positions;  ///< metres
    std::vector<Vector3> normals;    ///< unit
    std::vector<Vector2> uvs;
    std::vector<std::uint32_t> indices;
    Colour colour{1.0, 1.0, 1.0};  ///< linear, multiplies the picture
    double alpha = 1.0;
    double roughness = 0.6;
    int picture = -1;  ///< index into Model::pictures

    void turn_inside_out();
    void transform(const Affine& X);
    /// Adds another part's triangles; material and picture stay this one's.
    void append(const MeshPart& other);
};

/// A whole model.
struct Model {
    std::string name;
    std::vector<MeshPart> parts;
    std::vector<Picture> pictures;
};

/// A surface: point at (u, v), both 0 to 1.
using Surface = std::function<Vector3(double u, double v)>;

/// Cuts a surface into columns x rows rectangles, two triangles each (one at a pole). Corners that
/// coincide share a normal.
[[nodiscard]] MeshPart tessellate(const Surface& surface, int columns, int rows);

/// Computes normals, weighted by area; corners within 1e-7 m of each other share one.
void smooth_normals(MeshPart& part);

/// Volume enclosed by all parts together (signed: negative when inside out), and its centroid.
struct Bulk {
    double volume_m3 = 0.0;
    Vector3 centroid{Vector3::Zero()};
};
[[nodiscard]] Bulk bulk_of(const MeshPart& part);

/// Surface of revolution about +Y of a profile (radius, height), v along the profile from its first
/// point.
[[nodiscard]] Surface revolve(std::function<Vector2(double v)> profile);

/// A smooth curve through points (Catmull-Rom), t from 0 to 1.
[[nodiscard]] Vector2 curve_through(const std::vector<Vector2>& points, double t);

/// A tube along a curve: `radius(t)` metres; its ends are closed when the radius goes to 0 there.
[[nodiscard]] Surface tube(std::function<Vector3(double t)> curve,
                           std::function<double(double t)> radius);

/// Ellipsoid about the origin, poles on +-Y, v = 0 at the top.
[[nodiscard]] Surface ellipsoid(const Vector3& radii_m);

}  // namespace fulcrum::assets
