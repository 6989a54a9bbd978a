#include "runtime/app/lesson_bodies.h"

namespace fulcrum::runtime {

std::vector<WorldCommand> place_at_first(const LessonDescription& lesson) {
    std::vector<WorldCommand> commands;
    const auto& bodies = lesson.bodies;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (bodies[i].visible || bodies[i].solid) {
            WorldCommand place;
            place.kind = WorldCommand::Kind::place;
            place.body = static_cast<std::int32_t>(i);
            place.position_W = bodies[i].position_W;
            commands.push_back(place);
        }
    }
    return commands;
}

std::optional<Vector3> NearestThing::look(const LessonDescription& lesson,
                                          const WorldSnapshot* world, const Vector3& hand_W) {
    constexpr double kStays = 0.7;  // another is nearer by so much
    const auto& bodies = lesson.bodies;
    std::optional<Vector3> nearest_W;
    double nearest_m = 0.0;
    std::size_t seen = kMaxBodies;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (!bodies[i].solid || (world != nullptr && world->bodies[i].where == BodyWhere::hidden)) {
            continue;
        }
        const Vector3 at_W =
            world == nullptr ? bodies[i].position_W : world->bodies[i].pose_W.position;
        const double away_m = (i == looked_at_ ? kStays : 1.0) * (at_W - hand_W).norm();
        if (!nearest_W || away_m < nearest_m) {
            nearest_W = at_W;
            nearest_m = away_m;
            seen = i;
        }
    }
    looked_at_ = seen;
    return nearest_W;
}

}  // namespace fulcrum::runtime
