// FCL, bounding volumes OBBRSS: the nearest point of a mesh, and continuous collision of triangles and meshes with the same motion as
// ours: straight on, turning evenly. The tolerance of the latter is one of time, a share of the way.
#include "haptics/math/to_eigen.h"
#include "tests/bench/curves/continuous_ways.h"
#include "tests/bench/peers/felt_ball.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/distance.h>
#include <memory>
#include <span>

namespace fulcrum::bench {
namespace {

using Model = fcl::BVHModel<fcl::OBBRSSd>;

std::shared_ptr<Model> make_model(std::span<const Triangle> triangles) {
    auto model = std::make_shared<Model>();
    model->beginModel(static_cast<int>(triangles.size()), 3 * static_cast<int>(triangles.size()));
    for (const Triangle& t : triangles) {
        model->addTriangle(to_eigen(t[0]), to_eigen(t[1]), to_eigen(t[2]));
    }
    model->endModel();
    return model;
}

std::vector<Triangle> list_triangles(const TriangleMesh& mesh) {
    std::vector<Triangle> triangles;
    for (const TriangleCorners& t : mesh.triangles()) {
        const auto corner = [&](std::int32_t i) {
            return mesh.vertices_B()[static_cast<std::size_t>(i)];
        };
        triangles.push_back({corner(t[0]), corner(t[1]), corner(t[2])});
    }
    return triangles;
}

fcl::Transform3d to_transform(const Pose& pose) {
    fcl::Transform3d transform = fcl::Transform3d::Identity();
    transform.linear() = to_eigen(pose.orientation.toRotationMatrix());
    transform.translation() = to_eigen(pose.position);
    return transform;
}

double ask(const Model& fixed, const Model& moving, const Pose& start, const Pose& end,
           fcl::CCDSolverType solver, double toc_error) {
    const fcl::Transform3d still = fcl::Transform3d::Identity();
    // Of samples as many as the tolerance asks for.
    const auto n_samples = static_cast<std::size_t>(1.0 / toc_error);
    const fcl::ContinuousCollisionRequestd request(n_samples, toc_error, fcl::CCDM_LINEAR,
                                                   fcl::GST_LIBCCD, solver);
    fcl::ContinuousCollisionResultd result;
    fcl::continuousCollide(&fixed, still, still, &moving, to_transform(start), to_transform(end),
                           request, result);
    return result.is_collide ? result.time_of_contact : 2.0;
}

CostPoint measure_triangles(const Run& run, const std::string& series, fcl::CCDSolverType solver,
                            double toc_error) {
    // Trees are made before.
    const std::vector<KnownPair>& all = get_known_pairs(run);
    std::vector<std::pair<std::shared_ptr<Model>, std::shared_ptr<Model>>> models;
    for (const KnownPair& known : all) {
        models.emplace_back(make_model({&known.pair.fixed_A, 1}),
                            make_model({&known.pair.moving_B, 1}));
    }
    return measure_pairs(run, series, toc_error, [&](const KnownPair& known) {
        const auto& [fixed, moving] = models[static_cast<std::size_t>(&known - all.data())];
        return ask(*fixed, *moving, known.pair.start_AB, known.pair.end_AB, solver, toc_error);
    });
}

std::vector<CostPoint> measure_pairs_of_fcl(Run& run) {
    std::vector<CostPoint> points;
    for (const double toc_error : run.pick<std::vector<double>>({1.0e-4, 1.0e-2}, {1.0e-2})) {
        points.push_back(measure_triangles(run, "FCL 0.7.0, conservative advancement",
                                           fcl::CCDC_CONSERVATIVE_ADVANCEMENT, toc_error));
    }
    for (const double toc_error : run.pick<std::vector<double>>({1.0e-2, 1.0e-1}, {1.0e-1})) {
        points.push_back(measure_triangles(run, "FCL 0.7.0, samples", fcl::CCDC_NAIVE, toc_error));
    }
    return points;
}

std::vector<CostPoint> measure_meshes_of_fcl(Run& run) {
    const MeshWays& ways = get_mesh_ways(37);
    const auto model = make_model(list_triangles(ways.mesh));
    const auto measure = [&](const std::string& series, fcl::CCDSolverType solver, double toc_error,
                             std::size_t n_ways) {
        return measure_ways(ways, series, toc_error, n_ways, [&](std::size_t i) {
            return ask(*model, *model, ways.ways[i].first, ways.ways[i].second, solver, toc_error);
        });
    };
    return {measure("FCL 0.7.0, conservative advancement, 27380 triangles",
                    fcl::CCDC_CONSERVATIVE_ADVANCEMENT, 1.0e-4, run.pick<std::size_t>(24, 8)),
            measure("FCL 0.7.0, samples, 27380 triangles", fcl::CCDC_NAIVE, 1.0e-2, 200)};
}

const std::string kNote =
    "FCL's tolerance is a share of the way; its sampler looks at as many places";
const PeerRegistration kPairs{{"FCL 0.7.0", "continuous-collision", measure_pairs_of_fcl, kNote}};
const PeerRegistration kMeshes{
    {"FCL 0.7.0", "continuous-collision-meshes", measure_meshes_of_fcl, kNote}};

// The nearest point of the mesh, as a tiny ball at the hand finds it. It remembers nothing from step to step, so it cannot tell inside
// from outside: depth is distance.
FeltBall make(const TriangleMesh& mesh, double /*edge_m*/) {
    constexpr double kTiny_m = 1.0e-6;
    auto model = make_model(list_triangles(mesh));
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
