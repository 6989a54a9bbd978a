// Tools on objects whose contact force and torque are known: what the accuracy of sampling is measured against.
//
//   pressure     kappa d a unit of the tool's surface, along its inward normal n; d how deep it lies in the object. N points of a tool
//                of area A feel kappa A / N each
//   ball on a plane       F = kappa 2 pi R^2 ((d - R)(1 - u^2) / 2 + R (1 - u^3) / 3),  u = 1 - d / R, d at the lowest point
//   face on a cylinder    F = kappa L (R x - h^2 asinh(x / h)),  h = R - d, x = sqrt(R^2 - h^2), L the face's length along the axis
//   free forms            a bumpy ball on a torus, or meshes of your own, by a hundred thousand points or more and the finest field: converged;
//                         pressed in until one in two hundred of the tool's points is inside
// All lie askew in the lattice, and the tool's origin beside its middle, so that there is a torque.
#pragma once

#include "haptics/geometry/triangle_mesh.h"
#include "haptics/math/spatial.h"
#include "haptics/tool/field_sampling/field_sampler.h"
#include "haptics/voxel/pointshell.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace fulcrum::bench {

struct AccuracyScene {
    std::string name;       ///< "sphere-plane"
    std::string title;      ///< "A ball on a plane"
    std::string reference;  ///< "analytic: ..."
    TriangleMesh object;
    std::function<Pointshell(int n_points)> make_shell;
    double area_m2 = 0.0;  ///< of the tool
    std::vector<Pose> X_OT;
    /// On the tool at each pose, frame O, about the tool's origin, for kappa = 1 N/m^3. Empty: not known yet.
    std::vector<Wrench> wrenches_O;
};

/// So many voxels along its longest side.
[[nodiscard]] inline FieldSampler::Field make_distance_field(const TriangleMesh& object,
                                                             int n_along) {
    return std::make_shared<const DistanceField>(
        DistanceField::build(object, make_field_frame(object, n_along).value()).value());
}

[[nodiscard]] AccuracyScene make_sphere_plane(int n_poses);
[[nodiscard]] AccuracyScene make_cylinder_box(int n_poses);
/// The tool of one file on the object of another, each as large as what is there where its file is empty: a bumpy ball on a torus.
/// Its wrenches are not known. Throws std::runtime_error, one sentence, where a file cannot be read.
[[nodiscard]] AccuracyScene make_free_forms(int n_poses, const std::string& object_file,
                                            const std::string& tool_file);

}  // namespace fulcrum::bench
