// A model's triangles and pictures in the graphics card's memory.
//
// Each part is also kept in coarser forms, for shadows and for when it is small in the picture.
//
// Thread: the one that holds the context. Cost: 32 bytes a corner, 4 bytes an index, 5.3 bytes a
// pixel.
#pragma once

#include "haptics/base/error.h"
#include "haptics/math/matrix.h"
#include "runtime/render/gl/handle.h"
#include "runtime/scene/model.h"

#include <array>
#include <vector>

namespace fulcrum::runtime::gl {

/// Triangles of one material.
struct MeshPart {
    VertexArray vertex_array;
    Buffer vertices;
    Buffer indices;
    GLsizei index_count = 0;
    std::array<float, 4> base_colour{1.0F, 1.0F, 1.0F, 1.0F};  ///< linear
    float roughness = 0.6F;
    int texture = -1;     ///< index into Mesh::textures
    bool closed = false;  ///< its backs are never seen
};

/// How long a thing may be in the picture, pixels, for levels 1, 2 and 3.
inline constexpr std::array<double, 3> kLevelPixels{300.0, 200.0, 90.0};

/// A model ready to draw.
struct Mesh {
    /// All parts, in ever fewer triangles: as given, then for things at most kLevelPixels[i - 1]
    /// long in the picture.
    std::array<std::vector<MeshPart>, kLevelPixels.size() + 1> levels;
    std::vector<Texture> textures;
    Vector3f lowest{Vector3f::Zero()};   ///< corner of the bounding box, metres
    Vector3f highest{Vector3f::Zero()};  ///< corner of the bounding box, metres
};

/// Checks a model and copies it to the card. Missing normals are computed, missing uvs are zero.
[[nodiscard]] Expected<Mesh> upload(const LoadedModel& model);

/// Draws a part's triangles with the current program; the backs of a closed part are left out.
/// Switches face culling off.
void draw(const MeshPart& part);

/// The level for a thing that is so many pixels long in the picture.
[[nodiscard]] std::size_t level_for(double length_px);

}  // namespace fulcrum::runtime::gl
