#include "haptics/point/make_obstacle.h"

#include "haptics/collision/convex_cursor.h"
#include "haptics/collision/convex_mesh_obstacle.h"
#include "haptics/collision/distance_obstacle.h"
#include "haptics/collision/mesh_obstacle.h"
#include "haptics/collision/shape_obstacle.h"

namespace fulcrum {
namespace {

double ball_radius_m(const CursorShape& cursor) {
    const auto* ball = std::get_if<SphereShape>(&cursor);
    return ball != nullptr ? ball->radius_m : 0.0;
}

// An obstacle for a ball, by the solid's shape.
struct MakeForBall {
    double radius_m;

    std::unique_ptr<Obstacle> operator()(const MeshShape& mesh) const {
        return std::make_unique<MeshObstacle>(mesh, radius_m);
    }
    std::unique_ptr<Obstacle> operator()(const HullShape& hull) const { return (*this)(hull.mesh); }
    std::unique_ptr<Obstacle> operator()(const HeightFieldShape& field) const {
        return (*this)(field.mesh);
    }
    std::unique_ptr<Obstacle> operator()(const DistanceShape& shape) const {
        return std::make_unique<DistanceObstacle>(shape.function, radius_m);
    }
    template <class Shape>
    std::unique_ptr<Obstacle> operator()(const Shape& shape) const {
        return std::make_unique<ShapeObstacle<Shape>>(shape, radius_m);
    }
};

// The same for a convex cursor. There is none against a distance function.
struct MakeForConvex {
    ConvexBody cursor;

    std::unique_ptr<Obstacle> operator()(const MeshShape& mesh) const {
        return std::make_unique<ConvexMeshObstacle>(mesh, cursor);
    }
    std::unique_ptr<Obstacle> operator()(const HeightFieldShape& field) const {
        return (*this)(field.mesh);
    }
    std::unique_ptr<Obstacle> operator()(const HullShape& hull) const { return (*this)(hull.mesh); }
    template <class Shape>
    std::unique_ptr<Obstacle> operator()(const Shape& shape) const {
        return std::make_unique<ConvexObstacle>(make_convex_solid(SolidShape(shape)), cursor);
    }
};

std::unique_ptr<Obstacle> make_obstacle(const CursorShape& cursor, const SolidShape& solid) {
    const std::optional<SolidShape> body = to_solid_shape(cursor);
    if (is_round(cursor) || !body) {
        return std::visit(MakeForBall{ball_radius_m(cursor)}, solid);
    }
    return std::visit(MakeForConvex{make_convex_cursor(*body)}, solid);
}

}  // namespace

std::optional<SolidShape> to_solid_shape(const CursorShape& cursor) {
    return std::visit(
        [](const auto& shape) -> std::optional<SolidShape> {
            if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, std::monostate>) {
                return std::nullopt;
            } else {
                return SolidShape(shape);
            }
        },
        cursor);
}

Expected<void> validate_pair(const CursorShape& cursor, const SolidShape& shape) {
    if (!is_round(cursor) && std::holds_alternative<DistanceShape>(shape)) {
        return fail("a distance function is touched by a point or a sphere alone", {},
                    "take such a cursor, or make the body a mesh");
    }
    return {};
}

MovingObstacle make_moving_obstacle(const CursorShape& cursor, const SolidPlan& solid,
                                    std::int32_t index) {
    const auto* mesh = find_mesh(solid.shape);
    return {make_obstacle(cursor, solid.shape), index,        solid.initial_pose_W, solid.lets_out,
            mesh != nullptr ? *mesh : nullptr,  solid.shape_B};
}

std::vector<MovingObstacle> make_obstacles(const CursorShape& cursor,
                                           const std::vector<SolidPlan>& solids) {
    std::vector<MovingObstacle> obstacles;
    obstacles.reserve(solids.size());
    for (const SolidPlan& solid : solids) {
        obstacles.push_back(
            make_moving_obstacle(cursor, solid, static_cast<std::int32_t>(obstacles.size())));
    }
    return obstacles;
}

}  // namespace fulcrum
