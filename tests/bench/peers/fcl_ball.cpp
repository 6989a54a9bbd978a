// FCL: the nearest point of the mesh (bounding volumes OBBRSS), as a tiny ball at the hand finds it. It remembers nothing
// from step to step, so it cannot tell inside from outside: depth is distance.
#include "haptics/math/to_eigen.h"
#include "tests/bench/peers/felt_ball.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/distance.h>

namespace fulcrum::bench {
namespace {

using Model = fcl::BVHModel<fcl::OBBRSSd>;

std::shared_ptr<Model> make_model(const TriangleMesh& mesh) {
    auto model = std::make_shared<Model>();
    const auto& v = mesh.vertices_B();
    model->beginModel(static_cast<int>(mesh.triangles().size()), static_cast<int>(v.size()));
    const auto corner = [&](std::int32_t i) { return to_eigen(v[static_cast<std::size_t>(i)]); };
    for (const TriangleCorners& t : mesh.triangles()) {
        model->addTriangle(corner(t[0]), corner(t[1]), corner(t[2]));
    }
    model->endModel();
    return model;
}

FeltBall make(const TriangleMesh& mesh, double /*edge_m*/) {
    constexpr double kTiny_m = 1.0e-6;
    auto model = make_model(mesh);
    auto point = std::make_shared<fcl::Sphered>(kTiny_m);
    const auto bytes = static_cast<std::size_t>(model->memUsage(0));
    return {[=](const Vector3& hand_W) {
                fcl::Transform3d at = fcl::Transform3d::Identity();
                at.translation() = to_eigen(hand_W);
                const fcl::DistanceRequestd request(true);
                fcl::DistanceResultd result;
                fcl::distance(model.get(), fcl::Transform3d::Identity(), point.get(), at, request,
                              result);
                const Vector3 stretch_m = from_eigen(result.nearest_points[0]) - hand_W;
                return Felt{kStiffness_N_per_m * stretch_m, stretch_m.normalized(), true};
            },
            bytes};
}

const FeltBallRegistration kFcl{"FCL 0.7.0, nearest point", make};

}  // namespace
}  // namespace fulcrum::bench
