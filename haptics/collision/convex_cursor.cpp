#include "haptics/collision/convex_cursor.h"

#include <algorithm>
#include <array>

namespace fulcrum {

namespace {

// How much of a cursor's least half size its corners are rounded by.
constexpr double kRounded = 1.0e-3;
// Planes that a cursor may rest on at once.
constexpr std::size_t kMostFloors = 4;

using Kind = ConvexCore::Kind;

struct MakeCore {
    ConvexBody operator()(const SphereShape& sphere) const {
        return {{.kind = Kind::point, .radius_m = sphere.radius_m}};
    }
    ConvexBody operator()(const BoxShape& box) const {
        return {{.kind = Kind::box, .half_m = box.half_size_m}};
    }
    ConvexBody operator()(const CapsuleShape& capsule) const {
        return {{.kind = Kind::segment,
                 .half_m = capsule.half_length_m * Vector3::UnitY(),
                 .radius_m = capsule.radius_m}};
    }
    ConvexBody operator()(const CylinderShape& cylinder) const {
        return {
            {.kind = Kind::cylinder, .half_m = {cylinder.radius_m, cylinder.half_height_m, 0.0}}};
    }
    ConvexBody operator()(const HullShape& hull) const {
        auto points = std::make_shared<std::vector<Vector3>>();
        for (std::int32_t i = 0; i < hull.mesh->n_triangles(); ++i) {
            for (const std::int32_t corner : hull.mesh->corners(i)) {
                points->push_back(hull.mesh->vertex_B(corner));
            }
        }
        const auto is_before = [](const Vector3& a, const Vector3& b) {
            return std::ranges::lexicographical_compare(a, b);
        };
        std::ranges::sort(*points, is_before);
        points->erase(std::unique(points->begin(), points->end()), points->end());
        points->shrink_to_fit();
        ConvexBody body{{.kind = Kind::cloud, .cloud = *points}, points};
        return body;
    }
    template <class Other>
    ConvexBody operator()(const Other& /*no convex shape*/) const {
        return {};
    }
};

double least_half_m(const ConvexCore& core) {
    switch (core.kind) {
        case Kind::box:
            return core.half_m.minCoeff();
        case Kind::cylinder:
            return std::min(core.half_m.x(), core.half_m.y());
        default:
            return core.bounding_radius_m();
    }
}

// Where cores overlap no direction is known: out towards the cursor's middle, by all of its size.
Gap to_gap(const ConvexGap& apart, double radii_m, double size_m) noexcept {
    const double depth_m = apart.gap_m > 0.0 ? 0.0 : size_m;
    return {.normal_B = apart.normal, .gap_m = apart.gap_m - radii_m - depth_m};
}

// Room for the next ways.
Box find_wider(const Box& box, double margin_m) noexcept {
    const Vector3 margin = Vector3::Constant(margin_m);
    return {box.lower - margin, box.upper + margin};
}

Vector3 or_up(const Vector3& v) noexcept {
    return v.squaredNorm() > 0.0 ? v : Vector3(Vector3::UnitY());
}

}  // namespace

ConvexBody make_convex_solid(const SolidShape& shape) {
    return std::visit(MakeCore{}, shape);
}

ConvexBody make_convex_cursor(const SolidShape& shape) {
    ConvexBody body = make_convex_solid(shape);
    if (body.core.radius_m > 0.0) {
        return body;
    }
    const double rounded_m = kRounded * least_half_m(body.core);
    if (body.core.kind == Kind::box) {
        body.core.half_m -= Vector3::Constant(rounded_m);
    } else if (body.core.kind == Kind::cylinder) {
        body.core.half_m -= Vector3(rounded_m, rounded_m, 0.0);
    }
    body.core.radius_m = rounded_m;
    return body;
}

TurnedCursor::TurnedCursor(ConvexBody body)
    : body_(std::move(body)), bounding_radius_m_(body_.core.bounding_radius_m()) {
    turn(Matrix3::Identity());
}

void TurnedCursor::turn(const Matrix3& turn_WB) noexcept {
    turn_WB_ = turn_WB;
    for (int axis = 0; axis < 3; ++axis) {
        extent_B_.lower[axis] = find_support(-Vector3::Unit(axis))[axis];
        extent_B_.upper[axis] = find_support(Vector3::Unit(axis))[axis];
    }
}

Box TurnedCursor::find_swept_box(const Vector3& from_B, const Vector3& to_B,
                                 double margin_m) const noexcept {
    const Vector3 margin = Vector3::Constant(radius_m() + margin_m);
    return {from_B.cwiseMin(to_B) + extent_B_.lower - margin,
            from_B.cwiseMax(to_B) + extent_B_.upper + margin};
}

ConvexObstacle::ConvexObstacle(ConvexBody solid, ConvexBody cursor)
    : solid_(std::move(solid)),
      cursor_(std::move(cursor)),
      solid_radius_m_(solid_.core.bounding_radius_m()) {}

CastHit ConvexObstacle::cast(const CastQuestion& question) noexcept {
    return {cast_convex(question, [this](const Vector3& at_B) { return find_gap(0, at_B); }), 0};
}

Gap ConvexObstacle::find_gap(std::int32_t /*feature*/, const Vector3& at_B) const noexcept {
    const ConvexGap apart = find_convex_gap(or_up(at_B), [&](const Vector3& direction) noexcept {
        return Vector3(at_B + cursor_.find_support(direction) -
                       solid_.core.find_support(-direction));
    });
    return to_gap(apart, cursor_.radius_m() + solid_.core.radius_m, cursor_.bounding_radius_m());
}

std::int32_t ConvexObstacle::find_nearest(const Vector3& at_B, double level_m) const noexcept {
    return find_gap(0, at_B).gap_m < level_m ? 0 : -1;
}

double ConvexObstacle::radius_m() const noexcept {
    return solid_radius_m_ + cursor_.bounding_radius_m();
}

double ConvexObstacle::clearance_m() const noexcept {
    return kExactClearance * std::max(solid_radius_m_, cursor_.bounding_radius_m());
}

ConvexMeshObstacle::ConvexMeshObstacle(std::shared_ptr<const CollisionMesh> mesh, ConvexBody cursor)
    : mesh_(std::move(mesh)), cursor_(std::move(cursor)) {}

Gap ConvexMeshObstacle::find_gap(const TriangleForGap& triangle,
                                 const Vector3& at_B) const noexcept {
    const std::array<Vector3, 3> corners{triangle.a, triangle.a + triangle.ab,
                                         triangle.a + triangle.ac};
    // From the side of the triangle on which the cursor's middle is.
    const double side = triangle.normal.dot(at_B - triangle.a) < 0.0 ? -1.0 : 1.0;
    const ConvexGap apart =
        find_convex_gap(side * triangle.normal, [&](const Vector3& direction) noexcept {
            const Vector3& corner = *std::ranges::min_element(
                corners, {}, [&](const Vector3& c) { return direction.dot(c); });
            return Vector3(at_B + cursor_.find_support(direction) - corner);
        });
    if (!(apart.gap_m > 0.0)) {
        return to_gap({side * triangle.normal, 0.0}, cursor_.radius_m(),
                      cursor_.bounding_radius_m());
    }
    return to_gap(apart, cursor_.radius_m(), 0.0);
}

double ConvexMeshObstacle::find_lowest_m(const Vector3& direction,
                                         const CastQuestion& question) const noexcept {
    return std::min(direction.dot(question.from_B), direction.dot(question.to_B)) +
           direction.dot(cursor_.find_support(-direction)) - cursor_.radius_m() - question.level_m;
}

// Does the triangle's own plane, or a floor, keep it off the way?
bool ConvexMeshObstacle::is_free(const TriangleForGap& triangle, const CastQuestion& question,
                                 std::span<const Floor> floors) const noexcept {
    const double side = triangle.normal.dot(question.from_B - triangle.a) < 0.0 ? -1.0 : 1.0;
    const Vector3 own = side * triangle.normal;
    return triangle.highest_along(own) <= find_lowest_m(own, question) ||
           std::ranges::any_of(floors, [&](const Floor& floor) noexcept {
               return triangle.highest_along(floor.normal_B) <= floor.height_m;
           });
}

CastHit ConvexMeshObstacle::cast(const CastQuestion& question) noexcept {
    std::array<Floor, kMostFloors> floors;
    const std::size_t n_floors = std::min(question.normals_B.size(), kMostFloors);
    for (std::size_t i = 0; i < n_floors; ++i) {
        floors[i] = {question.normals_B[i], find_lowest_m(question.normals_B[i], question)};
    }
    const std::span<const Floor> given(floors.data(), n_floors);
    CastHit nearest;
    const auto ask = [&](std::int32_t index) noexcept {
        const TriangleForGap triangle = prepare_for_gap(*mesh_, index);
        if (is_free(triangle, question, given)) {
            return;
        }
        const double t = cast_convex(
            question, [&](const Vector3& at_B) noexcept { return find_gap(triangle, at_B); });
        if (t < nearest.t || (t == nearest.t && t <= 1.0 && index < nearest.feature)) {
            nearest = {t, index};
        }
    };
    const Box swept = cursor_.find_swept_box(question.from_B, question.to_B, question.level_m);
    if (near_.covers(swept) || near_.collect(*mesh_, find_wider(swept, question.reach_m))) {
        near_.for_each_in_box(swept, given, ask);
    } else {
        mesh_->tree().for_each_in_box(swept, ask);
    }
    return nearest;
}

Gap ConvexMeshObstacle::find_gap(std::int32_t feature, const Vector3& at_B) const noexcept {
    return find_gap(prepare_for_gap(*mesh_, feature), at_B);
}

std::int32_t ConvexMeshObstacle::find_nearest(const Vector3& at_B, double level_m) const noexcept {
    std::int32_t nearest = -1;
    double least_m = level_m;
    mesh_->tree().for_each_in_box(cursor_.find_swept_box(at_B, at_B, level_m),
                                  [&](std::int32_t triangle) noexcept {
                                      const double gap_m = find_gap(triangle, at_B).gap_m;
                                      if (gap_m < least_m) {
                                          least_m = gap_m;
                                          nearest = triangle;
                                      }
                                  });
    return nearest;
}

double ConvexMeshObstacle::radius_m() const noexcept {
    return mesh_->radius_m() + cursor_.bounding_radius_m();
}

double ConvexMeshObstacle::clearance_m() const noexcept {
    return kExactClearance * std::max(mesh_->radius_m(), cursor_.bounding_radius_m());
}

}  // namespace fulcrum
