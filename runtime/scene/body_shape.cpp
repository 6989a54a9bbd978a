#include "runtime/scene/body_shape.h"

#include "haptics/collision/collision_mesh.h"
#include "haptics/geometry/shape.h"
#include "runtime/scene/shape_models.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace fulcrum::runtime {
namespace {

constexpr double kOffMiddle = 1.0e-4;  // of its size: a model whose middle is not its origin
constexpr int kUpright = 1;
constexpr double kRounder = 0.1;  // by so much of its width an axis must be rounder than y

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

bool is_off(const ModelBounds& bounds) {
    return bounds.middle_B.norm() > kOffMiddle * bounds.half_m.norm();
}

// The axis across which the model is nearest to a square: that of a coin, of a log however it lies.
int find_axis(const Vector3& half_m) {
    const auto find_oblong = [&](int axis) {
        const double a = half_m[(axis + 1) % 3];
        const double b = half_m[(axis + 2) % 3];
        return a > 0.0 || b > 0.0 ? std::abs(a - b) / std::max(a, b) : 0.0;
    };
    int found = kUpright;
    for (const int axis : {0, 2}) {
        if (find_oblong(axis) < find_oblong(found) - (found == kUpright ? kRounder : 0.0)) {
            found = axis;
        }
    }
    return found;
}

SolidShape make_formula(BodyShape kind, const Vector3& half_m, int axis) {
    const double along_m = half_m[axis];
    const double across_m = std::max(half_m[(axis + 1) % 3], half_m[(axis + 2) % 3]);
    switch (kind) {
        case BodyShape::ball:
            return SphereShape{half_m.maxCoeff()};
        case BodyShape::box:
            return BoxShape{half_m};
        case BodyShape::cylinder:
            return CylinderShape{across_m, along_m};
        default:
            return CapsuleShape{across_m, std::max(along_m - across_m, 0.0)};
    }
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

Expected<SolidShape> make_of_triangles(BodyShape kind, const MeshShape& model) {
    const auto vertices_B = model->vertices_B();
    return kind == BodyShape::mesh
               ? Expected<SolidShape>(model)
               : to_shape(make_hull_shape({vertices_B.begin(), vertices_B.end()}));
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

struct NameShape {
    std::string_view operator()(const SphereShape& /*shape*/) const { return "ball"; }
    std::string_view operator()(const BoxShape& /*shape*/) const { return "box"; }
    std::string_view operator()(const CapsuleShape& /*shape*/) const { return "capsule"; }
    std::string_view operator()(const CylinderShape& /*shape*/) const { return "cylinder"; }
    std::string_view operator()(const HullShape& /*shape*/) const { return "hull"; }
    template <class Other>
    std::string_view operator()(const Other& /*shape*/) const {
        return "mesh";
    }
};

}  // namespace

BodyShape shape_of_model(std::string_view model) noexcept {
    return is_ball_model(model)      ? BodyShape::ball
           : model == kBoxModel      ? BodyShape::box
           : model == kCylinderModel ? BodyShape::cylinder
           : model == kCapsuleModel  ? BodyShape::capsule
                                     : BodyShape::model;
}

Expected<PlacedShape> make_felt_shape(BodyShape kind, const MeshShape& model) {
    if (kind == BodyShape::mesh || kind == BodyShape::hull) {
        return make_of_triangles(kind, model).map([](const SolidShape& shape) {
            return PlacedShape{shape};
        });
    }
    const ModelBounds bounds = find_bounds(*model);
    const bool is_long = kind == BodyShape::cylinder || kind == BodyShape::capsule;
    const int axis = is_long ? find_axis(bounds.half_m) : kUpright;
    return PlacedShape{
        make_formula(kind, bounds.half_m, axis),
        {is_off(bounds) ? bounds.middle_B : Vector3(Vector3::Zero()),
         axis == kUpright ? Quaternion::Identity()
                          : Quaternion::FromTwoVectors(Vector3::UnitY(), Vector3::Unit(axis))}};
}

Expected<SolidShape> make_body_shape(BodyShape kind, const MeshShape& model) {
    if (kind == BodyShape::mesh || kind == BodyShape::hull) {
        return make_of_triangles(kind, model);
    }
    const ModelBounds bounds = find_bounds(*model);
    if (is_off(bounds) && kind == BodyShape::box) {
        return to_shape(make_hull_shape(find_corners(bounds)));
    }
    if (is_off(bounds)) {
        return fail(
            "its model's middle is not its origin, so a rigid body of it is no ball, cylinder or "
            "capsule",
            {},
            "give it shape = \"hull\" or \"box\", which is full as well: a bucket or a ring of it "
            "holds nothing; or \"mesh\", which leaves it hollow");
    }
    return make_formula(kind, bounds.half_m, kUpright);
}

Expected<TriangleMesh> make_shape_triangles(const SolidShape& shape, int n_round) {
    return std::visit(MakeTriangles{n_round}, shape);
}

Expected<MeshShape> make_shape_mesh(const SolidShape& shape, const Pose& shape_B) {
    if (const MeshShape* const mesh = find_mesh(shape); mesh != nullptr) {
        return *mesh;
    }
    return make_shape_triangles(shape, 4 * kSphereModelFrequency)
        .and_then([&](const TriangleMesh& mesh) {
            std::vector<Vector3> vertices_B(mesh.vertices_B().begin(), mesh.vertices_B().end());
            for (Vector3& vertex_B : vertices_B) {
                vertex_B = shape_B * vertex_B;
            }
            const auto& triangles = mesh.triangles();
            return TriangleMesh::build(std::move(vertices_B), {triangles.begin(), triangles.end()});
        })
        .and_then([](const TriangleMesh& mesh) { return CollisionMesh::create(mesh); });
}

std::string_view name_of_felt(const BodyDescription& body, const SolidShape& shape) {
    const BodyDescription felt = as_felt(body);
    const bool is_box =
        felt.felt_as == BodyShape::model && felt.model == kBoxModel && felt.boxes.empty();
    return is_box ? kBoxModel : std::visit(NameShape{}, shape);
}

}  // namespace fulcrum::runtime
