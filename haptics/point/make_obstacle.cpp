#include "haptics/point/make_obstacle.h"

#include "haptics/collision/mesh_obstacle.h"

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

}  // namespace

Expected<void> validate_pair(const CursorShape& cursor, const SolidShape& shape) {
    if (!is_ball(cursor)) {
        return fail("this cursor is no ball", {}, "take a sphere or a point");
    }
    if (!std::holds_alternative<MeshShape>(shape)) {
        return fail("it is no mesh", {}, "make it one");
    }
    return {};
}

std::vector<MovingObstacle> make_obstacles(const CursorShape& cursor,
                                           const std::vector<SolidPlan>& solids) {
    std::vector<MovingObstacle> obstacles;
    obstacles.reserve(solids.size());
    for (const SolidPlan& solid : solids) {
        obstacles.emplace_back(
            std::make_unique<MeshObstacle>(std::get<MeshShape>(solid.shape), ball_radius_m(cursor)),
            static_cast<std::int32_t>(obstacles.size()), solid.initial_pose_W);
    }
    return obstacles;
}

}  // namespace fulcrum
