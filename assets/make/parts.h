// What several models share.
#pragma once

#include "assets/make/mesh.h"

namespace fulcrum::assets {

/// The part with its triangles facing outwards, whichever way its sheet was laid; for closed parts.
[[nodiscard]] MeshPart outward(MeshPart part);

/// Moves a model so that the centre of mass of its first part (of even density) is the origin.
void centre_on_mass(Model& model);

/// A closed, slightly cupped leaf from the origin along +x, its upper side +y.
[[nodiscard]] MeshPart make_leaf(double length_m, double width_m);

/// Its picture: green with a light rib and side veins.
[[nodiscard]] Picture paint_leaf();

/// A closed bumpy ball: radii times (1 + bump * noise), for crowns of trees and clouds.
[[nodiscard]] MeshPart make_blob(const Vector3& centre_m, const Vector3& radii_m, double bump,
                                 int columns, int rows);

}  // namespace fulcrum::assets
