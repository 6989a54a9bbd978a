// The same shape from fewer triangles, for things that are small in the picture and for shadows.
//
//   Corners in one cell of a grid, that face the same way, move to one place; triangles that
//   lose an edge go. Corners that lay on each other still do, so that no seam opens; at a crease each
//   side keeps its normal, at a seam of the picture its uv.
//
// Thread: any; values. Cost: linear, at load.
// Source: J. Rossignac and P. Borrel, Multi-resolution 3D approximations for rendering complex
// scenes, in Modeling in Computer Graphics, 1993 (vertex clustering).
#pragma once

#include "runtime/scene/model.h"

namespace fulcrum::runtime::gl {

/// A primitive on a grid of cells with this side, metres, > 0. Wants positions, normals and indices
/// as ModelPrimitive promises them; uvs may be empty.
[[nodiscard]] ModelPrimitive simplified(const ModelPrimitive& primitive, float cell_m);

/// Whether triangles enclose a space and show it their backs: each edge is run through as often one
/// way as the other, and the enclosed volume is positive. The backs of such a surface are never
/// seen.
[[nodiscard]] bool is_closed(const ModelPrimitive& primitive);

}  // namespace fulcrum::runtime::gl
