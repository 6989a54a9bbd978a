#include "haptics/collision/contact_shape.h"

#include "haptics/collision/collision_mesh.h"
#include "haptics/collision/convex_cursor.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fulcrum {
namespace {

// Of an end of a cylinder. Between them the polygon falls short of the circle by 1.9 % of the radius.
constexpr int kEndCorners = 16;
// A direction this far across the axis, as a sine, tilts an end.
constexpr double kTilted = 1.0e-3;
// Corners this near a face's plane, of the hull's size, belong to it.
constexpr double kInPlane = 1.0e-7;
// Beyond this cosine a capsule's end is all that is near.
constexpr double kTowardsEnd = 0.9;

double sign_along(double x) noexcept {
    return x < 0.0 ? -1.0 : 1.0;
}

// A box's faces are 2 axis + (0 upwards, 1 downwards).
Vector3 box_normal(std::int32_t face) noexcept {
    return (face % 2 == 0 ? 1.0 : -1.0) * Vector3::Unit(face / 2);
}

std::int32_t find_box_face(const Vector3& direction) noexcept {
    int axis = 0;
    direction.cwiseAbs().maxCoeff(&axis);
    return 2 * axis + (direction[axis] < 0.0 ? 1 : 0);
}

std::int32_t find_hull_face(const HullFaces& hull, const Vector3& direction) noexcept {
    std::int32_t best = 0;
    double most = -2.0;
    for (std::size_t i = 0; i < hull.faces.size(); ++i) {
        const double along = hull.faces[i].normal_B.dot(direction);
        if (along > most) {
            most = along;
            best = static_cast<std::int32_t>(i);
        }
    }
    return best;
}

void write_box_face(const Vector3& half_m, std::int32_t face, SupportFeature& feature) noexcept {
    const int axis = face / 2;
    const int next = (axis + 1) % 3;
    const int last = (axis + 2) % 3;
    const double sign = face % 2 == 0 ? 1.0 : -1.0;
    Vector3 corner;
    corner[axis] = sign * half_m[axis];
    constexpr double kAround[4][2] = {{1.0, 1.0}, {-1.0, 1.0}, {-1.0, -1.0}, {1.0, -1.0}};
    for (int i = 0; i < 4; ++i) {
        const auto& at = kAround[sign > 0.0 ? i : 3 - i];
        corner[next] = at[0] * half_m[next];
        corner[last] = at[1] * half_m[last];
        feature.corners_B[static_cast<std::size_t>(i)] = corner;
    }
    feature.count = 4;
    feature.normal_B = sign * Vector3::Unit(axis);
    feature.face = face;
}

void write_cylinder_end(const Vector3& half_m, const Vector3& direction,
                        SupportFeature& feature) noexcept {
    const double up = sign_along(direction.y());
    const double across = std::hypot(direction.x(), direction.z());
    Vector3 arm(half_m.x(), 0.0, 0.0);
    if (across > kTilted) {
        arm = half_m.x() / across * Vector3(direction.x(), 0.0, direction.z());
    }
    constexpr double kTurn_rad = 2.0 * std::numbers::pi / kEndCorners;
    const double cosine = std::cos(kTurn_rad);
    const double sine = -up * std::sin(kTurn_rad);
    for (int i = 0; i < kEndCorners; ++i) {
        feature.corners_B[static_cast<std::size_t>(i)] = {arm.x(), up * half_m.y(), arm.z()};
        arm = {cosine * arm.x() - sine * arm.z(), 0.0, sine * arm.x() + cosine * arm.z()};
    }
    feature.count = kEndCorners;
    feature.normal_B = up * Vector3::UnitY();
    feature.face = up > 0.0 ? 0 : 1;
}

void write_cylinder(const Vector3& half_m, const Vector3& direction,
                    SupportFeature& feature) noexcept {
    if (std::abs(direction.y()) >= std::numbers::sqrt2 / 2.0) {
        write_cylinder_end(half_m, direction, feature);
        return;
    }
    const double part = half_m.x() / std::hypot(direction.x(), direction.z());
    for (const int end : {0, 1}) {
        const double y = end == 0 ? -half_m.y() : half_m.y();
        feature.corners_B[static_cast<std::size_t>(end)] = {part * direction.x(), y,
                                                            part * direction.z()};
    }
    feature.count = 2;
}

void write_capsule(double half_m, double along, SupportFeature& feature) noexcept {
    feature.corners_B[0] = {
        0.0, std::abs(along) > kTowardsEnd ? sign_along(along) * half_m : -half_m, 0.0};
    feature.corners_B[1] = {0.0, half_m, 0.0};
    feature.count = std::abs(along) > kTowardsEnd || !(half_m > 0.0) ? 1 : 2;
}

void write_hull_face(const HullFaces& hull, std::int32_t index, SupportFeature& feature) noexcept {
    const HullFaces::Face& face = hull.faces[static_cast<std::size_t>(index)];
    feature.count = static_cast<int>(face.count);
    for (std::uint32_t i = 0; i < face.count; ++i) {
        feature.corners_B[i] = hull.vertices_B[hull.corners[face.first + i]];
    }
    feature.normal_B = face.normal_B;
    feature.face = index;
}

// All corners in the plane of a triangle, counter-clockwise round their middle, thinned where they are many.
std::vector<std::uint32_t> find_corners_in_plane(const std::vector<Vector3>& vertices,
                                                 const Vector3& on, const Vector3& normal,
                                                 double tolerance_m) {
    std::vector<std::uint32_t> corners;
    Vector3 middle = Vector3::Zero();
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        if (std::abs(normal.dot(vertices[i] - on)) <= tolerance_m) {
            corners.push_back(static_cast<std::uint32_t>(i));
            middle += vertices[i];
        }
    }
    middle /= static_cast<double>(corners.size());
    const Vector3 across = compute_direction(Vector3(vertices[corners.front()] - middle));
    const Vector3 up = normal.cross(across);
    const auto angle = [&](std::uint32_t i) {
        const Vector3 arm = vertices[i] - middle;
        return std::atan2(up.dot(arm), across.dot(arm));
    };
    std::ranges::stable_sort(corners, {}, angle);
    const std::size_t n = std::min(corners.size(), static_cast<std::size_t>(kMostCorners));
    for (std::size_t i = 0; i < n; ++i) {
        corners[i] = corners[i * corners.size() / n];
    }
    corners.resize(n);
    return corners;
}

std::shared_ptr<const HullFaces> make_faces(const CollisionMesh& mesh) {
    auto hull = std::make_shared<HullFaces>();
    hull->vertices_B.assign(mesh.vertices_B().begin(), mesh.vertices_B().end());
    const double tolerance_m = kInPlane * mesh.radius_m();
    std::vector<bool> is_taken(mesh.triangles().size(), false);
    for (std::size_t t = 0; t < is_taken.size(); ++t) {
        if (is_taken[t]) {
            continue;
        }
        const auto corners_B = mesh.places_B(static_cast<std::int32_t>(t));
        const Vector3& on = corners_B[0];
        const Vector3 normal =
            compute_direction(Vector3((corners_B[1] - on).cross(corners_B[2] - on)));
        for (std::size_t other = t; other < is_taken.size(); ++other) {
            const auto places = mesh.places_B(static_cast<std::int32_t>(other));
            is_taken[other] = is_taken[other] || std::ranges::all_of(places, [&](const Vector3& p) {
                                  return std::abs(normal.dot(p - on)) <= tolerance_m;
                              });
        }
        is_taken[t] = true;
        const auto corners = find_corners_in_plane(hull->vertices_B, on, normal, tolerance_m);
        hull->faces.push_back({normal, static_cast<std::uint32_t>(hull->corners.size()),
                               static_cast<std::uint32_t>(corners.size())});
        hull->corners.insert(hull->corners.end(), corners.begin(), corners.end());
    }
    return hull;
}

struct KindOf {
    using Kind = ContactShape::Kind;
    Kind operator()(const SphereShape& /*sphere*/) const { return Kind::sphere; }
    Kind operator()(const CapsuleShape& /*capsule*/) const { return Kind::capsule; }
    Kind operator()(const BoxShape& /*box*/) const { return Kind::box; }
    Kind operator()(const CylinderShape& /*cylinder*/) const { return Kind::cylinder; }
    Kind operator()(const HullShape& /*hull*/) const { return Kind::hull; }
    Kind operator()(const MeshShape& /*mesh*/) const { return Kind::mesh; }
    template <class Other>
    Kind operator()(const Other& /*other*/) const {
        return Kind::half_space;  // stands for all that others cannot run into
    }
};

Expected<HullShape> find_hull_round(const SolidShape& shape) {
    if (const auto* hull = std::get_if<HullShape>(&shape)) {
        return *hull;
    }
    const auto vertices_B = (*find_mesh(shape))->vertices_B();
    return make_hull_shape({vertices_B.begin(), vertices_B.end()});
}

}  // namespace

Expected<ContactShape> make_contact_shape(const SolidShape& shape) {
    if (const auto valid = validate(shape); !valid) {
        return tl::make_unexpected(valid.error());
    }
    ContactShape made{.kind = std::visit(KindOf{}, shape)};
    if (made.kind == ContactShape::Kind::half_space) {
        return fail(
            "a body that pushes others is a height field or a distance function", {},
            "give it a sphere, capsule, box, cylinder, hull or closed mesh to be pushed by");
    }
    if (made.kind == ContactShape::Kind::hull || made.kind == ContactShape::Kind::mesh) {
        const auto hull = find_hull_round(shape);
        if (!hull) {
            return tl::make_unexpected(hull.error());
        }
        made.hull = make_faces(*hull->mesh);
        made.core = {.kind = ConvexCore::Kind::cloud, .cloud = made.hull->vertices_B};
    } else {
        made.core = make_convex_solid(shape).core;
    }
    made.bounding_radius_m = made.core.bounding_radius_m();
    return made;
}

ContactShape make_half_space() noexcept {
    return {};
}

void find_feature(const ContactShape& shape, const Vector3& direction_B,
                  SupportFeature& feature) noexcept {
    feature.face = -1;
    switch (shape.kind) {
        case ContactShape::Kind::box:
            return write_box_face(shape.core.half_m, find_box_face(direction_B), feature);
        case ContactShape::Kind::cylinder:
            return write_cylinder(shape.core.half_m, direction_B, feature);
        case ContactShape::Kind::capsule:
            return write_capsule(shape.core.half_m.y(), direction_B.y(), feature);
        case ContactShape::Kind::hull:
        case ContactShape::Kind::mesh:
            return write_hull_face(*shape.hull, find_hull_face(*shape.hull, direction_B), feature);
        default:
            feature.corners_B[0] = Vector3::Zero();
            feature.count = 1;
    }
}

AlignedFace find_aligned_face(const ContactShape& shape, const Vector3& direction_B) noexcept {
    std::int32_t face = -1;
    switch (shape.kind) {
        case ContactShape::Kind::box:
            face = find_box_face(direction_B);
            break;
        case ContactShape::Kind::cylinder:
            face = direction_B.y() < 0.0 ? 1 : 0;
            break;
        case ContactShape::Kind::hull:
        case ContactShape::Kind::mesh:
            face = find_hull_face(*shape.hull, direction_B);
            break;
        default:
            break;
    }
    return {find_face_normal(shape, face), face};
}

Vector3 find_face_normal(const ContactShape& shape, std::int32_t face) noexcept {
    const bool is_box = shape.kind == ContactShape::Kind::box && face < 6;
    if (face >= 0 && is_box) {
        return box_normal(face);
    }
    if (face >= 0 && shape.kind == ContactShape::Kind::cylinder && face < 2) {
        return box_normal(2 + face);
    }
    const bool has_hull = shape.hull != nullptr;
    if (face >= 0 && has_hull && static_cast<std::size_t>(face) < shape.hull->faces.size()) {
        return shape.hull->faces[static_cast<std::size_t>(face)].normal_B;
    }
    return Vector3::Zero();
}

}  // namespace fulcrum
