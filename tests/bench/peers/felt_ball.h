// Lets another library join the curve of mesh resolution: it feels the same ball, at the same places.
#pragma once

#include "haptics/geometry/triangle_mesh.h"
#include "tests/bench/curves/felt_surface.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

namespace fulcrum::bench {

/// What feels: where the hand is, what that gives.
struct FeltBall {
    std::function<Felt(const Vector3&)> feel;
    std::size_t bytes = 0;
};

/// Makes what feels from the ball's mesh, whose edges are `edge_m` long in the mean.
using MakeFeltBall = std::function<FeltBall(const TriangleMesh& mesh, double edge_m)>;

/// Static, one an adapter.
struct FeltBallRegistration {
    FeltBallRegistration(const std::string& name, const MakeFeltBall& make);
};

}  // namespace fulcrum::bench
