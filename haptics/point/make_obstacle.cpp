#include "haptics/point/make_obstacle.h"

#include "haptics/collision/distance_obstacle.h"
#include "haptics/collision/mesh_obstacle.h"
#include "haptics/collision/shape_obstacle.h"

namespace fulcrum {
namespace {

bool is_ball(const CursorShape& cursor) {
    return std::holds_alternative<std::monostate>(cursor) ||
           std::holds_alternative<SphereShape>(cursor);
}

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

}  // namespace

Expected<void> validate_pair(const CursorShape& cursor, const SolidShape& /*shape*/) {
    if (!is_ball(cursor)) {
        return fail("this cursor is no ball", {}, "take a sphere or a point");
    }
    return {};
}

std::vector<MovingObstacle> make_obstacles(const CursorShape& cursor,
                                           const std::vector<SolidPlan>& solids) {
    std::vector<MovingObstacle> obstacles;
    obstacles.reserve(solids.size());
    for (const SolidPlan& solid : solids) {
        obstacles.emplace_back(std::visit(MakeForBall{ball_radius_m(cursor)}, solid.shape),
                               static_cast<std::int32_t>(obstacles.size()), solid.initial_pose_W);
    }
    return obstacles;
}

}  // namespace fulcrum
