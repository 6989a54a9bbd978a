#include "runtime/scene/body_shape.h"

#include "haptics/collision/collision_mesh.h"
#include "haptics/geometry/shape.h"
#include "runtime/scene/shape_models.h"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace fulcrum::runtime {
namespace {

constexpr double kOffMiddle = 1.0e-4;  // of its size: a model whose middle is not its origin

struct ModelBounds {
    Vector3 middle_B{Vector3::Zero()};
    Vector3 half_m{Vector3::Zero()};
};

ModelBounds find_bounds(const CollisionMesh& mesh) {
    Vector3 lower = Vector3::Constant(std::numeric_limits<double>::max());
    Vector3 upper = -lower;
    for (const Vector3& vertex_B : mesh.vertices_B()) {
        lower = lower.cwiseMin(vertex_B);
        upper = upper.cwiseMax(vertex_B);
    }
    return {0.5 * (lower + upper), 0.5 * (upper - lower)};
}

Expected<SolidShape> to_shape(const Expected<HullShape>& hull) {
    return hull.map([](const HullShape& shape) { return SolidShape(shape); });
}

std::vector<Vector3> find_corners(const ModelBounds& bounds) {
    std::vector<Vector3> corners;
    for (const double x : {-1.0, 1.0}) {
        for (const double y : {-1.0, 1.0}) {
            for (const double z : {-1.0, 1.0}) {
                corners.emplace_back(bounds.middle_B +
                                     bounds.half_m.cwiseProduct(Vector3(x, y, z)));
            }
        }
    }
    return corners;
}

struct MakeTriangles {
    int n_round;

    Expected<TriangleMesh> operator()(const SphereShape& ball) const {
        return make_sphere(ball.radius_m, n_round / 4);
    }
    Expected<TriangleMesh> operator()(const BoxShape& box) const {
        return make_box(2.0 * box.half_size_m);
    }
    Expected<TriangleMesh> operator()(const CapsuleShape& capsule) const {
        return capsule.half_length_m > 0.0
                   ? make_capsule(capsule.radius_m, 2.0 * capsule.half_length_m, n_round,
                                  n_round / 4)
                   : (*this)(SphereShape{capsule.radius_m});
    }
    Expected<TriangleMesh> operator()(const CylinderShape& cylinder) const {
        return make_cylinder(cylinder.radius_m, 2.0 * cylinder.half_height_m, n_round);
    }
    template <class Other>
    Expected<TriangleMesh> operator()(const Other& /*shape*/) const {
        return fail("it has no shape", {}, "give it a shape or a model");
    }
};

struct NameFormula {
    std::string_view operator()(const SphereShape& /*shape*/) const { return "ball"; }
    std::string_view operator()(const BoxShape& /*shape*/) const { return "box"; }
    std::string_view operator()(const CapsuleShape& /*shape*/) const { return "capsule"; }
    std::string_view operator()(const CylinderShape& /*shape*/) const { return "cylinder"; }
    template <class Other>
    std::string_view operator()(const Other& /*shape*/) const {
        return {};
    }
};

}  // namespace

Expected<SolidShape> make_body_shape(BodyShape kind, std::string_view field,
                                     const MeshShape& model) {
    const CollisionMesh& mesh = *model;
    const ModelBounds bounds = find_bounds(mesh);
    if (kind == BodyShape::mesh) {
        return model;
    }
    if (kind == BodyShape::hull) {
        return to_shape(make_hull_shape({mesh.vertices_B().begin(), mesh.vertices_B().end()}));
    }
    const bool is_off = bounds.middle_B.norm() > kOffMiddle * bounds.half_m.norm();
    if (kind == BodyShape::box) {
        return is_off ? to_shape(make_hull_shape(find_corners(bounds)))
                      : Expected<SolidShape>(BoxShape{bounds.half_m});
    }
    if (is_off) {
        return fail("its model's middle is not its origin, so it is no ball, cylinder or capsule",
                    {}, "give it " + std::string(field) + " = \"hull\" or \"box\"");
    }
    const double across_m = std::max(bounds.half_m.x(), bounds.half_m.z());
    switch (kind) {
        case BodyShape::ball:
            return SphereShape{bounds.half_m.maxCoeff()};
        case BodyShape::cylinder:
            return CylinderShape{across_m, bounds.half_m.y()};
        default:
            return CapsuleShape{across_m, std::max(bounds.half_m.y() - across_m, 0.0)};
    }
}

Expected<TriangleMesh> make_shape_triangles(const SolidShape& shape, int n_round) {
    return std::visit(MakeTriangles{n_round}, shape);
}

Expected<MeshShape> make_shape_mesh(const SolidShape& shape) {
    if (const MeshShape* const mesh = find_mesh(shape); mesh != nullptr) {
        return *mesh;
    }
    return make_shape_triangles(shape, 4 * kSphereModelFrequency)
        .and_then([](const TriangleMesh& mesh) { return CollisionMesh::create(mesh); });
}

std::string_view name_of_formula(const SolidShape& shape) {
    return std::visit(NameFormula{}, shape);
}

}  // namespace fulcrum::runtime
